// The six sides of a relief object, and how depths are kept in pictures of them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/object/relief_object.h"
#include <optional>
#include <string_view>

namespace relievo {

// The front and the back of each axis in turn. The pictures of both lie on the texels of the axis' map.
struct SideRow {
    std::string_view key, fileName; // NAME_PosX_Depth.png
    std::size_t axis;
    bool isBack;
};
inline constexpr std::array<SideRow, 6> kObjectSides{{
    {"+x", "PosX", 0, false},
    {"-x", "NegX", 0, true},
    {"+y", "PosY", 1, false},
    {"-y", "NegY", 1, true},
    {"+z", "PosZ", 2, false},
    {"-z", "NegZ", 2, true},
}};

// One layer as a side's picture, 16 bits: how far below the side's face the surface lies, 0 on it, 65535 on the opposite one; 65535 on both
// sides of an axis, or on the only one that is there: nothing.
Image depthPicture(const AxisMap& map, int layer, bool isBack);

// Sets one layer from the pictures of its sides, which are as large as the map; of 8 bits too. Null: the solid reaches to that side.
void setLayer(AxisMap& map, int layer, const Image* front, const Image* back);

} // namespace relievo
