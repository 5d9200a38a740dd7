// Drawing the mesh, what the light sees of it, its edges and what is behind it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/passes.h"
#include "render/clear_target.h"
#include "render/gl/scoped_state.h"
#include "render/glow.h"
#include "render/pane_values.h"
#include <glm/geometric.hpp>
#include <utility>

namespace relievo {

namespace {
constexpr std::array<MeshUpload::Parts, 2> kAllParts = {MeshUpload::Parts::Relief, MeshUpload::Parts::Plain};

// Draws parts of the mesh, one call after the other, and changes programs only where it must.
class MeshDrawing {
public:
    MeshDrawing(DrawContext& context, Frame& frame, const ProgramFeatures& features, const SceneUniforms& uniforms)
        : m_context(context)
        , m_frame(frame)
        , m_features(features)
        , m_uniforms(uniforms)
    {
    }

    // polygons: bare, without relief, for their depth.
    void all(bool polygons)
    {
        for (const MeshUpload::Parts parts : kAllParts)
            if (m_context.mesh.has(parts, m_frame.request.state().part))
                draw(parts, polygons);
    }

private:
    // The parts with relief by the features, the plain ones by what is left of them without.
    void draw(MeshUpload::Parts parts, bool polygons)
    {
        const bool plain = parts == MeshUpload::Parts::Plain;
        const ProgramFeatures features = plain ? withoutRelief(m_features) : m_features;
        const SceneUniforms uniforms = plain ? withoutRelief(m_uniforms) : m_uniforms;
        const LinkedProgram* program
            = polygons ? m_context.polygonProgramFor(features.posed, m_frame.error) : m_context.meshProgramFor(features, m_frame.error);
        if (!program)
            return;
        if (program != std::exchange(m_ready, program) || parts != std::exchange(m_readyFor, parts))
            useProgram(m_context, m_frame, *program, uniforms);
        const bool bends = features.curved && !features.prisms && !polygons;
        m_context.mesh.draw(*program, parts, m_frame.request.state().part, uniforms.pushOut != 0.f,
            bends ? m_frame.parameters.silhouettes : Silhouettes::Off, m_frame.fewerTriangles);
    }

    DrawContext& m_context;
    Frame& m_frame;
    const ProgramFeatures& m_features;
    const SceneUniforms& m_uniforms;
    const LinkedProgram* m_ready = nullptr; // for the parts m_readyFor
    MeshUpload::Parts m_readyFor = MeshUpload::Parts::Relief;
};
} // namespace

// First all faces towards the eye: those behind them fail the depth test before they are searched. Where the front is cut off, or writes a
// depth of its own, the inside must not show: of a closed mesh no other faces are drawn, and of others what lies behind the front's
// polygons is hidden (not in a shadow map, whose depth is what counts). Without silhouettes, holes of the material show it.
void drawMesh(DrawContext& context, Frame& frame, const ProgramFeatures& features, const SceneUniforms& uniforms, bool intoShadowMap)
{
    MeshDrawing drawing(context, frame, features, uniforms);
    if (frame.technique.isOfObjects) { // seen through its far faces: each ray once, from inside too
        const ScopedEnable culling(GL_CULL_FACE);
        glCullFace(GL_FRONT);
        return drawing.all(false);
    }
    const bool covers = features.curved || (features.variant(&Parameters::depthOfHit) != 0 && !features.maps.contains(MapKind::Opacity));
    if (!covers && context.mesh.isFinerThanPixels())
        return drawing.all(false);
    const bool backs = !covers || context.mesh.showsBacks(uniforms.eye, uniforms.pushOut);
    const ScopedEnable culling(GL_CULL_FACE);
    glCullFace(GL_BACK);
    drawing.all(false);
    if (covers && backs && !intoShadowMap) {
        const ScopedDepthOnly depth;
        drawing.all(true);
    }
    glCullFace(GL_FRONT);
    if (backs)
        drawing.all(false);
}

bool wantsShadowMap(const Frame& frame)
{
    return frame.features.objectShadows || wantsGround(frame);
}

// As deep as the relief is there; sets the uniforms by which it is read.
void drawShadowMap(DrawContext& context, Frame& frame)
{
    const Mesh& mesh = *frame.request.resources().mesh;
    const SceneUniforms light = lightUniforms(frame.uniforms, mesh.boundsMin, mesh.boundsMax, frame.uniforms.pushOut);
    const ShadowCause cause{onlyAffecting(Affects::ShadowMap, frame.parameters), frame.features.technique, frame.request.state().part,
        frame.request.resources().mesh, frame.request.resources().material, frame.acceleration};
    context.shadowMaps[frame.request.pane()].draw(cause, [&] {
        const bool coarse = std::exchange(frame.fewerTriangles, false);
        drawMesh(context, frame, intoShadowMap(frame.features, frame.technique), light, true);
        frame.fewerTriangles = coarse;
    });
    const glm::mat4& clip = light.clipFromWorld;
    frame.uniforms.shadowFromWorld = clip;
    frame.uniforms.shadowTexel = 2.f / (glm::length(glm::vec3(clip[0][0], clip[1][0], clip[2][0])) * float(frame.parameters.shadowMapSize));
    bindTarget(frame.request.target());
}

bool wantsSurface(const Frame&)
{
    return true;
}

void drawSurface(DrawContext& context, Frame& frame)
{
    drawMesh(context, frame, frame.features, frame.uniforms, false);
}

bool wantsWireframe(const Frame& frame)
{
    return frame.parameters.wireframe;
}

void drawWireframe(DrawContext& context, Frame& frame)
{
    const LinkedProgram* program = context.polygonProgramFor(frame.features.posed, frame.error);
    if (!program)
        return;
    const ScopedUnlit unlit(frame.features.glows);
    const ScopedLines lines(frame.request.target().lineWidth);
    const ScopedEnable blending(GL_BLEND), offset(GL_POLYGON_OFFSET_LINE);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE); // alpha stays the mesh's
    glPolygonOffset(-1.f, -1.f);
    for (const MeshUpload::Parts parts : kAllParts) {
        const SceneUniforms uniforms = parts == MeshUpload::Parts::Plain ? withoutRelief(frame.uniforms) : frame.uniforms;
        useProgram(context, frame, *program, uniforms);
        context.mesh.draw(*program, parts, frame.request.state().part, uniforms.pushOut != 0.f, Silhouettes::Off, frame.fewerTriangles);
    }
}

bool wantsBackground(const Frame& frame)
{
    const Backdrop behind = frame.parameters.background;
    return (behind == Backdrop::Environment || behind == Backdrop::Gradient) && !frame.view.isHeat;
}

void drawBackground(DrawContext& context, Frame& frame)
{
    const Backdrop behind = frame.parameters.background;
    std::string name
        = "background/" + std::string(wordOf(behind)) + (frame.features.linear ? "/linear" : "") + (frame.features.glows ? "/light" : "");
    for (const ParameterRow& row : kParameters)
        if (row.shader.place == ShaderPlace::Display)
            name += '/' + std::to_string(frame.features.variant(row.member));
    const LinkedProgram* program = context.programs.get(
        name, [&](const ShaderReader& read) { return backgroundProgram(behind, frame.features, read); }, frame.error);
    if (!program)
        return;
    useProgram(context, frame, *program, frame.uniforms);
    if (!context.noVertices)
        context.noVertices = newVertexArray();
    const ScopedUnlit unlit(frame.features.glows && behind == Backdrop::Gradient);
    const ScopedAtFarPlane far;
    glBindVertexArray(*context.noVertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace relievo
