// Pictures of positions against distances of the displaced mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_errors.h"
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

Expected<std::vector<float>> exactDistances(
    const State& state, const Resources& resources, int width, int height, Warnings& warnings, const Progress& progress)
{
    if (!resources.material->height)
        return failure(state.name, "there is no height map, so nothing is displaced", "Assign one");
    const Parameters parameters = effectiveParameters(state, 0);
    const CameraView camera = viewOf(state, resources, width, height);
    Mesh mesh = posed(*resources.mesh, poseOf(*resources.mesh, parameters));
    for (MeshPart& part : mesh.parts)
        part.relief = isPlain(*resources.mesh, part, state.part) ? 0.f : part.relief;
    const auto surface = DisplacedMesh::build(mesh, resources.material->height->withWrap(wrapOf(parameters)), parameters,
        DisplacedMesh::detailFor(*resources.mesh, camera, state.camera.fov, height), progress);
    if (!surface)
        return tl::unexpected(surface.error());
    if (surface->coarseness() > 1.05f)
        warnings.push_back({"reference-coarse",
            "The displaced mesh is " + std::to_string(int(std::ceil(surface->coarseness())))
                + " times coarser than half a texel or half a pixel: " + std::to_string(surface->triangles()) + " micro-triangles, "
                + std::to_string(surface->bytes() >> 20) + " MiB. Errors below that size are its own."});
    return distancesSeen(*surface, camera, width, height, progress);
}

Expected<MeshErrors> meshErrors(
    Renderer& renderer, const State& state, const Resources& resources, const std::vector<float>& exact, int width, int height)
{
    State plain = state;
    plain.parameters.wireframe = false, plain.parameters.heightMips = false, plain.parameters.background = 2;
    const auto image = drawPicture(renderer, plain, 0, resources, "position", width, height, 1, true);
    if (!image)
        return tl::unexpected(image.error());
    const CameraView camera = viewOf(state, resources, width, height);
    const double pixel = 2. * std::tan(0.5 * double(glm::radians(state.camera.fov))) / double(height); // of a metre's distance
    MeshErrors errors;
    double either = 0., both = 0.;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double truth = double(exact[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
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

} // namespace relievo
