// A map computed from a height field, as it lies in a texture, and how its values are stored safely.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace relievo {

// value of channel c = scale[c] x decoded(stored), where stored is in [0, 1] for integers and as it is for floats.
struct BakedMap {
    std::vector<Image> levels; // one; a pyramid has one for each of its levels, finest first
    int slices = 1; // of a volume: its image holds them one below the other
    glm::vec4 scale{1.f};

    std::size_t bytes() const
    {
        std::size_t sum = 0;
        for (const Image& level : levels)
            sum += level.data.size();
        return sum;
    }
};

// How a map is read: filtered, by the nodes of a pyramid, as codes (whole numbers of 16 bits, baked as they are stored), filtered in a
// volume, or filtered in layers, each by itself.
enum class MapForm { Filtered, Pyramid, Codes, Volume, Layers };

// Which way a value moves when it is stored in fewer bits. A bound moves to its safe side, so that it still bounds.
enum class Rounding { Nearest, Down, Up };
// SquareRoot: the root is stored and squared after filtering. The square of interpolated roots is at most the interpolated values
// (Jensen), so a value that was safe when rounded down stays so.
enum class Encoding { Linear, SquareRoot };
struct ChannelRule {
    Rounding rounding = Rounding::Nearest;
    Encoding encoding = Encoding::Linear;
};

} // namespace relievo
