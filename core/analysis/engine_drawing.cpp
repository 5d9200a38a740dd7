// Rays on the height field, searched as the engine does and exactly.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/engine_drawing.h"
#include "core/analysis/ray_sets.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace relievo {

namespace {

// Evenly over the tile and all directions: Roberts' sequence in three dimensions, by powers of the root of x^4 = x + 1.
std::vector<SearchRay> evenRays(double angle, double depth)
{
    constexpr int kRays = 4096;
    constexpr double kRoot = 1.2207440846057596;
    const auto part = [](int i, double step) { return std::fmod(0.5 + i * step, 1.); };
    std::vector<SearchRay> rays;
    rays.reserve(kRays);
    for (int i = 0; i < kRays; ++i)
        rays.push_back(rayAt({part(i, 1. / kRoot), part(i, 1. / (kRoot * kRoot))}, angle,
            2. * std::numbers::pi * part(i, 1. / (kRoot * kRoot * kRoot)), depth));
    return rays;
}

struct Factor {
    double value, weight;
};
// Half of the weight lies below it, half above.
double median(std::vector<Factor> factors)
{
    std::ranges::sort(factors, {}, &Factor::value);
    double half = 0.;
    for (const Factor& factor : factors)
        half += 0.5 * factor.weight;
    for (const Factor& factor : factors)
        if ((half -= factor.weight) <= 0.)
            return factor.value;
    return 1.; // there is none
}

std::string text(const char* format, double value)
{
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

std::string shareText(double share)
{
    return share < 5e-4 ? "0" : text(share < 0.01 ? "%.3f" : "%.2f", share);
}

} // namespace

Expected<EngineDrawing> drawnBy(
    const TechniqueRow& technique, const Parameters& parameters, const HeightField& field, double angle, const Progress& progress)
{
    const auto rays = evenRays(angle, double(parameters.depth));
    const auto drawn = traceRays(technique.key, parameters, &field, atMesh(technique, rays), progress.part(0.f, 0.5f));
    if (!drawn)
        return tl::unexpected(drawn.error());
    const auto exact = traceRays("reference", parameters, SearchMaps{field, {}}, rays, progress.part(0.5f, 1.f));
    if (!exact)
        return tl::unexpected(exact.error());
    const double mesh = double(technique.meshDepth());
    double errors = 0., count = 0.;
    std::vector<Factor> factors;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!(*exact)[i].found)
            continue;
        const double t = (*drawn)[i].found ? (*drawn)[i].t : 1., wanted = (*exact)[i].t - mesh;
        errors += std::abs(t - mesh - wanted), count += 1.;
        if (std::abs(wanted) > 1e-5)
            factors.push_back({(t - mesh) / wanted, std::abs(wanted)});
    }
    EngineDrawing drawing{.share = median(std::move(factors)), .meanError = errors / std::max(count, 1.)};
    if (technique.isEngine() && !technique.displaces)
        drawing.raised = double(parameters.midlevel - technique.zero);
    return drawing;
}

std::string sentence(const TechniqueRow& technique, const EngineDrawing& drawing, double angle)
{
    const double less = std::round(100. * (1. - drawing.share));
    std::string told = std::string(technique.isEngine() ? technique.engine : technique.label) + " will draw ";
    told += less == 0. ? "the full depth" : text("%.0f", std::abs(less)) + (less > 0. ? " % less depth" : " % more depth");
    told += " at " + text("%g", angle) + " degrees; mean error " + shareText(drawing.meanError) + " of the depth";
    if (std::abs(drawing.raised) >= 0.005)
        told += "; all of it " + shareText(std::abs(drawing.raised)) + " of the depth too " + (drawing.raised > 0. ? "high" : "low");
    return told;
}

} // namespace relievo
