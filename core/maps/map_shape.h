// What a stored map of a row looks like: what is read back from a file must be that, whatever its checksum says.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include <vector>

namespace relievo {

struct BakedMapRow;

struct MapShape {
    struct Level {
        int width, height; // texels; of a volume all slices
        bool operator==(const Level&) const = default;
    };
    std::vector<Level> levels;
    int slices, channels;
    PixelType type;
    bool operator==(const MapShape&) const = default;
};

// Of the row's map of a field, stored in row.bits. The row must be one that is baked from heights.
MapShape shapeOf(const BakedMapRow& row, const HeightField& field);
MapShape shapeOf(const BakedMap& map); // as it is; at least one level

// Whether the scales are ones that the row's bake gives, and bound the field's heights where a search relies on it. The shape is right.
bool hasSoundValues(const BakedMapRow& row, const HeightField& field, const BakedMap& map);

} // namespace relievo
