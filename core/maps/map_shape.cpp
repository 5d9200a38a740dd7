// Shapes of stored maps by their forms.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/map_shape.h"
#include "core/maps/maps.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace relievo {

namespace {
std::vector<MapShape::Level> levelsOf(const BakedMapRow& row, int width, int height)
{
    switch (row.form) {
    case MapForm::Filtered:
    case MapForm::Layers:
        break;
    case MapForm::Codes:
        return {{(width + 1) / 2, (height + 1) / 2}};
    case MapForm::Volume:
        return {{std::min(width, kDistanceSize), std::min(height, kDistanceSize) * row.slices}};
    case MapForm::Pyramid: {
        std::vector<MapShape::Level> levels{{width, height}};
        while (levels.back().width > 1 || levels.back().height > 1)
            levels.push_back({(levels.back().width + 1) / 2, (levels.back().height + 1) / 2});
        return levels;
    }
    }
    return {{width, height * row.slices}};
}

// (lowest, highest - lowest, steepest, highest), see cell_cones.h.
bool areScalesOfCodes(glm::vec4 scale, float lowest, float highest)
{
    return scale.x >= 0.f && scale.x <= lowest && scale.w >= highest && scale.w <= 1.f && scale.y >= 0.f && scale.x + scale.y >= highest
        && scale.x + scale.y < 1.f + 1e-6f && scale.z >= 0.f && std::isfinite(scale.z);
}

// Of heights and the like, which lie in [0, 1]: 1. Of roots: whatever the largest value was.
bool isScaleOf(const ChannelRule& rule, float scale)
{
    return rule.encoding == Encoding::SquareRoot ? scale > 0.f && std::isfinite(scale) : scale == 1.f;
}

bool areNumbers(const Image& level)
{
    for (std::size_t i = 0; level.type == PixelType::F32 && i < level.texelCount() * std::size_t(level.channels); ++i)
        if (float value = 0.f; std::memcpy(&value, level.data.data() + 4 * i, 4), !std::isfinite(value))
            return false;
    return true;
}
} // namespace

MapShape shapeOf(const BakedMapRow& row, const HeightField& field)
{
    const PixelType type = row.bits == 8 ? PixelType::U8 : row.bits == 16 ? PixelType::U16 : PixelType::F32;
    return {levelsOf(row, field.width(), field.height()), row.slices, row.channels, type};
}

MapShape shapeOf(const BakedMap& map)
{
    std::vector<MapShape::Level> levels;
    for (const Image& level : map.levels)
        levels.push_back({level.width, level.height});
    return {levels, map.slices, map.levels.front().channels, map.levels.front().type};
}

bool hasSoundValues(const BakedMapRow& row, const HeightField& field, const BakedMap& map)
{
    const auto [lowest, highest] = std::ranges::minmax(field.texels());
    if (row.form == MapForm::Codes)
        return areScalesOfCodes(map.scale, lowest, highest);
    if (row.form == MapForm::Pyramid && map.levels.back().value(0, 0, 0) < highest)
        return false;
    for (int c = 0; c < 4; ++c)
        if (!isScaleOf(c < row.channels ? row.rules[std::size_t(c)] : ChannelRule{}, map.scale[c]))
            return false;
    return std::ranges::all_of(map.levels, areNumbers);
}

} // namespace relievo
