// The steps of a search are those of the search: they chain, add up to its fetches, end at its hit, and tell what lies there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/ray_inspection.h"
#include "core/analysis/ray_sets.h"
#include "core/image/samples/hard_cases.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/shader_files.h"
#include "core/state/techniques.h"
#include "tests/core/image/source_support.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

using namespace relievo;
using namespace relievo::test;

namespace {
HeightField peak(float at, float width) // white within it, along u
{
    std::vector<float> heights(256 * 4);
    for (int i = 0; i < 256 * 4; ++i)
        heights[std::size_t(i)] = std::abs((float(i % 256) + 0.5f) / 256 - at) < 0.5f * width ? 1.f : 0.f;
    return {256, 4, heights, Wrap::Clamp, 8};
}
SearchMaps mapsOf(std::string_view technique, const Parameters& parameters, const HeightField& field)
{
    auto maps = searchMaps(technique, parameters, &field);
    EXPECT_TRUE(maps) << technique;
    return *maps;
}
RayInspection inspected(std::string_view technique, const Parameters& parameters, const HeightField& field, const SearchRay& ray)
{
    auto inspection = inspectRay(technique, parameters, mapsOf(technique, parameters, field), ray);
    EXPECT_TRUE(inspection) << technique;
    return *inspection;
}
} // namespace

TEST(RecordedSteps, ChainAddUpAndEndAtTheHitForEveryTechnique)
{
    Parameters parameters;
    parameters.leapSteps = 40;
    for (const char* source : {"sample:bricks@128", "sample:hard-needles@64", "sample:hard-noise@64", "sample:hard-near-flat@32"}) {
        const auto field = heightsOf(source);
        ASSERT_TRUE(field) << source;
        std::vector<SearchRay> rays = bandRays({0., 89.9}, 0.1, 60, 7);
        rays.push_back({{0.3, 0.4}, {0., 0.}, 1.}); // straight down
        for (const TechniqueRow& row : kTechniques) {
            if (row.file.empty() && row.key != "reference")
                continue;
            const SearchMaps maps = mapsOf(row.key, parameters, *field);
            const auto hits = traceRays(row.key, parameters, maps, rays);
            ASSERT_TRUE(hits);
            for (std::size_t r = 0; r < rays.size(); ++r) {
                const auto recorded = recordSearch(row.key, parameters, maps, rays[r]);
                ASSERT_TRUE(recorded);
                const SearchHit &hit = (*hits)[r], &again = recorded->hit;
                const std::string which = std::string(row.key) + ", " + source + ", ray " + std::to_string(r);
                EXPECT_EQ(hit.found, again.found) << which;
                EXPECT_EQ(hit.t, again.t) << which;
                EXPECT_EQ(hit.fetches, again.fetches) << which;
                int fetches = 0;
                double from = 0.;
                for (const SearchStep& step : recorded->steps) {
                    fetches += step.fetches;
                    EXPECT_GE(step.fetches, 0) << which;
                    if (step.kind != StepKind::Halving) {
                        EXPECT_EQ(step.from, from) << which;
                    }
                    from = step.to;
                    EXPECT_EQ(step.height, double(field->at(glm::vec2(step.uv)))) << which;
                }
                EXPECT_EQ(fetches, hit.fetches) << which;
                if (row.needsHeights()) {
                    ASSERT_FALSE(recorded->steps.empty()) << which;
                    EXPECT_EQ(recorded->steps.back().to, hit.t) << which;
                } else {
                    EXPECT_TRUE(recorded->steps.empty()) << which;
                }
            }
        }
    }
}

TEST(RecordedSteps, HalvingsLieInTheStepThatWentInside)
{
    const auto field = heightsOf("sample:bricks@128");
    ASSERT_TRUE(field);
    Parameters parameters;
    parameters.leapSteps = 40;
    int halvings = 0;
    for (const char* technique : {"relief", "relief-fixed", "cone", "cone-quad", "cone-relaxed", "cone-robust"})
        for (const SearchRay& ray : bandRays({0., 85.}, 0.1, 60, 3)) {
            const RayInspection inspection = inspected(technique, parameters, *field, ray);
            double low = 0., high = 1.;
            for (const SearchStep& step : inspection.steps) {
                if (step.kind == StepKind::Halving) {
                    EXPECT_GE(step.from, low - 1e-6) << technique;
                    EXPECT_LE(step.to, high + 1e-6) << technique;
                    if (&step != &inspection.steps.back()) {
                        EXPECT_NEAR(step.to - step.from, 0.5 * (high - low), 1e-6) << technique;
                    }
                    ++halvings;
                } else if (std::string_view(technique) == "cone-relaxed") { // halves all that it has come by
                    low = 0., high = step.to;
                    continue;
                }
                low = step.from, high = step.to;
            }
        }
    EXPECT_GT(halvings, 1000);
}

TEST(RecordedSteps, KindsAreThoseOfTheTechnique)
{
    const auto field = heightsOf("sample:bricks@128");
    ASSERT_TRUE(field);
    struct Row {
        const char* technique;
        std::vector<StepKind> kinds;
    };
    using enum StepKind;
    for (const Row& row :
        {Row{"steep", {Linear}}, Row{"pom", {Linear, Secant}}, Row{"relief", {Linear, Halving}}, Row{"parallax", {Offset}},
            Row{"sphere", {Ball}}, Row{"cone", {Cone, Halving}}, Row{"pyramid", {Box, Cell}}, Row{"cell-cone", {Box, Cone, Cell}},
            Row{"interval", {Linear, Secant}}, Row{"contact", {Linear}}, Row{"as-godot4", {Linear, Secant}}, Row{"reference", {Cell}}}) {
        std::set<StepKind> seen;
        for (const SearchRay& ray : bandRays({0., 85.}, 0.1, 100, 3))
            for (const SearchStep& step : inspected(row.technique, Parameters(), *field, ray).steps)
                seen.insert(step.kind);
        EXPECT_EQ(seen, std::set<StepKind>(row.kinds.begin(), row.kinds.end())) << row.technique;
    }
}

TEST(RecordedSteps, ProgramsHaveNoLinesForThem)
{
    int recorded = 0;
    for (const ShaderFile& file : embeddedShaders())
        recorded += int(file.text.find("    record") != std::string_view::npos);
    EXPECT_GT(recorded, 15);
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        const auto traced = traceProgram(row.key, embeddedReader());
        ASSERT_TRUE(traced) << row.key;
        EXPECT_EQ(traced->fragment.text.find("record"), std::string::npos) << row.key;
        for (const Dialect dialect : {Dialect::Desktop, Dialect::Es}) {
            const auto exported = meshProgram(exportedFeatures(Parameters(), row, {MapKind::Height}, dialect), embeddedReader());
            ASSERT_TRUE(exported) << row.key;
            EXPECT_EQ(exported->fragment.text.find("record"), std::string::npos) << row.key;
        }
    }
}

TEST(RayInspection, APeakThatWasSteppedOverIsMeasuredInSteps)
{
    Parameters parameters;
    parameters.minSteps = parameters.maxSteps = 10;
    const HeightField field = peak(0.55f, 0.04f); // the ray runs 1 tile, a step is 0.1 of it
    const SearchRay ray{{0., 0.5}, {1., 0.}, 0.1};
    const RayInspection steep = inspected("steep", parameters, field, ray);
    EXPECT_NEAR(steep.exact, 0.53, 0.005);
    EXPECT_FALSE(steep.hit.found && steep.hit.t < 0.9);
    EXPECT_NE(steep.verdict.find("stepped over a peak 0.4"), std::string::npos) << steep.verdict;
    const RayInspection exact = inspected("cell-cone", parameters, field, ray);
    EXPECT_TRUE(exact.verdict.starts_with("Right")) << exact.verdict;
    const RayInspection offset = inspected("parallax", parameters, field, ray);
    EXPECT_TRUE(offset.verdict.starts_with("It does not search")) << offset.verdict;
}

TEST(RayInspection, LightIsFollowedToThePoint)
{
    Parameters parameters;
    parameters.lightYaw = 90.f; // from +x, that is along u
    parameters.lightPitch = 30.f;
    parameters.depth = 0.2f;
    const HeightField field = peak(0.6f, 0.1f);
    const RayInspection down = inspected("pyramid", parameters, field, {{0.4, 0.5}, {0., 0.}, 1.});
    ASSERT_NEAR(down.hit.t, 1., 1e-6);
    const auto way = lightRayTo(down, parameters);
    ASSERT_TRUE(way);
    EXPECT_NEAR(way->duv.x, -0.2 / std::tan(30. * 3.14159265 / 180.), 1e-5);
    EXPECT_NEAR(way->duv.y, 0., 1e-6);
    const glm::dvec2 there = way->uv + way->end * way->duv;
    EXPECT_NEAR(there.x, down.hit.uv.x, 1e-6);
    parameters.lightPitch = -10.f;
    EXPECT_FALSE(lightRayTo(down, parameters));
}

TEST(RayInspection, JsonIsAsTheManualHasIt)
{
    const auto field = heightsOf("sample:bricks@128");
    ASSERT_TRUE(field);
    const RayInspection inspection = inspected("relief", Parameters(), *field, {{0.3, 0.4}, {0.1, 0.05}, 0.5});
    const auto json = nlohmann::json::parse(inspectionJson(inspection));
    EXPECT_EQ(json["technique"], "relief");
    EXPECT_EQ(json["ray"], (std::vector<double>{0.3, 0.4, 0.1, 0.05}));
    ASSERT_EQ(json["steps"].size(), inspection.steps.size());
    for (const auto& step : json["steps"])
        for (const char* key : {"kind", "from", "to", "uv", "height", "fetches"})
            EXPECT_TRUE(step.contains(key)) << key;
    EXPECT_EQ(json["hit"]["t"], inspection.hit.t);
    EXPECT_EQ(json["exact"]["t"], inspection.exact);
    EXPECT_FALSE(json["verdict"].get<std::string>().empty());
    const std::string csv = inspectionCsv(inspection);
    EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), inspection.steps.size() + 1);
}
