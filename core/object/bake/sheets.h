// Sheets on axes that see them from their edge.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/bake/columns.h"

namespace relievo {

// Whether the axis is the one that a triangle faces most, or the only one that is baked; corners by u, v and depth.
bool isFacing(const AxisView& view, const std::array<glm::dvec3, 3>& corners);

// Adds to the texels of a band all that sheets not facing the axis touch, and one texel around, in depth too.
void addWideSheets(const AxisView& view, const Band& band, std::vector<Stretches>& texels);

} // namespace relievo
