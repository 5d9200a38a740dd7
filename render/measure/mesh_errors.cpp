// Pictures of positions against distances of the displaced mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/mesh_errors.h"
#include "render/measure/frame_time.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

namespace {
CameraView viewOf(const State& state, const Resources& resources, int width, int height)
{
    return cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(width) / float(height));
}
} // namespace

bool hasMeshReference(const State& state, const Resources& resources)
{
    return state.mesh != "plane" && resources.material->height;
}

Expected<SeenDistances> exactDistances(
    const State& state, std::size_t pane, const Resources& resources, int width, int height, Warnings& coarse, const Progress& progress)
{
    if (!resources.material->height)
        return failure(state.name, "there is no height map, so nothing is displaced", "Assign one");
    const Parameters parameters = effectiveParameters(state, pane);
    const CameraView camera = viewOf(state, resources, width, height);
    Mesh mesh = posed(*resources.mesh, poseOf(*resources.mesh, parameters));
    const std::vector<char> plain = plainParts(*resources.mesh, state.part);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        mesh.parts[i].relief = plain[i] != 0 ? 0.f : mesh.parts[i].relief;
    const auto surface = DisplacedMesh::build(mesh, resources.material->height->withWrap(wrapOf(parameters)), parameters,
        DisplacedMesh::detailFor(*resources.mesh, camera, state.camera.fov, height), progress);
    if (!surface)
        return tl::unexpected(surface.error());
    if (surface->coarseness() > 1.05f)
        coarse.push_back({"reference-coarse",
            "The displaced mesh is " + std::to_string(int(std::ceil(surface->coarseness())))
                + " times coarser than half a texel or half a pixel: " + std::to_string(surface->triangles()) + " micro-triangles, "
                + std::to_string(surface->bytes() >> 20) + " MiB. Errors below that size are its own."});
    return distancesSeen(*surface, camera, width, height, progress);
}

Expected<MeshRow> meshErrors(Renderer& renderer, const State& state, const Resources& resources, const SeenDistances& exact)
{
    const int width = exact.width, height = exact.height;
    State plain = state;
    plain.parameters.wireframe = false, plain.parameters.heightMips = false, plain.parameters.background = 2;
    const auto image = drawPicture(renderer, plain, 0, resources, "position", width, height, 1, true);
    if (!image)
        return tl::unexpected(image.error());
    const CameraView camera = viewOf(state, resources, width, height);
    const double pixel = 2. * std::tan(0.5 * double(glm::radians(state.camera.fov))) / double(height); // of a metre's distance
    MeshRow errors{{}, 0., 0., 0., std::nan("")};
    double either = 0., both = 0.;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double truth = double(exact.at(x, y));
            if (std::isnan(truth))
                continue;
            const bool covered = image->value(x, y, 3) > 0.5f, hit = std::isfinite(truth);
            either += covered || hit;
            errors.coverage += covered != hit;
            const glm::vec3 point(image->value(x, y, 0), image->value(x, y, 1), image->value(x, y, 2));
            const double found = double(glm::distance(point, camera.eye));
            errors.invalid += covered && !std::isfinite(found);
            if (covered && hit && std::isfinite(found)) {
                const double off = (found - truth) / (pixel * truth);
                both += 1.;
                errors.depthRmse += off * off;
            }
        }
    errors.coverage /= std::max(either, 1.);
    errors.depthRmse = std::sqrt(errors.depthRmse / std::max(both, 1.));
    return errors;
}

namespace {
struct Change {
    const char* label;
    void (*apply)(Parameters&);
};
constexpr Change kChanges[] = {
    {"nothing", [](Parameters&) {}},
    {"silhouettes: axes, as in the papers", [](Parameters& p) { p.silhouettes = 1; }},
    {"silhouettes: quadric", [](Parameters& p) { p.silhouettes = 2; }},
    {"silhouettes: prisms", [](Parameters& p) { p.silhouettes = 3; }},
    {"depth of the relief", [](Parameters& p) { p.depthOfHit = true; }},
    {"frames from derivatives", [](Parameters& p) { p.frames = 1; }},
    {"frames as in the thesis, without skew", [](Parameters& p) { p.frames = 2; }},
    {"fade at edges 0.3", [](Parameters& p) { p.edgeFade = 0.3f; }},
    {"self-shadows", [](Parameters& p) { p.shadows = true; }},
    {"shadows between objects", [](Parameters& p) { p.objectShadows = true; }},
};
constexpr float kMeshViews[][2] = {{30.f, 35.f}, {120.f, 10.f}, {210.f, -20.f}, {300.f, 0.f}, {0.f, 60.f}}; // yaw, pitch

State changed(const State& state, const Change& change)
{
    State result = state;
    Parameters& p = result.parameters;
    p.silhouettes = p.frames = 0, p.edgeFade = 0.f;
    p.depthOfHit = p.shadows = p.objectShadows = p.wireframe = p.heightMips = false;
    change.apply(p);
    result.panes = {Pane{"cell-cone", {}}};
    return result;
}
} // namespace

Expected<MeshSection> measureOnMesh(Renderer& renderer, const State& state, const Resources& resources, int width, int height, bool timed,
    Warnings& coarse, const Progress& progress)
{
    State view = state;
    view.parameters = effectiveParameters(state, 0);
    MeshSection section{resources.mesh->name, 0, double(physicalDepth(view.parameters, resources.mesh->metresPerUV)),
        int(std::size(kMeshViews)), width, height, {}, {}};
    if (resources.mesh->fileHasTangents)
        section.tangents = tangentDifference(*resources.mesh);
    for (const Change& change : kChanges)
        section.rows.push_back({change.label, 0., 0., 0., std::nan("")});
    for (std::size_t i = 0; i < std::size(kMeshViews); ++i) {
        view.camera.yaw = kMeshViews[i][0], view.camera.pitch = kMeshViews[i][1];
        Warnings told;
        const auto exact = exactDistances(view, 0, resources, width, height, i == 0 ? coarse : told, Progress{{}, progress.stop});
        if (!exact)
            return tl::unexpected(exact.error());
        section.triangles = std::max(section.triangles, exact->triangles);
        for (std::size_t k = 0; k < std::size(kChanges); ++k) {
            const auto errors = meshErrors(renderer, changed(view, kChanges[k]), resources, *exact);
            if (!errors)
                return tl::unexpected(errors.error());
            MeshRow& row = section.rows[k];
            row.coverage += errors->coverage / double(section.views), row.depthRmse += errors->depthRmse / double(section.views);
            row.invalid += errors->invalid;
        }
        progress.at(0.8f * float(i + 1) / float(section.views));
    }
    if (!timed)
        return section;
    std::vector<TimedFrame> frames;
    for (const Change& change : kChanges)
        frames.push_back({changed(view, change), "shaded"});
    const auto times = frameTimes(renderer, resources, frames, width, height, 9, Progress{{}, progress.stop});
    if (!times)
        return tl::unexpected(times.error());
    for (std::size_t k = 0; k < std::size(kChanges); ++k)
        section.rows[k].ratio = (*times)[k] / (*times)[0];
    return section;
}

} // namespace relievo
