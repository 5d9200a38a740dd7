// Off-screen targets that also keep the light of what is shown.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "render/gl/gl_objects.h"

namespace relievo {

FramebufferName newFramebuffer();
Texture newColors(GLint format, int width, int height, GLint filter); // RGBA, mirrored at its borders

// Off-screen, with two colours: what is shown, and the light of it before exposure and tone curve (shaders/glow/light.glsl).
class LightPicture {
public:
    // Keeps what fits; floats: what is shown is held in floats, else in bytes. What the driver cannot hold is an error.
    Expected<void> resize(int width, int height, bool floats);
    static void clear(); // the light of the one that is bound, to none
    unsigned framebuffer() const { return *m_framebuffer; }
    unsigned shown() const { return *m_shown; }
    unsigned light() const { return *m_light; }
    int width() const { return m_width; }
    int height() const { return m_height; }

private:
    FramebufferName m_framebuffer;
    Texture m_shown, m_light;
    Renderbuffer m_depth;
    int m_width = 0, m_height = 0;
    bool m_floats = false;
};

// Passes that show no light: they write the first colour alone of a target that keeps light.
class ScopedUnlit {
public:
    explicit ScopedUnlit(bool keepsLight);
    ~ScopedUnlit();
    ScopedUnlit(const ScopedUnlit&) = delete;
    ScopedUnlit& operator=(const ScopedUnlit&) = delete;

private:
    bool m_keepsLight;
};

} // namespace relievo
