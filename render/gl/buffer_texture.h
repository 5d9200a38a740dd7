// A texture that is a buffer of four floats a texel, for lists that a shader reads by index.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "render/gl/gl_objects.h"
#include <glm/vec4.hpp>
#include <span>

namespace relievo {

class BufferTexture {
public:
    // On the texture unit that is active. usage: GL_STATIC_DRAW, or GL_STREAM_DRAW for what changes with each picture.
    void fill(std::span<const glm::vec4> texels, GLenum usage)
    {
        const bool isNew = !m_texture;
        if (isNew)
            m_buffer = newBuffer(), m_texture = newTexture();
        glBindBuffer(GL_TEXTURE_BUFFER, *m_buffer);
        glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(texels.size_bytes()), texels.data(), usage);
        glBindTexture(GL_TEXTURE_BUFFER, *m_texture);
        if (isNew)
            glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, *m_buffer);
    }
    GLuint texture() const { return *m_texture; } // 0 before the first fill

private:
    Buffer m_buffer;
    Texture m_texture;
};

} // namespace relievo
