// Making and freeing off-screen targets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/framebuffer.h"
#include "render/gl/driver_limits.h"
#include "render/gl/gl_objects.h"

namespace relievo {

Framebuffer::~Framebuffer()
{
    if (!m_framebuffer)
        return;
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteTextures(1, &m_color);
    glDeleteRenderbuffers(1, &m_depth);
}

Expected<void> Framebuffer::resize(int width, int height, bool floats)
{
    if (m_framebuffer && width == m_width && height == m_height && floats == m_floats && m_isWhole)
        return {};
    m_width = width, m_height = height, m_floats = floats;
    if (!m_framebuffer) {
        glGenFramebuffers(1, &m_framebuffer);
        glGenTextures(1, &m_color);
        glGenRenderbuffers(1, &m_depth);
    }
    glBindTexture(GL_TEXTURE_2D, m_color);
    glTexImage2D(
        GL_TEXTURE_2D, 0, floats ? GL_RGBA32F : GL_RGBA8, width, height, 0, GL_RGBA, floats ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); // without levels
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_color, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    const auto drawable = canBeDrawnTo(width, height);
    m_isWhole = bool(drawable);
    return drawable;
}

} // namespace relievo
