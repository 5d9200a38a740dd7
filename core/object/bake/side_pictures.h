// What a mesh looks like from the sides of its box: colour, normal and roughness where a ray from outside meets it first.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/bake/bake_object.h"
#include "core/object/bake/object_box.h"

namespace relievo {

// All lie on the texels of the axis' map, those of its back too: seen from behind they are mirrored. 16 bits a channel. Means of a texel's
// rays that meet something; texels without any go on from their neighbours, so that mip levels have no seams.
struct SidePictures {
    Image color; // r g b sRGB, a: the share of the texel's rays that meet something; not premultiplied
    Image normal; // n / 2 + 1 / 2: red along u, green against v (up), blue out of the side
    Image roughness;
};

// front: seen along the depth; else from the other end of the axis.
struct AxisPictures {
    SidePictures front, back;
};
// The rays are those of the options. Materials are read bilinearly. Errors: cancelled.
Expected<AxisPictures> bakePictures(
    const MeshSurface& surface, const ObjectBox& box, std::size_t axis, const ObjectOptions& options, const Progress& progress = {});

} // namespace relievo
