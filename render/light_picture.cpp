// Making targets of two colours.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light_picture.h"
#include "render/gl/driver_limits.h"
#include <array>

namespace relievo {

namespace {
constexpr std::array<GLenum, 2> kBoth = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
} // namespace

FramebufferName newFramebuffer()
{
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return FramebufferName(name);
}

Texture newColors(GLint format, int width, int height, GLint filter)
{
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

Expected<void> LightPicture::resize(int width, int height, bool floats)
{
    if (m_framebuffer && width == m_width && height == m_height && floats == m_floats)
        return {};
    if (!m_framebuffer)
        m_framebuffer = newFramebuffer();
    m_width = width, m_height = height, m_floats = floats;
    m_shown = newColors(floats ? GL_RGBA32F : GL_RGBA8, width, height, GL_NEAREST);
    m_light = newColors(GL_RGBA16F, width, height, GL_NEAREST);
    if (!m_depth) {
        GLuint name = 0;
        glGenRenderbuffers(1, &name);
        m_depth = Renderbuffer(name);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, *m_depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, *m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, kBoth[0], GL_TEXTURE_2D, *m_shown, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, kBoth[1], GL_TEXTURE_2D, *m_light, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, *m_depth);
    glDrawBuffers(2, kBoth.data());
    const auto drawable = canBeDrawnTo(width, height);
    if (!drawable)
        m_width = m_height = 0;
    return drawable;
}

void LightPicture::clear()
{
    constexpr std::array<float, 4> kNone{};
    glClearBufferfv(GL_COLOR, 1, kNone.data());
}

ScopedUnlit::ScopedUnlit(bool keepsLight) : m_keepsLight(keepsLight)
{
    if (m_keepsLight)
        glDrawBuffers(1, kBoth.data());
}

ScopedUnlit::~ScopedUnlit()
{
    if (m_keepsLight)
        glDrawBuffers(2, kBoth.data());
}

} // namespace relievo
