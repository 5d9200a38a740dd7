// Relief on meshes against the displaced mesh: outline and depth for each kind of silhouettes, depth for frames from derivatives; and what
// each switch costs.
// mesh_bench [--prisms] [DEPTH] [MESH...]; DEPTH: share of the mesh's longest side; a tile of the texture is a quarter of that side.
// --prisms: only silhouettes by prisms, with relief that stays below white too.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "render/measure/mesh_errors.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace relievo;

namespace {

constexpr int kWidth = 1024, kHeight = 768;
constexpr float kTile = 0.25f; // share of the longest side

struct Scene {
    State state;
    Resources resources;
};

Expected<Scene> sceneOn(const std::string& mesh, float depth)
{
    State state = openSource("sample:cobblestones", State())->state;
    state.mesh = mesh;
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

// The scene's heights, changed one by one.
void mapHeights(Scene& scene, float (*map)(float))
{
    Material material = *scene.resources.material;
    const HeightField& field = *material.height;
    std::vector<float> heights(field.texels().begin(), field.texels().end());
    std::ranges::transform(heights, heights.begin(), map);
    material.height = HeightField(field.width(), field.height(), std::move(heights), field.wrap(), field.storedBits());
    scene.resources.material = std::make_shared<const Material>(std::move(material));
}

struct Relief {
    const char* label;
    float (*map)(float);
};
constexpr Relief kReliefs[] = {
    {"white tops", [](float h) { return h; }},
    {"0 to 0.5", [](float h) { return 0.5f * h; }},
    {"constant 0.5", [](float) { return 0.5f; }},
};

// Outline and depth by prisms for each relief.
int prismTable(Renderer& renderer, const std::vector<std::string>& meshes, float depth)
{
    std::printf("Depth %g of the longest side, %dx%d, prisms; outline, depth\n| mesh |", double(depth), kWidth, kHeight);
    for (const Relief& relief : kReliefs)
        std::printf(" %s |", relief.label);
    std::printf("\n|---|---|---|---|\n");
    for (const std::string& mesh : meshes) {
        std::string line;
        for (const Relief& relief : kReliefs) {
            auto scene = sceneOn(mesh, depth);
            if (!scene)
                return refuse(scene.error());
            mapHeights(*scene, relief.map);
            Warnings coarse;
            const auto found = measurePrisms(renderer, scene->state, scene->resources, kWidth, kHeight, coarse);
            if (!found)
                return refuse(found.error());
            char text[64];
            std::snprintf(text, sizeof text, " %.3f %% / %.2f px |", 100. * found->coverage, found->depthRmse);
            line += text;
        }
        std::printf("| %s |%s\n", mesh.c_str(), line.c_str());
        std::fflush(stdout);
    }
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    const auto context = WindowlessContext::create();
    if (!context)
        return refuse(context.error());
    Renderer renderer;
    std::vector<std::string> meshes(argv + 1, argv + argc);
    const bool prisms = std::erase(meshes, "--prisms") > 0;
    const float depth = meshes.empty() ? 0.02f : float(std::atof(meshes.front().c_str()));
    if (!meshes.empty())
        meshes.erase(meshes.begin());
    if (meshes.empty())
        meshes = {"sphere", "torus", "cylinder", "plane", "box", "teapot"};
    if (prisms)
        return prismTable(renderer, meshes, depth);
    std::printf("Depth %g of the longest side, %dx%d; outline, depth\n"
                "| mesh | no silhouettes | axes | quadric | prisms | quadric / none | prisms / none | derivatives | thesis "
                "|\n|---|---|---|---|---|---|---|---|---|\n",
        double(depth), kWidth, kHeight);
    std::vector<MeshRow> timed;
    for (const std::string& mesh : meshes) {
        auto scene = sceneOn(mesh, depth);
        if (!scene)
            return refuse(scene.error());
        Warnings coarse;
        const auto found = measureOnMesh(renderer, scene->state, scene->resources, kWidth, kHeight, mesh == meshes.front(), coarse);
        if (!found)
            return refuse(found.error());
        const std::vector<MeshRow>& rows = found->rows; // of which the first are the kinds of silhouettes
        std::printf("| %s |", found->name.c_str());
        for (std::size_t kind = 0; kind < 4; ++kind)
            std::printf(" %.2f %% / %.1f px |", 100. * rows[kind].coverage, rows[kind].depthRmse);
        std::printf(" %.2f | %.2f | %.1f px | %.1f px |\n", rows[2].coverage / rows[0].coverage, rows[3].coverage / rows[0].coverage,
            rows[5].depthRmse, rows[6].depthRmse);
        for (const MeshRow& row : rows)
            if (row.invalid > 0.)
                std::printf("%s: %g pixels are no numbers\n", row.label.c_str(), row.invalid);
        if (!coarse.empty())
            std::fprintf(stderr, "%s: %s\n", mesh.c_str(), coarse.front().text.c_str());
        if (timed.empty())
            timed = rows;
    }
    std::printf("\nFrame of %s, shaded, ratio to plain:", meshes.front().c_str());
    for (std::size_t i = 1; i < timed.size(); ++i)
        std::printf("%s %s %.2f", i > 1 ? "," : "", timed[i].label.c_str(), timed[i].ratio);
    std::printf("\n");
    return 0;
}
