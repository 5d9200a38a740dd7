// The acceleration map of a technique as a texture of the search: every mip level baked from that level's own heights.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"
#include <memory>
#include <string_view>
#include <vector>

namespace relievo {

struct BakedMapRow;

// The field's mip levels, finest first: areas averaged, sizes halved rounding down as OpenGL's, until neither exceeds 2 (so that
// maps of half the size have as many). Heights of fields with at most 16 stored bits are rounded to 16 bits, as they lie in the texture:
// bounds baked from them hold for what is drawn.
std::vector<HeightField> heightLevels(const HeightField& field);
int levelCount(const HeightField& field); // how many there are

// Level i belongs to heightLevels()[i]; texels are addressed like the heights', those of codes by 2 x 2, padded to sizes that halve. A
// pyramid is one image: level l (from 1 on; level 0 are the corners themselves) of height level i stands on shelf i + l, in slot l - 1.
// Shelf s has slots of ceil(W / 2^s) x ceil(H / 2^s) texels and lies below the shelves 1 to s - 1. A volume is one level: that of the
// finest heights serves all.
struct AccelerationMap {
    std::vector<Image> levels;
    int slices = 1; // of a volume, one below the other in the image
    MapForm form = MapForm::Filtered;
    std::vector<glm::vec4> scales; // BakedMap::scale of each height level
    std::size_t bytes() const;
};

inline constexpr int kMaxHeightLevels = 16; // room for scales in the shaders: textures of up to 32768 texels

// The same from maps baked already, one for each height level of `field` (a volume: the finest one's each time).
std::shared_ptr<const AccelerationMap> accelerationMapOf(
    const BakedMapRow& row, const std::vector<std::shared_ptr<const BakedMap>>& maps, const HeightField& field);

// `bound`: a row of kBakedMaps that a technique names. allLevels: for pictures with mip levels; else the finest only.
// Baked, or from the cache. Errors: those of the bake.
Expected<std::shared_ptr<const AccelerationMap>> makeAccelerationMap(
    std::string_view bound, const HeightField& field, const Parameters& parameters, bool allLevels, const Progress& progress = {});

} // namespace relievo
