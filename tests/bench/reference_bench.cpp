// Rays a second of the exact reference on hard fields, on one core and on all.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include <benchmark/benchmark.h>
#include <cmath>
#include <random>
#include <tbb/global_control.h>

using namespace relievo;

namespace {

enum Kind { Waves, Noise, Needles, Checkerboard, Flat };
constexpr const char* kNames[] = {"waves", "noise", "needles", "checkerboard", "flat"};
constexpr int kSize = 1024;

HeightField field(int kind)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    std::vector<float> heights;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            heights.push_back(kind == Waves ? 0.5f + 0.5f * std::sin(float(x) * 0.0368f) * std::cos(float(y) * 0.0491f)
                    : kind == Noise         ? unit(random)
                    : kind == Needles       ? (unit(random) < 0.002f ? 1.f : 0.f)
                    : kind == Checkerboard  ? float((x + y) % 2)
                                            : 0.5f);
    return {kSize, kSize, std::move(heights)};
}

std::vector<SearchRay> rays(double fromDegrees, double toDegrees)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0., 1.);
    std::vector<SearchRay> list;
    for (int i = 0; i < 20000; ++i) {
        const double angle = 6.2831853 * unit(random), theta = (fromDegrees + (toDegrees - fromDegrees) * unit(random)) * 3.14159265 / 180.;
        const double travel = 0.08 * std::tan(theta);
        list.push_back({{unit(random), unit(random)}, {travel * std::cos(angle), travel * std::sin(angle)}, std::cos(theta)});
    }
    return list;
}

void reference(benchmark::State& state)
{
    const HeightField heights = field(int(state.range(0)));
    const auto list = rays(double(state.range(1)), double(state.range(2)));
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::size_t(state.range(3)));
    for (auto _ : state)
        benchmark::DoNotOptimize(traceRays("reference", Parameters(), &heights, list));
    state.counters["rays"] = benchmark::Counter(double(state.iterations()) * double(list.size()), benchmark::Counter::kIsRate);
    state.SetLabel(kNames[state.range(0)]);
}

} // namespace

BENCHMARK(reference)
    ->ArgNames({"field", "from", "to", "cores"})
    ->ArgsProduct({{Waves, Noise, Needles, Checkerboard, Flat}, {0}, {60}, {1, 2}})
    ->ArgsProduct({{Waves, Noise, Needles, Checkerboard, Flat}, {80}, {88}, {1, 2}})
    ->UseRealTime();
BENCHMARK_MAIN();
