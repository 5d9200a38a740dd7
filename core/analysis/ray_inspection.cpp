// Judging one ray.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/ray_inspection.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include "core/trace/exact_search.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace relievo {
namespace {
constexpr double kUnseen = 1e-3; // of the depth: nothing that is seen
constexpr int kPeakSamples = 256; // of a step that leapt over something

std::string rounded(double value, int digits = 3)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

// The share of a step, from where the exact hit is on, that lies in the relief: how wide what was stepped over is.
double widthInside(const HeightField& field, const SearchRay& ray, double exact, const SearchStep& step)
{
    int inside = 0;
    for (int i = 0; i < kPeakSamples; ++i) {
        const double t = exact + (step.to - exact) * (i + 0.5) / kPeakSamples;
        if (1. - double(field.at(glm::vec2(ray.uv + t * ray.duv))) > t)
            break;
        ++inside;
    }
    return (step.to - exact) * inside / kPeakSamples / (step.to - step.from);
}

std::string_view nameOf(StepKind kind)
{
    switch (kind) {
    case StepKind::Cone:
        return "a cone";
    case StepKind::Box:
        return "a box";
    case StepKind::Ball:
        return "a ball";
    case StepKind::Cell:
        return "a cell";
    default:
        return "a step";
    }
}

// What was passed by: the first step over the exact hit, before any refinement.
std::string tooDeep(const RayInspection& ray, const HeightField& field)
{
    const std::string error = rounded(ray.hit.t - ray.exact) + " of the depth";
    for (const SearchStep& step : ray.steps) {
        if (step.kind == StepKind::Halving || step.kind == StepKind::Secant)
            break;
        if (step.from <= ray.exact && step.to > ray.exact && ray.hit.t >= step.to - 1e-6 && step.to - step.from > 0) {
            const double width = widthInside(field, ray.ray, ray.exact, step);
            if (1. - double(field.at(glm::vec2(ray.ray.uv + step.to * ray.ray.duv))) > step.to)
                return (step.kind == StepKind::Linear ? "It stepped over a peak " + rounded(width, 1) + " steps wide"
                                                      : "It leapt over a peak by " + std::string(nameOf(step.kind)) + ", "
                                   + rounded(width, 1) + " of which lay in the relief")
                    + ", and is too deep by " + error + ".";
        }
    }
    if (!ray.hit.found)
        return "It found nothing; the relief is hit " + error + " higher.";
    return "It stopped inside the relief, too deep by " + error + ".";
}

std::string verdictOf(const RayInspection& ray, const TechniqueRow& row, const Parameters& parameters, const HeightField& field)
{
    const double error = ray.hit.t - ray.exact;
    if (ray.hit.isUnfinished)
        return "It gave up before it knew the answer: the ray crosses too many texels.";
    if (!isFiniteInFloat(ray.ray))
        return "The ray is not finite.";
    const std::string missed = ray.hit.found || ray.exact >= 1. ? "" : " Nothing was found: it is a miss.";
    if (!row.searches)
        return row.needsHeights() ? "It does not search: it shifts the texture by the height above the entry, and is off by "
                + rounded(std::abs(error)) + " of the depth."
                                  : "It moves nothing: the relief is " + rounded(std::abs(error)) + " of the depth deeper here.";
    if (std::abs(error) <= kUnseen)
        return "Right: within " + rounded(std::abs(error)) + " of the depth." + missed;
    if (error > 0)
        return tooDeep(ray, field);
    const auto leaps
        = std::ranges::count_if(ray.steps, [](const SearchStep& s) { return s.kind == StepKind::Cone || s.kind == StepKind::Ball; });
    const std::string shortBy = rounded(-error) + " of the depth";
    if (leaps > parameters.leapSteps)
        return "Its " + std::to_string(parameters.leapSteps) + " leaps ran out above the relief, " + shortBy + " short.";
    const SearchStep& last = ray.steps.back();
    if (last.kind == StepKind::Secant)
        return "It takes the relief for straight within a step, and stops " + shortBy + " short.";
    return "It stops " + shortBy + " above the relief.";
}

// bias: of the depth, the part before the point that is not asked.
std::string shadowVerdict(const RayInspection& ray, double bias)
{
    const double end = ray.ray.end - bias;
    const bool hidden = ray.hit.found && ray.hit.t < end, isTrue = ray.exact >= end;
    const std::string where = hidden ? "The light is stopped at " + rounded(ray.hit.t) + " of the depth" : "The light comes through";
    return where
        + (hidden != isTrue ? ": right."
                : hidden    ? ", but nothing lies there."
                            : ", but it should be stopped at " + rounded(ray.exact) + ".");
}
} // namespace

Expected<RayInspection> inspectRay(std::string_view technique, const Parameters& parameters, const SearchMaps& maps, const SearchRay& ray)
{
    if (!maps.height)
        return failure(std::string(technique), "there is no height map to look into", "Add one");
    auto recorded = recordSearch(technique, parameters, maps, ray);
    if (!recorded)
        return tl::unexpected(recorded.error());
    RayInspection inspection{std::string(technique), ray, std::move(recorded->steps), recorded->hit, 1., {}};
    inspection.exact = isFinite(ray) ? std::min(ExactSearch(*maps.height).hit(ray).t, ray.end) : 1.;
    inspection.verdict = ray.end < 1. ? shadowVerdict(inspection, double(parameters.shadowBias))
                                      : verdictOf(inspection, *findTechnique(technique), parameters, *maps.height);
    return inspection;
}

std::optional<SearchRay> lightRayTo(const RayInspection& view, const Parameters& parameters)
{
    const SceneUniforms scene = sceneUniforms(parameters, {}, 1.f);
    const glm::dvec3 light(scene.lightDirection);
    if (light.y <= 1e-6 || view.hit.t <= 0.)
        return std::nullopt;
    const glm::dmat2 turn = glm::dmat2(scene.textureFromMesh) / double(parameters.tiling);
    const glm::dvec2 way = turn * glm::dvec2(light.x, light.z) * (double(parameters.depth) / light.y); // to the light, from floor to top
    return SearchRay{view.hit.uv + view.hit.t * way, -way, light.y, glm::dvec3(0.), view.hit.t};
}

std::string inspectionJson(const RayInspection& inspection)
{
    using Json = nlohmann::ordered_json;
    const SearchRay& ray = inspection.ray;
    Json steps = Json::array();
    for (const SearchStep& step : inspection.steps)
        steps.push_back({{"kind", wordOf(step.kind)}, {"from", step.from}, {"to", step.to}, {"uv", {step.uv.x, step.uv.y}},
            {"height", step.height}, {"fetches", step.fetches}});
    const Json json = {{"technique", inspection.technique}, {"ray", {ray.uv.x, ray.uv.y, ray.duv.x, ray.duv.y}}, {"steps", steps},
        {"hit", {{"found", inspection.hit.found}, {"t", inspection.hit.t}, {"fetches", inspection.hit.fetches}}},
        {"exact", {{"t", inspection.exact}}}, {"verdict", inspection.verdict}};
    return json.dump(1);
}

std::string inspectionCsv(const RayInspection& inspection)
{
    std::string text = "kind,from,to,u,v,height,fetches\n";
    char line[256];
    for (const SearchStep& step : inspection.steps) {
        std::snprintf(
            line, sizeof line, ",%.9g,%.9g,%.17g,%.17g,%.9g,%d\n", step.from, step.to, step.uv.x, step.uv.y, step.height, step.fetches);
        text += std::string(wordOf(step.kind)) + line;
    }
    return text;
}

} // namespace relievo
