// The depth that the light sees of a scene, for shadows between objects.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/shader_text/scene_uniforms.h"
#include "core/state/parameters.h"
#include "render/gl/gl_objects.h"
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace relievo {

// The scene as a directional light sees it: parallel, its picture as large as the bounds with `margin` metres around. Only clipFromWorld,
// worldFromClip and eye (far away) differ from `uniforms`.
SceneUniforms lightUniforms(SceneUniforms uniforms, glm::vec3 boundsMin, glm::vec3 boundsMax, float margin);

// What a shadow map shows; where it is the same, the map is.
struct ShadowCause {
    Parameters parameters; // those that affect it, the others by default
    std::string technique, part;
    std::shared_ptr<const void> mesh, material, acceleration;
    bool operator==(const ShadowCause&) const = default;
};

// A depth texture with its framebuffer object, of one context.
class ShadowMap {
public:
    // Draws anew by `draw`, which finds the map bound and cleared, unless `cause` is the last one's. May leave another framebuffer bound.
    void draw(const ShadowCause& cause, const std::function<void()>& draw);
    GLuint texture() const { return *m_texture; } // compares, filtered; beyond its border all is lit

private:
    Texture m_texture;
    FramebufferName m_framebuffer;
    int m_size = 0;
    std::optional<ShadowCause> m_cause;
};

} // namespace relievo
