// Tracing the displaced mesh for a picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/exact_distances.h"
#include <cmath>

namespace relievo {

ExactQuestion exactQuestion(const State& state, std::size_t pane, const Resources& resources, int width, int height)
{
    const auto& field = resources.material->height;
    return {cameraOf(state, pane), width, height, state.part, onlyAffecting(Affects::ExactAnswer, effectiveParameters(state, pane)),
        field ? field->identity() : nullptr, resources.mesh};
}

bool hasMeshReference(const State& state, const Resources& resources)
{
    return state.mesh != "plane" && resources.material->height;
}

Expected<std::shared_ptr<const ExactDistances>> exactDistances(
    const State& state, std::size_t pane, const Resources& resources, int width, int height, Warnings& coarse, const Progress& progress)
{
    if (!resources.material->height)
        return failure(state.name, "there is no height map, so nothing is displaced", "Assign one");
    const Parameters parameters = effectiveParameters(state, pane);
    const Camera& camera = cameraOf(state, pane);
    const CameraView view = cameraView(camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(width) / float(height));
    Mesh mesh = posed(*resources.mesh, poseOf(*resources.mesh, parameters));
    const std::vector<char> plain = plainParts(*resources.mesh, state.part);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        mesh.parts[i].relief = plain[i] != 0 ? 0.f : mesh.parts[i].relief;
    const auto surface = DisplacedMesh::build(mesh, resources.material->height->withWrap(parameters.wrap), parameters,
        DisplacedMesh::detailFor(*resources.mesh, view, camera.fov, height), progress);
    if (!surface)
        return tl::unexpected(surface.error());
    if (surface->coarseness() > 1.05f)
        coarse.push_back({"reference-coarse",
            "The displaced mesh is " + std::to_string(int(std::ceil(surface->coarseness())))
                + " times coarser than half a texel or half a pixel: " + std::to_string(surface->triangles()) + " micro-triangles, "
                + std::to_string(surface->bytes() >> 20) + " MiB. Errors below that size are its own."});
    auto pixels = pixelDistances(*surface, view, width, height, progress);
    if (!pixels)
        return tl::unexpected(pixels.error());
    return std::make_shared<const ExactDistances>(ExactDistances{exactQuestion(state, pane, resources, width, height), std::move(*pixels)});
}

} // namespace relievo
