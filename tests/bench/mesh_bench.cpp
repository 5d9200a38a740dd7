// Relief on meshes against the displaced mesh: outline and depth for each kind of silhouettes; and what each switch costs.
// mesh_bench [DEPTH] [MESH...]; DEPTH: share of the mesh's longest side; a tile of the texture is a quarter of that side.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_time.h"
#include "render/mesh_errors.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace relievo;

namespace {

constexpr int kWidth = 1024, kHeight = 768;
constexpr float kTile = 0.25f; // share of the longest side
constexpr int kKinds = 4; // of silhouettes
constexpr float kViews[][2] = {{30.f, 35.f}, {120.f, 10.f}, {210.f, -20.f}, {300.f, 0.f}, {0.f, 60.f}}; // yaw, pitch

struct Scene {
    State state;
    Resources resources;
};

Expected<Scene> sceneOn(const std::string& mesh, float depth)
{
    State state = openSource("sample:cobblestones", State())->state;
    state.mesh = mesh;
    state.parameters.shadows = false;
    state.panes = {Pane{"cell-cone", {}}};
    auto resources = loadResources(state, {}, {});
    if (!resources)
        return tl::unexpected(resources.error());
    const glm::vec3 size = resources->mesh->boundsMax - resources->mesh->boundsMin;
    state.parameters.tiling = resources->mesh->metresPerUV / (kTile * std::max({size.x, size.y, size.z}));
    state.parameters.depth = depth / kTile;
    return Scene{state, std::move(*resources)};
}

int refuse(const Error& error)
{
    std::fprintf(stderr, "%s\n", message(error).c_str());
    return 1;
}

int measure(Renderer& renderer, const std::string& mesh, float depth)
{
    auto scene = sceneOn(mesh, depth);
    if (!scene)
        return refuse(scene.error());
    State& state = scene->state;
    double coverage[kKinds] = {}, depths[kKinds] = {}, invalid = 0.;
    Warnings warnings;
    for (const auto& view : kViews) {
        state.camera.yaw = view[0], state.camera.pitch = view[1];
        const auto exact = exactDistances(state, scene->resources, kWidth, kHeight, warnings);
        if (!exact)
            return refuse(exact.error());
        for (int silhouettes = 0; silhouettes < kKinds; ++silhouettes) {
            state.parameters.silhouettes = silhouettes;
            const auto errors = meshErrors(renderer, state, scene->resources, *exact, kWidth, kHeight);
            if (!errors)
                return refuse(errors.error());
            coverage[silhouettes] += errors->coverage / std::size(kViews);
            depths[silhouettes] += errors->depthRmse / std::size(kViews);
            invalid += errors->invalid;
        }
    }
    std::printf("| %s |", scene->resources.mesh->name.c_str());
    for (int kind = 0; kind < kKinds; ++kind)
        std::printf(" %.2f %% / %.1f px |", 100. * coverage[kind], depths[kind]);
    std::printf(" %.2f | %.2f |\n", coverage[2] / coverage[0], coverage[3] / coverage[0]);
    if (invalid > 0.)
        std::printf("%g pixels are no numbers\n", invalid);
    if (!warnings.empty()) // those of the other views say the same
        std::fprintf(stderr, "%s: %s\n", mesh.c_str(), warnings.front().text.c_str());
    return 0;
}

struct Switch {
    const char* name;
    void (*set)(Parameters&);
};
constexpr Switch kSwitches[] = {
    {"plain", [](Parameters&) {}},
    {"silhouettes, axes", [](Parameters& p) { p.silhouettes = 1; }},
    {"silhouettes, quadric", [](Parameters& p) { p.silhouettes = 2; }},
    {"silhouettes, prisms", [](Parameters& p) { p.silhouettes = 3; }},
    {"depth of the relief", [](Parameters& p) { p.depthOfHit = true; }},
    {"frames from derivatives", [](Parameters& p) { p.frames = 1; }},
    {"fade at edges", [](Parameters& p) { p.edgeFade = 0.3f; }},
    {"self-shadows", [](Parameters& p) { p.shadows = true; }},
    {"shadows between objects", [](Parameters& p) { p.objectShadows = true; }},
};

int cost(Renderer& renderer, const std::string& mesh, float depth)
{
    const auto scene = sceneOn(mesh, depth);
    if (!scene)
        return refuse(scene.error());
    std::vector<TimedFrame> frames;
    for (const Switch& each : kSwitches) {
        frames.push_back({scene->state, "shaded"});
        each.set(frames.back().state.parameters);
    }
    const auto times = frameTimes(renderer, scene->resources, frames, 800, 600, 9);
    if (!times)
        return refuse(times.error());
    std::printf("\nFrame of %s, shaded, ratio to plain:", mesh.c_str());
    for (std::size_t i = 1; i < times->size(); ++i)
        std::printf("%s %s %.2f", i > 1 ? "," : "", kSwitches[i].name, (*times)[i] / (*times)[0]);
    std::printf("\n");
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    const auto context = WindowlessContext::create();
    if (!context)
        return refuse(context.error());
    Renderer renderer;
    const float depth = argc > 1 ? float(std::atof(argv[1])) : 0.02f;
    std::vector<std::string> meshes(argv + std::min(argc, 2), argv + argc);
    if (meshes.empty())
        meshes = {"sphere", "torus", "cylinder", "plane", "box", "teapot"};
    std::printf("Depth %g of the longest side, %dx%d, %zu views\n"
                "| mesh | no silhouettes | axes | quadric | prisms | quadric / none | prisms / none |\n|---|---|---|---|---|---|---|\n",
        double(depth), kWidth, kHeight, std::size(kViews));
    for (const std::string& mesh : meshes)
        if (const int failed = measure(renderer, mesh, depth); failed != 0)
            return failed;
    return cost(renderer, meshes.front(), depth);
}
