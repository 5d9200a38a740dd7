// Uniforms derived from parameters and camera.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/scene_uniforms.h"
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

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
    u.exposureFactor = std::exp2(p.exposure);
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
