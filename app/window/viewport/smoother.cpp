// Adding up pictures on the CPU, where sums have room; one upload shows them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/smoother.h"
#include "render/windowless.h"
#include <cassert>
#include <epoxy/gl.h>

namespace relievo {
Smoother::~Smoother()
{
    if (!m_texture)
        return;
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteTextures(1, &m_texture);
}

glm::vec2 Smoother::nextShift() const
{
    return pixelShift(m_count);
}

glm::vec2 Smoother::nextLens() const
{
    return lensPoint(m_count);
}

void Smoother::add(const Framebuffer& picture)
{
    const std::size_t values = std::size_t(picture.width()) * std::size_t(picture.height()) * 4;
    if (m_count == 0) {
        m_width = picture.width(), m_height = picture.height();
        m_sums.assign(values, 0);
        m_pixels.resize(values);
    }
    assert(m_sums.size() == values && m_count < 256);
    glBindFramebuffer(GL_FRAMEBUFFER, picture.handle());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, m_pixels.data());
    for (std::size_t i = 0; i < values; ++i)
        m_sums[i] = std::uint16_t(m_sums[i] + m_pixels[i]);
    ++m_count;
}

void Smoother::upload()
{
    for (std::size_t i = 0; i < m_sums.size(); ++i)
        m_pixels[i] = std::uint8_t((m_sums[i] + m_count / 2) / m_count);
    if (!m_texture) {
        glGenTextures(1, &m_texture);
        glGenFramebuffers(1, &m_framebuffer);
    }
    glBindTexture(GL_TEXTURE_2D, m_texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, m_width, m_height, 0, GL_RGBA, GL_UNSIGNED_BYTE, m_pixels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
    m_uploaded = m_count;
}

unsigned Smoother::texture()
{
    if (m_uploaded != m_count)
        upload();
    return m_texture;
}

unsigned Smoother::framebuffer()
{
    texture();
    return m_framebuffer;
}

void Smoother::copyTo(unsigned framebuffer, const PaneArea& to)
{
    texture();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, m_width, m_height, to.x, to.y, to.x + to.width, to.y + to.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

} // namespace relievo
