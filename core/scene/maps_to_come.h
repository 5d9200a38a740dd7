// What is drawn in the place of maps whose files are still being read.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/choice.h"
#include "core/image/material.h"
#include <memory>

namespace relievo {

// The material with a map of each kind that is coming, so that the program that draws it is the one that draws it when they are there: what
// shaders read without a map, as a single texel, and as normals those of the heights, of fewer texels. depth: in tiles. The slots are those
// of the material: what stands in is none of its maps.
std::shared_ptr<const Material> withMapsToCome(const Material& material, EnumSet<MapKind> coming, float depth);

} // namespace relievo
