// OpenGL state that a pass changes and that is as before when it ends.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <epoxy/gl.h>

namespace relievo {

// A capability that is off outside of passes.
class ScopedEnable {
public:
    explicit ScopedEnable(GLenum capability) : m_capability(capability) { glEnable(capability); }
    ~ScopedEnable() { glDisable(m_capability); }
    ScopedEnable(const ScopedEnable&) = delete;
    ScopedEnable& operator=(const ScopedEnable&) = delete;

private:
    GLenum m_capability;
};

// Depth alone is written.
class ScopedDepthOnly {
public:
    ScopedDepthOnly() { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); }
    ~ScopedDepthOnly() { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }
    ScopedDepthOnly(const ScopedDepthOnly&) = delete;
    ScopedDepthOnly& operator=(const ScopedDepthOnly&) = delete;
};

// Triangles are drawn as lines. Lines more than a pixel wide are an error in contexts without what is deprecated.
// As a mirror has it: clockwise triangles are the front.
class ScopedMirror {
public:
    ScopedMirror() { glFrontFace(GL_CW); }
    ~ScopedMirror() { glFrontFace(GL_CCW); }
    ScopedMirror(const ScopedMirror&) = delete;
    ScopedMirror& operator=(const ScopedMirror&) = delete;
};

class ScopedLines {
public:
    explicit ScopedLines(float pixels)
    {
        GLint flags = 0;
        glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glLineWidth(flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT && pixels > 1.f ? 1.f : pixels);
    }
    ~ScopedLines() { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }
    ScopedLines(const ScopedLines&) = delete;
    ScopedLines& operator=(const ScopedLines&) = delete;
};

// What lies at the far end of the depth range passes the depth test.
class ScopedAtFarPlane {
public:
    ScopedAtFarPlane() { glDepthFunc(GL_LEQUAL); }
    ~ScopedAtFarPlane() { glDepthFunc(GL_LESS); }
    ScopedAtFarPlane(const ScopedAtFarPlane&) = delete;
    ScopedAtFarPlane& operator=(const ScopedAtFarPlane&) = delete;
};

} // namespace relievo
