// Uniforms derived from parameters and camera.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/scene_uniforms.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

namespace {
constexpr float kNeutralKelvin = 6500.f;

// Linear sRGB of luminance 1.
glm::vec3 blackBody(float kelvin)
{
    const double t = 1e3 / double(kelvin);
    const double x = kelvin <= 4000.f ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                      : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    const double y = kelvin <= 2222.f ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
        : kelvin <= 4000.f            ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                      : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const double X = x / y, Z = (1. - x - y) / y; // of Y = 1
    return {float(3.2404542 * X - 1.5371385 - 0.4985314 * Z), float(-0.9692660 * X + 1.8760108 + 0.0415560 * Z),
        float(0.0556434 * X - 0.2040259 + 1.0572252 * Z)};
}
} // namespace

glm::vec3 whiteGain(float kelvin)
{
    if (kelvin == kNeutralKelvin)
        return glm::vec3(1.f);
    const glm::vec3 gain = blackBody(kNeutralKelvin) / glm::max(blackBody(kelvin), glm::vec3(0.01f));
    return gain / glm::dot(gain, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

SceneUniforms sceneUniforms(const Parameters& p, const CameraView& camera, float metresOfMesh)
{
    SceneUniforms u;
    u.clipFromWorld = camera.clipFromView * camera.viewFromWorld;
    u.worldFromClip = glm::inverse(u.clipFromWorld);
    u.eye = camera.eye;
    u.lightDirection = directionTo(p, kLights.front());
    const float turn = glm::radians(p.environmentYaw), angle = glm::radians(p.rotation);
    u.environmentTurn = {std::cos(turn), std::sin(turn)};
    // Scale, then turn, then shift, as KHR_texture_transform; but positive turns the picture counter-clockwise as seen (v runs down),
    // where the extension turns the uvs.
    const float c = std::cos(angle), s = std::sin(angle);
    u.textureFromMesh = glm::mat2(c, s, -s, c) * p.tiling;
    u.meshFromTexture = glm::inverse(u.textureFromMesh);
    u.textureShift = {p.offsetU, p.offsetV};
    u.reliefDepth = physicalDepth(p, metresOfMesh);
    u.exposureFactor = std::exp2(p.exposure) * whiteGain(p.whiteBalance);
    u.lookDirection = (camera.target - camera.eye) / camera.distance;
    return u;
}

namespace {
// See SceneUniforms::lights.
glm::mat4 told(const Parameters& p, const LightMembers& light, const Around& mesh)
{
    const bool near = isNear(p, light), isSpot = p.*light.kind == LightKind::Spot;
    const glm::vec3 towards = directionTo(p, light);
    const float distance = near ? distanceOf(p, light, mesh) : 1.f, size = distance * std::tan(0.5f * glm::radians(p.*light.size));
    const float halfAngle = 0.5f * glm::radians(p.*light.cone), edge = std::cos(halfAngle);
    const float slope = 1.f / std::max(std::cos(halfAngle * (1.f - p.*light.softness)) - edge, 1e-4f);
    const float least = near ? std::max(size, 0.01f * distance) : 0.f; // m: nearer it is not brighter
    return {glm::vec4(near ? mesh.middle + towards * distance : towards, near ? 1.f : 0.f),
        glm::vec4(p.*light.color * (p.*light.intensity * distance * distance), size),
        isSpot ? glm::vec4(-towards, -edge) : glm::vec4(0.f, 0.f, 0.f, 1.f),
        glm::vec4(isSpot ? slope : 1.f, least * least, p.*light.shadows ? 1.f : 0.f, &light == kLights.data() && !near ? 1.f : 0.f)};
}
} // namespace

void setLights(SceneUniforms& uniforms, const Parameters& parameters, const Around& mesh)
{
    std::size_t count = 0;
    for (const LightMembers& light : kLights)
        if (isLit(parameters, light))
            uniforms.lights[count++] = told(parameters, light, mesh);
    uniforms.lightCount = float(count);
}

} // namespace relievo
