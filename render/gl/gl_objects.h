// Owners of OpenGL names: deleted with the value, in the context that is current then.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <epoxy/gl.h>
#include <utility>

namespace relievo {

template <auto Delete> class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint name) : m_name(name) { }
    GlName(GlName&& other) noexcept : m_name(std::exchange(other.m_name, 0u)) { }
    GlName& operator=(GlName&& other) noexcept
    {
        std::swap(m_name, other.m_name);
        return *this;
    }
    ~GlName()
    {
        if (m_name)
            Delete(m_name);
    }
    GLuint operator*() const { return m_name; }
    explicit operator bool() const { return m_name != 0; }

private:
    GLuint m_name = 0;
};

inline void deleteTexture(GLuint name)
{
    glDeleteTextures(1, &name);
}
inline void deleteBuffer(GLuint name)
{
    glDeleteBuffers(1, &name);
}
inline void deleteVertexArray(GLuint name)
{
    glDeleteVertexArrays(1, &name);
}
inline void deleteFramebuffer(GLuint name)
{
    glDeleteFramebuffers(1, &name);
}
inline void deleteRenderbuffer(GLuint name)
{
    glDeleteRenderbuffers(1, &name);
}
inline void deleteShader(GLuint name)
{
    glDeleteShader(name);
}
inline void deleteProgram(GLuint name)
{
    glDeleteProgram(name);
}

using Texture = GlName<deleteTexture>;
using Buffer = GlName<deleteBuffer>;
using VertexArray = GlName<deleteVertexArray>;
using FramebufferName = GlName<deleteFramebuffer>;
using Renderbuffer = GlName<deleteRenderbuffer>;
using Shader = GlName<deleteShader>;
using Program = GlName<deleteProgram>;

inline Texture newTexture()
{
    GLuint name = 0;
    glGenTextures(1, &name);
    return Texture(name);
}
inline Buffer newBuffer()
{
    GLuint name = 0;
    glGenBuffers(1, &name);
    return Buffer(name);
}
inline VertexArray newVertexArray()
{
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return VertexArray(name);
}

} // namespace relievo
