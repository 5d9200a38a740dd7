// The uniforms that are computed from a State rather than edited: one row each, next to the parameters' rows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/camera_view.h"
#include "core/state/lights.h"
#include <array>
#include <glm/mat2x2.hpp>
#include <glm/mat4x4.hpp>
#include <string_view>
#include <variant>

namespace relievo {

struct SceneUniforms {
    glm::mat4 clipFromWorld{1.f};
    glm::mat4 worldFromClip{1.f};
    glm::vec3 eye{0.f}; // m
    glm::vec3 lightDirection{0.f}; // unit, towards the light
    glm::vec2 environmentTurn{1.f, 0.f}; // cosine and sine of environmentYaw
    glm::mat2 textureFromMesh{1.f}; // uv of the texture from the mesh's: turn and tiling
    glm::mat2 meshFromTexture{1.f}; // its inverse
    glm::vec2 textureShift{0.f};
    float reliefDepth = 0.f; // D, m
    float pushOut = 0.f; // how far the mesh is pushed out so that the midlevel lies on it, m
    glm::vec3 exposureFactor{1.f}; // 2^exposure, and the white balance
    glm::vec3 lookDirection{0.f, 0.f, -1.f}; // unit, of the camera
    float heatScale = 1.f; // of the view's value to [0, 1]
    glm::mat4 shadowFromWorld{1.f}; // clip space of the light's map
    float shadowTexel = 0.f; // its texel's size, m
    float lightCount = 0.f; // of several lights (setLights); one directional light is lightDirection
    std::array<glm::mat4, kMostLights> lights{}; // what each is, column by column: where or whither, w: near; radiance, size; axis, cone's
                                                 // edge; cone's slope, least distance, casts, passes (shaders/shading/light_table.glsl)
    glm::mat4 worldFromBox{1.f}; // of a relief object, whose box reaches from -1 to 1; 1 without
    glm::mat4 boxFromWorld{1.f};
    float sampleTurn = 0.f; // of noise from sample to sample, share of a whole turn; 0 in a picture of one sample
};

using SceneMember = std::variant<float SceneUniforms::*, glm::vec2 SceneUniforms::*, glm::vec3 SceneUniforms::*, glm::mat2 SceneUniforms::*,
    glm::mat4 SceneUniforms::*, std::array<glm::mat4, kMostLights> SceneUniforms::*>;
struct SceneUniformRow {
    SceneMember member;
    std::string_view name;
};
inline constexpr auto kSceneUniforms = std::to_array<SceneUniformRow>({
    {&SceneUniforms::clipFromWorld, "clipFromWorld"},
    {&SceneUniforms::worldFromClip, "worldFromClip"},
    {&SceneUniforms::eye, "eye"},
    {&SceneUniforms::lightDirection, "lightDirection"},
    {&SceneUniforms::environmentTurn, "environmentTurn"},
    {&SceneUniforms::textureFromMesh, "textureFromMesh"},
    {&SceneUniforms::meshFromTexture, "meshFromTexture"},
    {&SceneUniforms::textureShift, "textureShift"},
    {&SceneUniforms::reliefDepth, "reliefDepth"},
    {&SceneUniforms::pushOut, "pushOut"},
    {&SceneUniforms::exposureFactor, "exposureFactor"},
    {&SceneUniforms::lookDirection, "lookDirection"},
    {&SceneUniforms::heatScale, "heatScale"},
    {&SceneUniforms::shadowFromWorld, "shadowFromWorld"},
    {&SceneUniforms::shadowTexel, "shadowTexel"},
    {&SceneUniforms::lightCount, "lightCount"},
    {&SceneUniforms::lights, "lights"},
    {&SceneUniforms::worldFromBox, "worldFromBox"},
    {&SceneUniforms::boxFromWorld, "boxFromWorld"},
    {&SceneUniforms::sampleTurn, "sampleTurn"},
});

// What makes a grey that is lit by a black body of `kelvin` (1667 to 25000) as grey as one at 6500 K leaves it: linear sRGB, its luminance
// is 1. Chromaticities of the Planckian locus after Kim et al. 2002 (US patent 7024034); von Kries' rule in linear sRGB.
glm::vec3 whiteGain(float kelvin);

// All of them for a view of the mesh; metresOfMesh is Mesh::metresPerUV.
SceneUniforms sceneUniforms(const Parameters& parameters, const CameraView& camera, float metresOfMesh);

// The lights that are on, around a mesh.
void setLights(SceneUniforms& uniforms, const Parameters& parameters, const Around& mesh);

} // namespace relievo
