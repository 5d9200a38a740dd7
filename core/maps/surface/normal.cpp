// Central differences to normals.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/surface/normal.h"
#include "core/maps/float_image.h"
#include "core/maps/maps.h"
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {
glm::vec2 slopeAt(const HeightField& field, int x, int y)
{
    return 0.5f
        * glm::vec2(float(field.width()) * (field.texel(x + 1, y) - field.texel(x - 1, y)),
            float(field.height()) * (field.texel(x, y + 1) - field.texel(x, y - 1)));
}
} // namespace

std::vector<glm::vec2> slopesOf(const HeightField& field)
{
    std::vector<glm::vec2> slopes(field.texels().size());
    tbb::parallel_for(0, field.height(), [&](int y) {
        for (int x = 0; x < field.width(); ++x)
            slopes[std::size_t(y) * std::size_t(field.width()) + std::size_t(x)] = slopeAt(field, x, y);
    });
    return slopes;
}

Image normalsOf(const HeightField& field, float depthInTiles, const Progress& progress)
{
    const int width = field.width(), height = field.height();
    Image image = floatImage(width, height, 3);
    std::atomic<int> done = 0;
    tbb::parallel_for(0, height, [&](int y) {
        float* out = floats(image).data() + std::size_t(y) * std::size_t(width) * 3;
        for (int x = 0; x < width; ++x) {
            const glm::vec2 slope = progress.cancelled() ? glm::vec2(0.f) : depthInTiles * slopeAt(field, x, y);
            const glm::vec3 n = glm::normalize(glm::vec3(-slope.x, slope.y, 1.f)); // up in the image is -v
            for (int c = 0; c < 3; ++c)
                *out++ = n[c] * 0.5f + 0.5f;
        }
        progress.at(float(++done) / float(height));
    });
    return image;
}

Image normalFromHeight(const HeightField& field, float depthInTiles, const Progress& progress)
{
    return withBits(normalsOf(field, depthInTiles, progress), 16);
}

} // namespace relievo
