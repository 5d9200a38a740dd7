// The borders of a mesh as a texture buffer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "render/gl_objects.h"

namespace relievo {

// What shaders/borders_cut.glsl reads: first and count of each triangle, then the segments, RGBA32F. No texture for a mesh without borders.
struct BorderUpload {
    Buffer buffer;
    Texture texture;
};
BorderUpload uploadBorders(const Mesh& mesh);

} // namespace relievo
