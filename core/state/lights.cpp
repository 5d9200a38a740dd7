// Lights from their parameters.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/lights.h"
#include "core/state/camera_view.h"
#include "core/state/technique_row.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

namespace relievo {

bool isOneDirectional(const Parameters& parameters)
{
    return parameters.lightKind == LightKind::Directional
        && std::none_of(kLights.begin() + 1, kLights.end(), [&](const LightMembers& light) { return isLit(parameters, light); });
}

Parameters withOneDirectional(Parameters parameters)
{
    if (parameters.lightKind == LightKind::Off)
        parameters.lightIntensity = 0.f;
    for (const LightMembers& light : kLights)
        parameters.*light.kind = LightKind::Off;
    parameters.lightKind = LightKind::Directional;
    return parameters;
}

bool hasSelfShadows(const TechniqueRow& technique, const Parameters& parameters)
{
    const auto casts = [&](const LightMembers& light) { return isLit(parameters, light) && parameters.*light.shadows; };
    return technique.hasShadowsAndOutlines() && std::ranges::any_of(kLights, casts);
}

bool hasHorizonShadows(const TechniqueRow& technique, const Parameters& parameters)
{
    return parameters.shadowSearch == ShadowSearch::Horizon && !technique.isOfObjects && hasSelfShadows(technique, parameters);
}

bool hasAmbientRelief(const TechniqueRow& technique, const Parameters& parameters)
{
    return parameters.ambientRelief != AmbientRelief::Off && technique.readsNormals && !technique.isEngine() && !technique.isOfObjects;
}

bool readsHorizons(const TechniqueRow& technique, const Parameters& parameters)
{
    return hasHorizonShadows(technique, parameters) || hasAmbientRelief(technique, parameters);
}

float turnedYaw(const Parameters& parameters, const LightMembers& light)
{
    const float yaw = parameters.*light.yaw + parameters.lightTurn;
    return yaw > 180.f ? yaw - 360.f : yaw;
}

glm::vec3 directionTo(const Parameters& parameters, const LightMembers& light)
{
    return directionTo(turnedYaw(parameters, light), parameters.*light.pitch);
}

Around around(glm::vec3 boundsMin, glm::vec3 boundsMax)
{
    return {0.5f * (boundsMin + boundsMax), std::max(0.5f * glm::length(boundsMax - boundsMin), 1e-6f)};
}

float irradianceOf(const Parameters& parameters, const LightMembers& light)
{
    return std::numbers::pi_v<float> * parameters.*light.intensity;
}

float radiantIntensityOf(const Parameters& parameters, const LightMembers& light, const Around& mesh)
{
    const float distance = distanceOf(parameters, light, mesh);
    return irradianceOf(parameters, light) * distance * distance;
}

} // namespace relievo
