// The passes of a picture, in the order in which they are drawn.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "render/frame.h"
#include <array>
#include <string_view>

namespace relievo {

struct PassRow {
    std::string_view key;
    bool (*isWanted)(const Frame& frame); // else it costs nothing
    void (*draw)(DrawContext& context, Frame& frame); // into the target, which is bound; leaves it bound and OpenGL's state as it was
};

// Light's view of the scene, for shadows between objects; later passes read it.
bool wantsShadowMap(const Frame& frame);
void drawShadowMap(DrawContext& context, Frame& frame);

// The mesh.
bool wantsSurface(const Frame& frame);
void drawSurface(DrawContext& context, Frame& frame);

// The edges of its triangles, over it.
bool wantsWireframe(const Frame& frame);
void drawWireframe(DrawContext& context, Frame& frame);

// The surroundings, behind it.
bool wantsBackground(const Frame& frame);
void drawBackground(DrawContext& context, Frame& frame);

// The floor under it: shadow and reflection over what is behind the mesh.
bool wantsGround(const Frame& frame);
void drawGround(DrawContext& context, Frame& frame);

inline constexpr auto kPasses = std::to_array<PassRow>({
    {.key = "shadow-map", .isWanted = wantsShadowMap, .draw = drawShadowMap},
    {.key = "surface", .isWanted = wantsSurface, .draw = drawSurface},
    {.key = "wireframe", .isWanted = wantsWireframe, .draw = drawWireframe},
    {.key = "background", .isWanted = wantsBackground, .draw = drawBackground},
    {.key = "ground", .isWanted = wantsGround, .draw = drawGround},
});

// The mesh as `features` and `uniforms` have it, for the surface and for what the light sees of it. intoShadowMap: only the depth counts.
void drawMesh(DrawContext& context, Frame& frame, const ProgramFeatures& features, const SceneUniforms& uniforms, bool intoShadowMap);

} // namespace relievo
