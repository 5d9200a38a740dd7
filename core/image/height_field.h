// A height field: a rectangular grid of heights that tiles the plane and is read bilinearly.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/choices.h"
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

namespace relievo {

// Index i brought into [0, size) by the wrap mode; any i, size >= 1.
inline int wrapIndex(int i, int size, Wrap wrap)
{
    if (wrap == Wrap::Clamp)
        return i < 0 ? 0 : (i >= size ? size - 1 : i);
    i %= size;
    return i < 0 ? i + size : i;
}

// A height as textures hold it: those of at most 16 bits as 65535ths, which 8-bit values are too, others as they are.
inline float asStored(float height, int storedBits)
{
    return storedBits <= 16 ? std::round(height * 65535.f) / 65535.f : height;
}

// Immutable and cheap to copy; safe to read from any thread.
class HeightField {
public:
    // heights: row-major, width * height values in [0, 1], 1 = top; row 0 lies at v = 0 (image top).
    // Requires width, height >= 1 and finite values in [0, 1] (asserted: repairing them is the loader's work).
    // storedBits: precision of the source, 8, 16 or 32 (float); decides the upload format, not the values.
    HeightField(int width, int height, std::vector<float> heights, Wrap wrap = Wrap::Repeat, int storedBits = 16);

    int width() const { return m_width; } // texels
    int height() const { return m_height; } // texels
    Wrap wrap() const { return m_wrap; }
    int storedBits() const { return m_storedBits; }
    std::span<const float> texels() const { return *m_heights; }
    std::shared_ptr<const void> identity() const { return m_heights; } // equal for copies: the same heights, not compared

    // The same heights under another wrap mode; shares the data.
    HeightField withWrap(Wrap wrap) const;

    // Height at texel (x, y); coordinates outside the grid follow the wrap mode.
    float texel(int x, int y) const
    {
        x = wrapIndex(x, m_width, m_wrap);
        y = wrapIndex(y, m_height, m_wrap);
        return (*m_heights)[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
    }

    // Bilinear height at uv; texel centres lie at (i + 0.5) / size, as in OpenGL. An infinite
    // coordinate reads the border of its side under clamp; other non-finite ones the first texel along their axis.
    float at(glm::vec2 uv) const;

    // The four corners of cell (i, j), between the texel centres (i, j) and (i + 1, j + 1).
    struct Corners {
        float h00, h10, h01, h11; // h10 is one texel to the right of h00, h01 one texel below
    };
    Corners corners(int i, int j) const;

private:
    int m_width, m_height;
    Wrap m_wrap;
    int m_storedBits;
    std::shared_ptr<const std::vector<float>> m_heights;
};

} // namespace relievo
