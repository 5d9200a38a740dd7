// Tracing the displaced mesh for a picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/exact_distances.h"
#include "core/object/object_file.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace relievo {

namespace {
using Answer = Expected<std::shared_ptr<const ExactDistances>>;

struct Step {
    float coarser; // DisplacedMesh::Detail
    float from, to; // of the progress
};
constexpr Step kOneStep[] = {{1.f, 0.f, 1.f}};
constexpr Step kSteps[] = {{2.f, 0.f, 0.1f}, {1.f, 0.1f, 0.3f}, {0.5f, 0.3f, 1.f}};
constexpr float kOwnError = 0.0025f; // share of the depth that it may be off by ...
constexpr double kUnsure = 0.02; // ... but for this share of the pixels

// Halving the micro-triangles' sides moves them by this: of what is left a smooth surface has a third, a rough one as much.
std::vector<float> movedBy(const PixelDistances& fine, const PixelDistances& coarse)
{
    std::vector<float> moved(fine.metres.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const float a = fine.metres[i], b = coarse.metres[i];
        moved[i] = std::isfinite(a) && std::isfinite(b) ? 0.5f * std::abs(a - b)
            : std::isfinite(a) == std::isfinite(b)      ? 0.f
                                                        : std::numeric_limits<float>::infinity();
    }
    return moved;
}

bool isSure(const PixelDistances& pixels, float depth)
{
    const auto seen = std::ranges::count_if(pixels.metres, [](float metres) { return std::isfinite(metres); });
    const auto unsure = std::ranges::count_if(pixels.uncertain, [&](float off) { return off > kOwnError * depth; });
    return double(unsure) <= kUnsure * double(seen);
}

void tellCoarse(const DisplacedMesh& surface, Warnings& coarse)
{
    if (surface.coarseness() > 1.05f)
        coarse.push_back({"reference-coarse",
            "The displaced mesh is " + std::to_string(int(std::ceil(surface.coarseness())))
                + " times coarser than half a texel or half a pixel: " + std::to_string(surface.triangles()) + " micro-triangles, "
                + std::to_string(surface.bytes() >> 20) + " MiB. Errors below that size are its own."});
}
} // namespace

ExactQuestion exactQuestion(const State& state, std::size_t pane, const Resources& resources, int width, int height)
{
    const auto& field = resources.material->height;
    return {cameraOf(state, pane), width, height, state.part, onlyAffecting(Affects::ExactAnswer, effectiveParameters(state, pane)),
        field ? field->identity() : nullptr, resources.mesh};
}

bool hasMeshReference(const State& state, const Resources& resources)
{
    return resources.mesh->object ? !resources.mesh->object->source.empty() : state.mesh != "plane" && resources.material->height;
}

namespace {
// The mesh that an object stands for, as it is.
Answer distancesOfSource(const State& state, std::size_t pane, const Resources& resources, int width, int height, const Progress& progress)
{
    const std::string& source = resources.mesh->object->source;
    if (source.empty())
        return failure(state.mesh, "the object does not say what mesh it stands for", "Bake it again by relievo impostor");
    const auto mesh = openMesh(source, progress.part(0.f, 0.4f));
    if (!mesh)
        return tl::unexpected(mesh.error());
    const CameraView view = cameraOnto(*resources.mesh, cameraOf(state, pane), float(width) / float(height));
    Parameters parameters;
    parameters.depth = 0.f;
    const auto surface = DisplacedMesh::build(*mesh, HeightField(1, 1, {1.f}), parameters, {}, progress.part(0.4f, 0.7f));
    if (!surface)
        return tl::unexpected(surface.error());
    auto pixels = pixelDistances(*surface, view, width, height, progress.part(0.7f, 1.f));
    if (!pixels)
        return tl::unexpected(pixels.error());
    return std::make_shared<const ExactDistances>(ExactDistances{exactQuestion(state, pane, resources, width, height), std::move(*pixels)});
}

// The last of the steps, or the first that leaves no doubt.
Answer distances(std::span<const Step> steps, const State& state, std::size_t pane, const Resources& resources, int width, int height,
    Warnings& coarse, const Progress& progress)
{
    if (resources.mesh->object)
        return distancesOfSource(state, pane, resources, width, height, progress);
    if (!resources.material->height)
        return failure(state.name, "there is no height map, so nothing is displaced", "Assign one");
    const Parameters parameters = effectiveParameters(state, pane);
    const Camera& camera = cameraOf(state, pane);
    const CameraView view = cameraOnto(*resources.mesh, camera, float(width) / float(height));
    Mesh mesh = posed(*resources.mesh, poseOf(*resources.mesh, parameters));
    const std::vector<char> plain = plainParts(*resources.mesh, state.part);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        mesh.parts[i].relief = plain[i] != 0 ? 0.f : mesh.parts[i].relief;
    const HeightField field = resources.material->height->withWrap(parameters.wrap);
    DisplacedMesh::Detail detail = DisplacedMesh::detailFor(*resources.mesh, view, camera.fov, height);
    const float depth = physicalDepth(parameters, resources.mesh->metresPerUV);
    PixelDistances pixels;
    for (const Step& step : steps) {
        detail.coarser = step.coarser;
        detail.maxTriangles = std::size_t(float(DisplacedMesh::Detail().maxTriangles) / std::max(1.f, step.coarser * step.coarser));
        const auto surface = DisplacedMesh::build(mesh, field, parameters, detail, progress.part(step.from, 0.5f * (step.from + step.to)));
        if (!surface)
            return tl::unexpected(surface.error());
        auto finer = pixelDistances(*surface, view, width, height, progress.part(0.5f * (step.from + step.to), step.to));
        if (!finer)
            return tl::unexpected(finer.error());
        if (!pixels.metres.empty())
            finer->uncertain = movedBy(*finer, pixels);
        pixels = std::move(*finer);
        if (step.coarser > 1.f)
            continue;
        tellCoarse(*surface, coarse);
        if (surface->coarseness() > 1.f || isSure(pixels, depth)) // no finer one fits, or is needed
            break;
    }
    progress.at(1.f);
    return std::make_shared<const ExactDistances>(ExactDistances{exactQuestion(state, pane, resources, width, height), std::move(pixels)});
}
} // namespace

Answer exactDistances(
    const State& state, std::size_t pane, const Resources& resources, int width, int height, Warnings& coarse, const Progress& progress)
{
    return distances(kOneStep, state, pane, resources, width, height, coarse, progress);
}

Answer sureDistances(
    const State& state, std::size_t pane, const Resources& resources, int width, int height, Warnings& coarse, const Progress& progress)
{
    return distances(kSteps, state, pane, resources, width, height, coarse, progress);
}

} // namespace relievo
