// The lights of a picture: which parameters each has, and where it stands.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <array>

namespace relievo {

struct TechniqueRow;

inline constexpr std::size_t kMostLights = 4;

struct LightMembers {
    LightKind Parameters::*kind;
    float Parameters::*yaw;
    float Parameters::*pitch;
    float Parameters::*distance;
    float Parameters::*intensity;
    glm::vec3 Parameters::*color;
    float Parameters::*cone;
    float Parameters::*softness;
    float Parameters::*size;
    bool Parameters::*shadows;
};
inline constexpr std::array<LightMembers, kMostLights> kLights = {{
    {&Parameters::lightKind, &Parameters::lightYaw, &Parameters::lightPitch, &Parameters::lightDistance, &Parameters::lightIntensity,
        &Parameters::lightColor, &Parameters::lightCone, &Parameters::lightSoftness, &Parameters::lightSize, &Parameters::shadows},
    {&Parameters::light2Kind, &Parameters::light2Yaw, &Parameters::light2Pitch, &Parameters::light2Distance, &Parameters::light2Intensity,
        &Parameters::light2Color, &Parameters::light2Cone, &Parameters::light2Softness, &Parameters::light2Size,
        &Parameters::light2Shadows},
    {&Parameters::light3Kind, &Parameters::light3Yaw, &Parameters::light3Pitch, &Parameters::light3Distance, &Parameters::light3Intensity,
        &Parameters::light3Color, &Parameters::light3Cone, &Parameters::light3Softness, &Parameters::light3Size,
        &Parameters::light3Shadows},
    {&Parameters::light4Kind, &Parameters::light4Yaw, &Parameters::light4Pitch, &Parameters::light4Distance, &Parameters::light4Intensity,
        &Parameters::light4Color, &Parameters::light4Cone, &Parameters::light4Softness, &Parameters::light4Size,
        &Parameters::light4Shadows},
}};

inline bool isLit(const Parameters& parameters, const LightMembers& light)
{
    return parameters.*light.kind != LightKind::Off;
}
// Point or spot: it stands at a place.
inline bool isNear(const Parameters& parameters, const LightMembers& light)
{
    return parameters.*light.kind == LightKind::Point || parameters.*light.kind == LightKind::Spot;
}
// Whether all there is is the first light, and that directional: what programs of others are told, and the least text.
bool isOneDirectional(const Parameters& parameters);
// The same without the others, and the first as a directional one; dark where it is off.
Parameters withOneDirectional(Parameters parameters);

// Whether a light that is on casts the relief's shadows on itself, and the technique can; and whether the map of horizons tells them.
bool hasSelfShadows(const TechniqueRow& technique, const Parameters& parameters);
bool hasHorizonShadows(const TechniqueRow& technique, const Parameters& parameters);
// Whether the relief takes from the light of the surroundings: not where there is none to be seen.
bool hasAmbientRelief(const TechniqueRow& technique, const Parameters& parameters);
// Either of the two, so that the map of horizons is needed.
bool readsHorizons(const TechniqueRow& technique, const Parameters& parameters);

// As the light has turned, in [-180, 180].
float turnedYaw(const Parameters& parameters, const LightMembers& light);
// Unit, from the mesh's middle towards it.
glm::vec3 directionTo(const Parameters& parameters, const LightMembers& light);

// A sphere around the mesh, m.
struct Around {
    glm::vec3 middle{0.f};
    float radius = 1.f;
};
Around around(glm::vec3 boundsMin, glm::vec3 boundsMax);
// m from the middle; directional lights are shown as far as one that stands there.
inline float distanceOf(const Parameters& parameters, const LightMembers& light, const Around& mesh)
{
    return parameters.*light.distance * mesh.radius;
}

// What an intensity means: irradiance where the mesh's middle is, W/m2, and of a point or spot its radiant intensity, W/sr.
float irradianceOf(const Parameters& parameters, const LightMembers& light);
float radiantIntensityOf(const Parameters& parameters, const LightMembers& light, const Around& mesh);

} // namespace relievo
