// Uniforms derived from parameters and camera.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/scene_uniforms.h"
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
    u.exposureFactor = std::exp2(p.exposure);
    return u;
}

} // namespace relievo
