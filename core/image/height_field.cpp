// Bilinear reads of a height field.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_field.h"
#include <algorithm>
#include <cassert>
#include <cmath>

namespace relievo {

HeightField::HeightField(int width, int height, std::vector<float> heights, Wrap wrap, int storedBits)
    : m_width(width)
    , m_height(height)
    , m_wrap(wrap)
    , m_storedBits(storedBits)
    , m_heights(std::make_shared<const std::vector<float>>(std::move(heights)))
{
    assert(width >= 1 && height >= 1 && m_heights->size() == std::size_t(width) * std::size_t(height));
    assert(std::ranges::all_of(*m_heights, [](float h) { return h >= 0.f && h <= 1.f; }));
}

HeightField HeightField::withWrap(Wrap wrap) const
{
    HeightField other = *this;
    other.m_wrap = wrap;
    return other;
}

HeightField::Corners HeightField::corners(int i, int j) const
{
    const int x0 = wrapIndex(i, m_width, m_wrap), x1 = wrapIndex(i + 1, m_width, m_wrap);
    const std::size_t row0 = std::size_t(wrapIndex(j, m_height, m_wrap)) * std::size_t(m_width);
    const std::size_t row1 = std::size_t(wrapIndex(j + 1, m_height, m_wrap)) * std::size_t(m_width);
    const std::vector<float>& h = *m_heights;
    return {h[row0 + std::size_t(x0)], h[row0 + std::size_t(x1)], h[row1 + std::size_t(x0)], h[row1 + std::size_t(x1)]};
}

namespace {
// Floor of a texel coordinate as an index that int can hold. Beyond 2^24 texels a float has no fraction left anyway;
// the remainder keeps a repeating tile's phase there. NaN gives 0.
int cellIndex(float coordinate, int size, Wrap wrap)
{
    const float floored = std::floor(coordinate);
    if (std::abs(floored) < 1e9f)
        return int(floored);
    if (wrap == Wrap::Clamp)
        return floored > 0.f ? size : -1;
    const float remainder = std::fmod(floored, float(size));
    return std::isfinite(remainder) ? int(remainder) : 0;
}
} // namespace

float HeightField::at(glm::vec2 uv) const
{
    const float x = uv.x * float(m_width) - 0.5f, y = uv.y * float(m_height) - 0.5f;
    const float fx = std::isfinite(x) ? x - std::floor(x) : 0.f;
    const float fy = std::isfinite(y) ? y - std::floor(y) : 0.f;
    const Corners c = corners(cellIndex(x, m_width, m_wrap), cellIndex(y, m_height, m_wrap));
    const float top = c.h00 * (1.f - fx) + c.h10 * fx;
    const float bottom = c.h01 * (1.f - fx) + c.h11 * fx;
    return top * (1.f - fy) + bottom * fy;
}

} // namespace relievo
