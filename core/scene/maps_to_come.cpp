// Single texels, and normals of a sampled height field.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/maps_to_come.h"
#include "core/maps/surface/normal.h"
#include <algorithm>
#include <cstdlib>

namespace relievo {
namespace {
constexpr int kNormals = 512; // texels a side of the normals that stand in, at most about

// The constant of the row, a GLSL expression of one number.
Image texelOf(const MapKindRow& kind)
{
    const std::string text(kind.withoutMap.substr(kind.withoutMap.find('(') + 1)); // past the name of a vector
    const std::vector<float> values(std::size_t(kind.channels), std::strtof(text.c_str(), nullptr));
    Image image{1, 1, kind.channels, PixelType::F32, 32, true, {}};
    image.data.resize(values.size() * sizeof(float));
    std::memcpy(image.data.data(), values.data(), image.data.size());
    return image;
}

Image sampledNormals(const HeightField& heights, float depth)
{
    const int step = std::max(1, std::max(heights.width(), heights.height()) / kNormals);
    const int width = (heights.width() + step - 1) / step, height = (heights.height() + step - 1) / step;
    std::vector<float> sampled;
    sampled.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < heights.height(); y += step)
        for (int x = 0; x < heights.width(); x += step)
            sampled.push_back(heights.texel(x, y));
    return normalFromHeight(HeightField(width, height, std::move(sampled)), depth);
}
} // namespace

std::shared_ptr<const Material> withMapsToCome(const Material& material, EnumSet<MapKind> coming, float depth)
{
    auto whole = std::make_shared<Material>(material);
    for (const MapKindRow& kind : kMapKinds) // heights are there first
        if (auto& map = whole->maps[std::size_t(kind.kind)]; coming.contains(kind.kind)) {
            if (kind.kind != MapKind::Normal)
                map = std::make_shared<const Image>(texelOf(kind));
            else if (material.height)
                map = std::make_shared<const Image>(sampledNormals(*material.height, depth));
        }
    return whole;
}

} // namespace relievo
