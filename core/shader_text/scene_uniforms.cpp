// Uniforms derived from parameters and camera.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/scene_uniforms.h"
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
    u.lightDirection = directionTo(p.lightYaw, p.lightPitch);
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

} // namespace relievo
