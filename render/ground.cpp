// Drawing the floor under the mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/scoped_state.h"
#include "render/glow.h"
#include "render/passes.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace relievo {

namespace {
struct GroundPlace {
    glm::vec3 centre, half; // of the mesh with its relief, m
    float height, reach; // of the floor: y, and half its side
};

GroundPlace groundPlace(const Frame& frame)
{
    const Mesh& mesh = *frame.request.resources().mesh;
    const float out = std::max(frame.uniforms.pushOut, 0.f), radius = 0.5f * glm::length(mesh.boundsMax - mesh.boundsMin) + out + 1e-6f;
    const glm::vec3 half = glm::max(0.5f * (mesh.boundsMax - mesh.boundsMin) + out, glm::vec3(0.01f * radius));
    // A little lower: what lies flat on it must not flicker.
    return {0.5f * (mesh.boundsMin + mesh.boundsMax), half, mesh.boundsMin.y - out - 0.002f * radius, 5.f * radius};
}

// The mesh as the floor mirrors it, as dense as `groundReflection`; first its depth alone, so that what is hidden stays so.
void drawReflection(DrawContext& context, Frame& frame, float height)
{
    SceneUniforms uniforms = frame.uniforms;
    glm::mat4 mirror(1.f);
    mirror[1][1] = -1.f, mirror[3][1] = 2.f * height;
    uniforms.clipFromWorld = uniforms.clipFromWorld * mirror;
    uniforms.worldFromClip = glm::inverse(uniforms.clipFromWorld);
    uniforms.eye.y = 2.f * height - uniforms.eye.y;
    const ScopedMirror mirrored;
    {
        const ScopedDepthOnly depth;
        drawMesh(context, frame, frame.features, uniforms, true);
    }
    const ScopedEnable blending(GL_BLEND);
    const ScopedAtFarPlane again; // at the same depth
    glBlendColor(0.f, 0.f, 0.f, frame.parameters.groundReflection);
    glBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ZERO, GL_ONE);
    drawMesh(context, frame, frame.features, uniforms, true);
}
} // namespace

bool wantsGround(const Frame& frame)
{
    return frame.parameters.ground && frame.view.light == ViewLight::All && frame.uniforms.eye.y > groundPlace(frame).height;
}

void drawGround(DrawContext& context, Frame& frame)
{
    const bool linear = frame.request.target().linear;
    const GroundPlace place = groundPlace(frame);
    const ScopedEnable beyond(GL_DEPTH_CLAMP); // the far plane is fitted to the mesh
    if (frame.parameters.groundReflection > 0.f && frame.parameters.background != Backdrop::Transparent)
        drawReflection(context, frame, place.height);
    const LinkedProgram* program = context.programs.get(
        linear ? "ground/linear" : "ground", [&](const ShaderReader& read) { return groundProgram(linear, read); }, frame.error);
    if (!program)
        return;
    useProgram(context, frame, *program, frame.uniforms);
    program->set("groundPlace[0]", {glm::vec4(place.centre, place.height), glm::vec4(place.half, place.reach)});
    if (!context.noVertices)
        context.noVertices = newVertexArray();
    const ScopedUnlit unlit(frame.features.glows);
    const ScopedEnable blending(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(*context.noVertices);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glBindVertexArray(0);
}

} // namespace relievo
