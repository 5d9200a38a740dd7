// Loading what changed.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/resources.h"
#include "core/scene/scene_mesh.h"
#include "core/state/techniques.h"
#include "core/trace/relief_room.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace relievo {

Pose poseOf(const Mesh& mesh, const Parameters& parameters)
{
    const auto clip = std::size_t(parameters.clip);
    const bool known = mesh.deformation && clip < mesh.deformation->clips.size();
    const float length = known ? mesh.deformation->clips[clip].seconds : 0.f;
    return poseAt(mesh, parameters.clip, length > 0.f ? std::fmod(parameters.time, length) : 0.f);
}

float fittingDepth(const Parameters& parameters, float metresPerUV, const ReliefFit& fit)
{
    const float goesIn = parameters.midlevel - fit.lowest; // share of the depth that lies below the mesh
    const float metres = physicalDepth(parameters, metresPerUV); // of `depth`
    return goesIn > 0.f && metres > 0.f ? fit.room / goesIn * (parameters.depth / metres) : std::numeric_limits<float>::infinity();
}

std::optional<Warning> tooDeep(const State& state, const Resources& resources)
{
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane) {
        const Parameters parameters = effectiveParameters(state, pane);
        const TechniqueRow* technique = findTechnique(state.panes[pane].technique);
        const float fits = fittingDepth(parameters, resources.mesh->metresPerUV, resources.fit);
        if (technique && technique->displaces && parameters.depth > fits) {
            char text[200];
            std::snprintf(text, sizeof text,
                "The relief is deeper than the mesh is thick in places: up to a depth of %.2g it fits, now it is %.3g.", double(fits),
                double(parameters.depth));
            return Warning{"relief-too-deep", text};
        }
    }
    return {};
}

namespace {
void measureFit(Resources& resources)
{
    const auto& height = resources.material->height;
    ReliefFit& fit = resources.fit;
    if (!height) { // any depth fits, and a large mesh takes half a second to ask
        fit = {};
        return;
    }
    if (fit.mesh != resources.mesh)
        fit.room = reliefRoom(*resources.mesh);
    if (fit.heights != height->identity())
        fit.lowest = *std::ranges::min_element(height->texels());
    fit.mesh = resources.mesh, fit.heights = height->identity();
}
} // namespace

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
        auto mesh = openSceneMesh(state.mesh, progress.part(0.7f, 0.8f));
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
    measureFit(resources);
    const Progress baking = progress.part(onlyMaps ? 0.f : 0.9f, 1.f);
    if (const auto baked = resources.accelerationMaps.makeFor(state, *resources.material, baking); !baked)
        return tl::unexpected(baked.error());
    resources.accelerationMaps.keepOnlyOf(state, *resources.material);
    progress.at(1.f);
    return resources;
}

} // namespace relievo
