// Loading what changed.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/resources.h"
#include <cmath>

namespace relievo {

Pose poseOf(const Mesh& mesh, const Parameters& parameters)
{
    const auto clip = std::size_t(parameters.clip);
    const bool known = mesh.deformation && clip < mesh.deformation->clips.size();
    const float length = known ? mesh.deformation->clips[clip].seconds : 0.f;
    return poseAt(mesh, parameters.clip, length > 0.f ? std::fmod(parameters.time, length) : 0.f);
}

Expected<Resources> loadResources(const State& state, const DecodedImages& images, const Resources& previous, const Progress& progress)
{
    Resources resources = previous;
    const bool onlyMaps = resources.material && resources.material->slots == state.slots && resources.mesh
        && resources.meshName == state.mesh && resources.environment && resources.environmentName == state.environment;
    if (!resources.material || resources.material->slots != state.slots) {
        auto material = loadMaterial(state.slots, images, previous.material.get(), progress.part(0.f, 0.7f));
        if (!material)
            return tl::unexpected(material.error());
        resources.material = std::make_shared<const Material>(std::move(*material));
    }
    if (!resources.mesh || resources.meshName != state.mesh) {
        auto mesh = openMesh(state.mesh, progress.part(0.7f, 0.8f));
        if (!mesh)
            return tl::unexpected(mesh.error());
        resources.mesh = std::make_shared<const Mesh>(std::move(*mesh));
        resources.meshName = state.mesh;
    }
    if (!resources.environment || resources.environmentName != state.environment) {
        auto environment = openEnvironment(state.environment, progress.part(0.8f, 0.9f));
        if (!environment)
            return tl::unexpected(environment.error());
        resources.environment = std::make_shared<const Environment>(std::move(*environment));
        resources.environmentName = state.environment;
    }
    if (progress.cancelled())
        return cancelled(state.name);
    const Progress baking = progress.part(onlyMaps ? 0.f : 0.9f, 1.f);
    if (const auto baked = resources.accelerationMaps.makeFor(state, *resources.material, baking); !baked)
        return tl::unexpected(baked.error());
    resources.accelerationMaps.keepOnlyOf(state, *resources.material);
    progress.at(1.f);
    return resources;
}

} // namespace relievo
