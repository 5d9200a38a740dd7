// Rendering depth from the light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shadow_map.h"
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace relievo {

SceneUniforms lightUniforms(SceneUniforms uniforms, glm::vec3 boundsMin, glm::vec3 boundsMax, float margin)
{
    const glm::vec3 centre = 0.5f * (boundsMin + boundsMax), light = uniforms.lightDirection;
    const float radius = 0.5f * glm::length(boundsMax - boundsMin) + margin + 1e-6f;
    const glm::vec3 right
        = glm::normalize(glm::cross(std::abs(light.y) < 0.9f ? glm::vec3(0.f, 1.f, 0.f) : glm::vec3(1.f, 0.f, 0.f), light));
    const glm::vec3 up = glm::cross(light, right);
    const glm::mat4 viewFromWorld(glm::vec4(right.x, up.x, light.x, 0.f), glm::vec4(right.y, up.y, light.y, 0.f),
        glm::vec4(right.z, up.z, light.z, 0.f), glm::vec4(-glm::dot(right, centre), -glm::dot(up, centre), -glm::dot(light, centre), 1.f));
    uniforms.clipFromWorld = glm::ortho(-radius, radius, -radius, radius, -radius, radius) * viewFromWorld;
    uniforms.worldFromClip = glm::inverse(uniforms.clipFromWorld);
    uniforms.eye = centre + light * (radius * 1e4f); // so far that its rays are parallel
    return uniforms;
}

void ShadowMap::draw(const ShadowCause& cause, const std::function<void()>& draw)
{
    if (m_cause == cause)
        return;
    m_cause = cause;
    const int size = cause.parameters.shadowMapSize;
    if (!m_framebuffer) {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        m_framebuffer = FramebufferName(name);
        m_texture = newTexture();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, *m_framebuffer);
    if (size != m_size) {
        m_size = size;
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, *m_texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size, size, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
        const float lit[] = {1.f, 1.f, 1.f, 1.f};
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
        for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_BORDER);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, *m_texture, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    glViewport(0, 0, size, size);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw();
}

} // namespace relievo
