// The depth that the light sees of a scene, for shadows between objects.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/shader_text/scene_uniforms.h"
#include "render/gl_objects.h"
#include <functional>

namespace relievo {

// The scene as a directional light sees it: parallel, its picture as large as the bounds with `margin` metres around. Only clipFromWorld,
// worldFromClip and eye (far away) differ from `uniforms`.
SceneUniforms lightUniforms(SceneUniforms uniforms, glm::vec3 boundsMin, glm::vec3 boundsMax, float margin);

// A depth texture with its framebuffer object, of one context.
class ShadowMap {
public:
    // Draws anew by `draw`, which finds the map bound and cleared. Leaves another framebuffer bound than before.
    void draw(int size, const std::function<void()>& draw);
    GLuint texture() const { return *m_texture; } // compares, filtered; beyond its border all is lit
    int size() const { return m_size; }

private:
    Texture m_texture;
    FramebufferName m_framebuffer;
    int m_size = 0;
};

} // namespace relievo
