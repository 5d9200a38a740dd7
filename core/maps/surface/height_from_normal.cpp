// Integration of slopes in the frequency domain.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/surface/height_from_normal.h"
#include "core/maps/float_image.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fftw3.h>
#include <glm/vec2.hpp>
#include <memory>
#include <mutex>
#include <numbers>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

using Complex = std::complex<float>;
using Plan = std::shared_ptr<fftwf_plan_s>;

// FFTW plans one at a time; plans run from any thread.
std::mutex& planning()
{
    static std::mutex mutex;
    return mutex;
}
template <class Make> Plan planned(Make make)
{
    const std::lock_guard lock(planning());
    return Plan(make(), [](fftwf_plan plan) {
        const std::lock_guard again(planning());
        fftwf_destroy_plan(plan);
    });
}
Plan realPlan(int size, fftw_r2r_kind kind)
{
    std::vector<float> line(static_cast<std::size_t>(size));
    return planned([&] { return fftwf_plan_r2r_1d(size, line.data(), line.data(), kind, FFTW_ESTIMATE | FFTW_UNALIGNED); });
}
Plan complexPlan(int size, int sign)
{
    std::vector<Complex> line(static_cast<std::size_t>(size));
    const auto data = reinterpret_cast<fftwf_complex*>(line.data());
    return planned([&] { return fftwf_plan_dft_1d(size, data, data, sign, FFTW_ESTIMATE | FFTW_UNALIGNED); });
}
void run(const Plan& plan, float* line)
{
    fftwf_execute_r2r(plan.get(), line, line);
}
void run(const Plan& plan, Complex* line)
{
    fftwf_execute_dft(plan.get(), reinterpret_cast<fftwf_complex*>(line), reinterpret_cast<fftwf_complex*>(line));
}

template <class Row> void eachRow(int height, const Progress& progress, Row row)
{
    tbb::parallel_for(0, height, [&](int y) {
        if (!progress.cancelled())
            row(y);
    });
}

// Transforms the rows by one plan and the columns by the other, in place.
template <class T>
void transform(std::vector<T>& data, int width, int height, const Plan& alongRow, const Plan& alongColumn, const Progress& progress)
{
    eachRow(height, progress, [&](int y) { run(alongRow, data.data() + std::size_t(y) * std::size_t(width)); });
    constexpr int kBlock = 8; // columns copied together
    tbb::parallel_for(0, (width + kBlock - 1) / kBlock, [&](int block) {
        if (progress.cancelled())
            return;
        const int first = block * kBlock, count = std::min(kBlock, width - first);
        std::vector<T> lines(std::size_t(count) * std::size_t(height));
        const auto at = [&](int x, int y) -> T& { return data[std::size_t(y) * std::size_t(width) + std::size_t(first + x)]; };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < count; ++x)
                lines[std::size_t(x) * std::size_t(height) + std::size_t(y)] = at(x, y);
        for (int x = 0; x < count; ++x)
            run(alongColumn, lines.data() + std::size_t(x) * std::size_t(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < count; ++x)
                at(x, y) = lines[std::size_t(x) * std::size_t(height) + std::size_t(y)];
    });
}

// What a central difference makes of a wave of `angle` per texel in [0, pi]: its sine; held at 1 beyond a quarter of the waves.
float differenceOf(double angle, int size)
{
    return float(double(size) * (angle < std::numbers::pi / 2. ? std::sin(angle) : 1.));
}
float signedDifference(int k, int size)
{
    const double angle = 2. * std::numbers::pi * k / size;
    if (2 * k == size)
        return 0.f; // the alternating wave has no sign, and no central difference
    return 2 * k < size ? differenceOf(angle, size) : -differenceOf(2. * std::numbers::pi - angle, size);
}

// dh/du and dh/dv at a texel, per tile.
glm::vec2 slopeOf(const Image& normals, int x, int y)
{
    // No whole number stands for exactly 0: both codes next to the middle do (those after them lie 3 steps away).
    const float level = normals.type == PixelType::U8 ? 1.5f / 255.f : normals.type == PixelType::U16 ? 1.5f / 65535.f : 0.f;
    const auto component = [&](int c) { return 2.f * normals.value(x, y, c) - 1.f; };
    const auto sideways = [&](int c) { return std::abs(component(c)) < level ? 0.f : component(c); };
    const float nx = sideways(0), ny = sideways(1), nz = component(2);
    if (!std::isfinite(nx) || !std::isfinite(ny) || !std::isfinite(nz))
        return glm::vec2(0.f);
    const auto slope = [&](float n) { return std::clamp(n / std::max(nz, 1e-6f), -32.f, 32.f); };
    return {-slope(nx), slope(ny)};
}

// Repeat: one complex transform of u-slope + i v-slope; waves k and -k untangle both.
std::vector<float> integratedRepeating(const Image& normals, const Progress& progress)
{
    const int width = normals.width, height = normals.height;
    std::vector<Complex> waves(normals.texelCount());
    const auto index = [&](int x, int y) { return std::size_t(y) * std::size_t(width) + std::size_t(x); };
    eachRow(height, progress, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec2 slope = slopeOf(normals, x, y);
            waves[index(x, y)] = {slope.x, slope.y};
        }
    });
    transform(waves, width, height, complexPlan(width, FFTW_FORWARD), complexPlan(height, FFTW_FORWARD), progress);
    const auto surface = [&](Complex wave, Complex mirror, float du, float dv) {
        const Complex p = (wave + std::conj(mirror)) * 0.5f, q = (wave - std::conj(mirror)) * Complex(0.f, -0.5f);
        const float squared = du * du + dv * dv;
        return squared > 0.f ? (p * du + q * dv) * Complex(0.f, -1.f) / squared : Complex();
    };
    eachRow(height / 2 + 1, progress, [&](int y) { // and row height - y
        for (int x = 0; x < width; ++x) {
            const std::size_t here = index(x, y), there = index((width - x) % width, (height - y) % height);
            if (here > there)
                continue;
            const Complex wave = waves[here], mirror = waves[there];
            const float du = signedDifference(x, width), dv = signedDifference(y, height);
            waves[there] = surface(mirror, wave, -du, -dv);
            waves[here] = surface(wave, mirror, du, dv);
        }
    });
    transform(waves, width, height, complexPlan(width, FFTW_BACKWARD), complexPlan(height, FFTW_BACKWARD), progress);
    std::vector<float> heights(waves.size());
    for (std::size_t i = 0; i < waves.size(); ++i)
        heights[i] = waves[i].real() / float(waves.size());
    return heights;
}

// Clamp: heights are cosines about the borders, so slopes along an axis are sines along it. FFTW counts sines from 1.
std::vector<float> integratedClamped(const Image& normals, const Progress& progress)
{
    const int width = normals.width, height = normals.height;
    std::vector<float> p(normals.texelCount()), q(p.size()), heights(p.size());
    const auto index = [&](int x, int y) { return std::size_t(y) * std::size_t(width) + std::size_t(x); };
    eachRow(height, progress, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec2 slope = slopeOf(normals, x, y);
            p[index(x, y)] = slope.x;
            q[index(x, y)] = slope.y;
        }
    });
    transform(p, width, height, realPlan(width, FFTW_RODFT10), realPlan(height, FFTW_REDFT10), progress);
    transform(q, width, height, realPlan(width, FFTW_REDFT10), realPlan(height, FFTW_RODFT10), progress);
    eachRow(height, progress, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const float du = differenceOf(std::numbers::pi * x / width, width), dv = differenceOf(std::numbers::pi * y / height, height);
            const float sum = (x > 0 ? du * p[index(x - 1, y)] : 0.f) + (y > 0 ? dv * q[index(x, y - 1)] : 0.f);
            const float squared = du * du + dv * dv;
            heights[index(x, y)] = squared > 0.f ? -sum / squared : 0.f;
        }
    });
    transform(heights, width, height, realPlan(width, FFTW_REDFT01), realPlan(height, FFTW_REDFT01), progress);
    for (float& h : heights)
        h /= 4.f * float(heights.size());
    return heights;
}

} // namespace

HeightField heightFromNormals(const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress)
{
    std::vector<float> heights = wrap == Wrap::Repeat ? integratedRepeating(normals, progress) : integratedClamped(normals, progress);
    const auto [low, high] = std::ranges::minmax(heights);
    // Less than the rounding of 8-bit normals adds up to is flat.
    depthInTiles = high - low > 1e-6f && !progress.cancelled() ? high - low : 0.f;
    for (float& h : heights)
        h = depthInTiles > 0.f ? std::clamp((h - low) / depthInTiles, 0.f, 1.f) : 1.f;
    progress.at(1.f);
    return {normals.width, normals.height, std::move(heights), wrap, 32};
}

BakedMap bakeHeightFromNormals(const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress)
{
    const HeightField field = heightFromNormals(normals, wrap, depthInTiles, progress);
    BakedMap map = oneLevel(floatImage(field.width(), field.height(), 1));
    std::ranges::copy(field.texels(), floats(map.levels[0]).begin());
    return map;
}

} // namespace relievo
