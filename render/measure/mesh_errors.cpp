// Pictures of positions against distances of the displaced mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/mesh_errors.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include "render/measure/frame_time.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <span>

namespace relievo {

Expected<MeshRow> meshErrors(
    Renderer& renderer, const State& state, Resources& resources, const std::shared_ptr<const ExactDistances>& exact)
{
    const PixelDistances& pixels = exact->pixels;
    const int width = pixels.width, height = pixels.height;
    State plain = state;
    plain.parameters.wireframe = false, plain.parameters.heightMips = false, plain.parameters.background = Backdrop::Transparent;
    const auto image = drawPicture(renderer, plain, 0, resources, knownView("position").key, width, height, 1, true);
    if (!image)
        return tl::unexpected(image.error());
    const Camera& camera = exact->question.camera;
    const glm::vec3 eye = cameraOnto(*resources.mesh, camera, float(width) / float(height)).eye;
    const double pixel = 2. * std::tan(0.5 * double(glm::radians(camera.fov))) / double(height); // of a metre's distance
    MeshRow errors{{}, 0., 0., 0., std::nan("")};
    double either = 0., both = 0.;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double truth = double(pixels.at(x, y));
            if (std::isnan(truth))
                continue;
            const bool covered = image->value(x, y, 3) > 0.5f, hit = std::isfinite(truth);
            either += covered || hit;
            errors.coverage += covered != hit;
            const glm::vec3 point(image->value(x, y, 0), image->value(x, y, 1), image->value(x, y, 2));
            const double found = double(glm::distance(point, eye));
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
    {"silhouettes: axes, as in the papers", [](Parameters& p) { p.silhouettes = Silhouettes::Axes; }},
    {"silhouettes: quadric", [](Parameters& p) { p.silhouettes = Silhouettes::Quadric; }},
    {"silhouettes: prisms", [](Parameters& p) { p.silhouettes = Silhouettes::Prisms; }},
    {"depth of the relief", [](Parameters& p) { p.depthOfHit = true; }},
    {"frames from derivatives", [](Parameters& p) { p.frames = Frames::Derivatives; }},
    {"frames as in the thesis, without skew", [](Parameters& p) { p.frames = Frames::Thesis; }},
    {"fade at edges 0.3", [](Parameters& p) { p.edgeFade = 0.3f; }},
    {"self-shadows", [](Parameters& p) { p.shadows = true; }},
    {"shadows between objects", [](Parameters& p) { p.objectShadows = true; }},
};
constexpr float kMeshViews[][2] = {{30.f, 35.f}, {120.f, 10.f}, {210.f, -20.f}, {300.f, 0.f}, {0.f, 60.f}}; // yaw, pitch

State changed(const State& state, const Change& change)
{
    State result = state;
    Parameters& p = result.parameters;
    p.silhouettes = Silhouettes::Off, p.frames = Frames::Vertex, p.edgeFade = 0.f;
    p.depthOfHit = p.shadows = p.objectShadows = p.wireframe = p.heightMips = false;
    change.apply(p);
    result.panes = {Pane{std::string(knownTechnique("cell-cone").key)}};
    return result;
}

// The mean over kMeshViews, one row a change. triangles: the most micro-triangles of a view.
Expected<std::vector<MeshRow>> overViews(Renderer& renderer, State view, Resources& resources, int width, int height,
    std::span<const Change> changes, std::size_t& triangles, Warnings& coarse, const Progress& progress)
{
    std::vector<MeshRow> rows;
    for (const Change& change : changes)
        rows.push_back({change.label, 0., 0., 0., std::nan("")});
    constexpr double kViews = std::size(kMeshViews);
    for (std::size_t i = 0; i < std::size(kMeshViews); ++i) {
        view.camera.yaw = kMeshViews[i][0], view.camera.pitch = kMeshViews[i][1];
        Warnings told;
        const auto exact = exactDistances(view, 0, resources, width, height, i == 0 ? coarse : told, Progress{{}, progress.stop});
        if (!exact)
            return tl::unexpected(exact.error());
        triangles = std::max(triangles, (*exact)->pixels.triangles);
        for (std::size_t k = 0; k < changes.size(); ++k) {
            const auto errors = meshErrors(renderer, changed(view, changes[k]), resources, *exact);
            if (!errors)
                return tl::unexpected(errors.error());
            rows[k].coverage += errors->coverage / kViews, rows[k].depthRmse += errors->depthRmse / kViews;
            rows[k].invalid += errors->invalid;
        }
        progress.at(0.8f * float(i + 1) / float(kViews));
    }
    return rows;
}
} // namespace

Expected<MeshRow> measurePrisms(
    Renderer& renderer, const State& state, Resources& resources, int width, int height, Warnings& coarse, const Progress& progress)
{
    const auto change = std::ranges::find(kChanges, std::string_view("silhouettes: prisms"), &Change::label);
    std::size_t triangles = 0;
    auto rows = overViews(renderer, ofFirstPane(state), resources, width, height, {change, 1}, triangles, coarse, progress);
    return rows ? Expected<MeshRow>(rows->front()) : tl::unexpected(rows.error());
}

Expected<MeshSection> measureOnMesh(Renderer& renderer, const State& state, Resources& resources, int width, int height, bool timed,
    Warnings& coarse, const Progress& progress)
{
    const State view = ofFirstPane(state);
    MeshSection section{resources.mesh->name, 0, double(physicalDepth(view.parameters, resources.mesh->metresPerUV)),
        int(std::size(kMeshViews)), width, height, {}, {}};
    if (resources.mesh->fileHasTangents)
        section.tangents = tangentDifference(*resources.mesh);
    auto rows = overViews(renderer, view, resources, width, height, kChanges, section.triangles, coarse, progress);
    if (!rows)
        return tl::unexpected(rows.error());
    section.rows = std::move(*rows);
    if (!timed)
        return section;
    std::vector<TimedFrame> frames;
    for (const Change& change : kChanges)
        frames.push_back({changed(view, change), knownView("shaded").key});
    const auto times = frameTimes(renderer, resources, frames, width, height, {9}, Progress{{}, progress.stop});
    if (!times)
        return tl::unexpected(times.error());
    for (std::size_t k = 0; k < std::size(kChanges); ++k)
        section.rows[k].ratio = (*times)[k] / (*times)[0];
    return section;
}

} // namespace relievo
