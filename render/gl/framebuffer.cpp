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
    glDeleteRenderbuffers(1, &m_color);
    glDeleteRenderbuffers(1, &m_depth);
}

Expected<void> Framebuffer::resize(int width, int height, bool floats)
{
    if (m_framebuffer && width == m_width && height == m_height && floats == m_floats && m_isWhole)
        return {};
    m_width = width, m_height = height, m_floats = floats;
    if (!m_framebuffer) {
        glGenFramebuffers(1, &m_framebuffer);
        glGenRenderbuffers(1, &m_color);
        glGenRenderbuffers(1, &m_depth);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, m_color);
    glRenderbufferStorage(GL_RENDERBUFFER, floats ? GL_RGBA32F : GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_color);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    const auto drawable = canBeDrawnTo(width, height);
    m_isWhole = bool(drawable);
    return drawable;
}

} // namespace relievo
