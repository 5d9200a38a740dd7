// A relief object in one OpenGL context: the intervals that it is searched by, and the pictures of its sides.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/object_file.h"
#include "render/gl/gl_objects.h"
#include "render/gl/program.h"

namespace relievo {

class ObjectUpload {
public:
    // Binds what the program reads; uploads it the first time. Always the same object.
    void bind(const LinkedProgram& program, const ObjectMaps& maps);

    int textureCount() const { return (m_texels ? 1 : 0) + (m_colors ? 1 : 0) + (m_normals ? 1 : 0); }

private:
    Buffer m_buffer;
    Texture m_texels, m_colors, m_normals;
    float m_levels = 0.f; // log2 of the longest side of the pictures
};

} // namespace relievo
