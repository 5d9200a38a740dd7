// Off-screen targets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"

namespace relievo {

// An off-screen colour and depth target, whose colour can be read as a texture.
class Framebuffer {
public:
    Framebuffer() = default;
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;
    // Keeps what fits; floats: RGBA32F instead of RGBA8. What the driver cannot hold is an error, which drawing into it tells too.
    Expected<void> resize(int width, int height, bool floats = false);
    unsigned handle() const { return m_framebuffer; }
    unsigned texture() const { return m_color; }
    int width() const { return m_width; }
    int height() const { return m_height; }

private:
    unsigned m_framebuffer = 0, m_color = 0, m_depth = 0;
    int m_width = 0, m_height = 0;
    bool m_floats = false, m_isWhole = false;
};

} // namespace relievo
