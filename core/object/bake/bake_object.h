// Baking the maps of a relief object from a mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/object/bake/mesh_surface.h"
#include "core/object/bake/object_box.h"
#include "core/object/relief_object.h"

namespace relievo {

// Which sides hold depths: the front (+z) alone, whose object reaches back to the box's back; front and back; the fronts and backs of all
// three axes.
enum class ObjectSides { One = 1, Two = 2, Six = 6 };

struct ObjectOptions {
    ObjectSides sides = ObjectSides::Six;
    int layers = 1; // 1 to kMostLayers
    int size = 512; // texels along each side of a map, 1 to kLargestObjectMap
    int supersample = 2; // rays along each side of a texel, 1 to kMostRays
};
inline constexpr int kLargestObjectMap = 8192, kMostRays = 8;

// What of the three axes is baked.
std::array<bool, 3> axesOf(ObjectSides sides);

// The depths of all axes. A texel is as the ray through its middle says; where that meets nothing, as the nearest of its other rays that
// does: so no texel that any ray meets is empty. What is solid: TriangleKind. Where more intervals follow one another than there are
// layers, the narrowest gaps are closed. Sheets have no thickness on the axis that they face most; on the others, where they are seen from
// their edge, they reach over each texel that they touch and one texel further, as those may not cut away what the first one says.
// Warnings: "open-mesh", "facing-inwards", "flat-mesh", "layers-merged". Errors: cancelled; a mesh without extent; options out of range.
struct BakedDepths {
    ReliefObject object;
    ObjectBox box; // the object's
    Warnings warnings;
};
Expected<BakedDepths> bakeDepths(const MeshSurface& surface, const ObjectOptions& options, const Progress& progress = {});

} // namespace relievo
