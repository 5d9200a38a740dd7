// Central differences to normals.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/normal.h"
#include <atomic>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

Image normalFromHeight(const HeightField& field, float depthInTiles, const Progress& progress)
{
    const int width = field.width(), height = field.height();
    Image image{width, height, 3, PixelType::U16, 16, false, {}};
    image.data.resize(image.texelCount() * 6);
    const float scaleX = 0.5f * depthInTiles * float(width), scaleY = 0.5f * depthInTiles * float(height);
    std::atomic<int> done = 0;
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            glm::vec3 n(0.f, 0.f, 1.f);
            if (!progress.cancelled())
                n = glm::normalize(glm::vec3(scaleX * (field.texel(x - 1, y) - field.texel(x + 1, y)),
                    scaleY * (field.texel(x, y + 1) - field.texel(x, y - 1)), 1.f));
            std::uint16_t stored[3];
            for (int c = 0; c < 3; ++c)
                stored[c] = std::uint16_t(std::lround((n[c] * 0.5f + 0.5f) * 65535.f));
            std::memcpy(image.data.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 6, stored, 6);
        }
        progress.at(float(++done) / float(height));
    });
    return image;
}

} // namespace relievo
