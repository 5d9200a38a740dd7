// Sheets on axes that see them from their edge.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/bake/columns.h"

namespace relievo {

// Whether the axis is the one that a triangle faces most, or the only one that is baked; corners by u, v and depth.
bool isFacing(const AxisView& view, const std::array<glm::dvec3, 3>& corners);

struct SheetRows {
    int size = 0, first = 0, count = 0; // of the map; the band's rows
};
// Adds to the texels of a band all that sheets not facing the axis touch, and one texel around, in depth too.
void addWideSheets(const AxisView& view, std::span<const std::uint32_t> triangles, SheetRows rows, std::vector<Stretches>& texels);

} // namespace relievo
