// Means pulled up a pyramid, and pushed down into what is empty.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/dilate.h"
#include <algorithm>
#include <cstddef>

namespace relievo {

void dilate(std::vector<glm::vec4>& values, const std::vector<float>& filled, int width, int height)
{
    if (width == 1 && height == 1)
        return;
    const int halfWidth = (width + 1) / 2, halfHeight = (height + 1) / 2;
    std::vector<glm::vec4> coarse(std::size_t(halfWidth) * std::size_t(halfHeight), glm::vec4(0.f));
    std::vector<float> weights(coarse.size(), 0.f);
    const auto parent = [&](int x, int y) { return std::size_t(y / 2) * std::size_t(halfWidth) + std::size_t(x / 2); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            coarse[parent(x, y)] += filled[i] * values[i];
            weights[parent(x, y)] += filled[i];
        }
    for (std::size_t i = 0; i < coarse.size(); ++i)
        if (weights[i] > 0.f) {
            coarse[i] /= weights[i];
            weights[i] = std::min(weights[i], 1.f);
        }
    dilate(coarse, weights, halfWidth, halfHeight);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x); !(filled[i] > 0.f))
                values[i] = coarse[parent(x, y)];
}

} // namespace relievo
