// Relief on meshes against the displaced mesh: outline and depth, without silhouettes, with the papers' curvature and with the whole
// quadric; and what each switch costs. mesh_bench [DEPTH] [MESH...] SPDX-FileCopyrightText: The Relievo authors SPDX-License-Identifier:
// GPL-3.0-or-later
#include "render/frame_time.h"
#include "render/mesh_errors.h"
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace relievo;

namespace {

constexpr int kWidth = 640, kHeight = 480;
constexpr float kViews[][2] = {{30.f, 35.f}, {120.f, 10.f}, {210.f, -20.f}, {300.f, 0.f}, {0.f, 60.f}}; // yaw, pitch

State sceneOn(const std::string& mesh, float depth)
{
    State state = openSource("sample:cobblestones", State())->state;
    state.mesh = mesh;
    state.parameters.depth = depth;
    state.parameters.shadows = false;
    state.panes = {Pane{"cell-cone", {}}};
    return state;
}

int refuse(const Error& error)
{
    std::fprintf(stderr, "%s\n", message(error).c_str());
    return 1;
}

int measure(Renderer& renderer, const std::string& mesh, float depth)
{
    State state = sceneOn(mesh, depth);
    const auto resources = loadResources(state, {}, {});
    if (!resources)
        return refuse(resources.error());
    double coverage[3] = {}, depths[3] = {}, invalid = 0.;
    Warnings warnings;
    for (const auto& view : kViews) {
        state.camera.yaw = view[0], state.camera.pitch = view[1];
        const auto exact = exactDistances(state, *resources, kWidth, kHeight, warnings);
        if (!exact)
            return refuse(exact.error());
        for (int silhouettes = 0; silhouettes < 3; ++silhouettes) {
            state.parameters.silhouettes = silhouettes;
            const auto errors = meshErrors(renderer, state, *resources, *exact, kWidth, kHeight);
            if (!errors)
                return refuse(errors.error());
            coverage[silhouettes] += errors->coverage / std::size(kViews);
            depths[silhouettes] += errors->depthRmse / std::size(kViews);
            invalid += errors->invalid;
        }
    }
    std::printf("| %s | %.2f %% / %.1f px | %.2f %% / %.1f px | %.2f %% / %.1f px | %.2f |\n", resources->mesh->name.c_str(),
        100. * coverage[0], depths[0], 100. * coverage[1], depths[1], 100. * coverage[2], depths[2], coverage[2] / coverage[0]);
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
    {"depth of the relief", [](Parameters& p) { p.depthOfHit = true; }},
    {"frames from derivatives", [](Parameters& p) { p.frames = 1; }},
    {"fade at edges", [](Parameters& p) { p.edgeFade = 0.3f; }},
    {"self-shadows", [](Parameters& p) { p.shadows = true; }},
    {"shadows between objects", [](Parameters& p) { p.objectShadows = true; }},
};

int cost(Renderer& renderer, const std::string& mesh, float depth)
{
    std::vector<TimedFrame> frames;
    for (const Switch& each : kSwitches) {
        frames.push_back({sceneOn(mesh, depth), "shaded"});
        each.set(frames.back().state.parameters);
    }
    const auto resources = loadResources(frames.front().state, {}, {});
    if (!resources)
        return refuse(resources.error());
    const auto times = frameTimes(renderer, *resources, frames, 800, 600, 9);
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
    const float depth = argc > 1 ? float(std::atof(argv[1])) : 0.08f;
    std::vector<std::string> meshes(argv + std::min(argc, 2), argv + argc);
    if (meshes.empty())
        meshes = {"sphere", "torus", "cylinder", "plane", "box", "teapot"};
    std::printf("Depth %g, %dx%d, %zu views\n| mesh | no silhouettes | axes | quadric | quadric / none |\n|---|---|---|---|---|\n",
        double(depth), kWidth, kHeight, std::size(kViews));
    for (const std::string& mesh : meshes)
        if (const int failed = measure(renderer, mesh, depth); failed != 0)
            return failed;
    return cost(renderer, meshes.front(), depth);
}
