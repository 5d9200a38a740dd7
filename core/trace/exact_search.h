// The exact first hit for many rays: the answers of exactHit, found with a pyramid of maxima.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/trace/ray.h"
#include <cstdint>
#include <vector>

namespace relievo {

// Made once for a field (some milliseconds and 0.07 MB for 1024 x 1024 texels, which it shares) and asked from
// any thread. Nodes whose maximum the ray stays above are passed over, with a margin for rounding; every cell that the ray may touch is
// solved as exactHit solves it, from the same entry, so that t is the same (tests allow 1e-12).
// Tevs, Ihrke, Seidel 2008, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering.
class ExactSearch {
public:
    explicit ExactSearch(const HeightField& field);

    // As exactHit (core/trace/reference.h), but for `fetches`: nodes and cells visited. Rays of millions of texels, or that begin
    // so far away, are left to exactHit and its bound.
    SearchHit hit(const SearchRay& ray, double raise = 0.) const;

    std::size_t bytes() const { return m_maxima.size(); } // beside the field

    // A grid of nodes, each of 2^shift x 2^shift cells (as far as the field reaches), row by row.
    struct Grid {
        int width, height, shift;
        double scale; // 1 / 2^shift
        std::size_t offset; // of its first maximum
    };

private:
    HeightField m_field;
    std::vector<Grid> m_grids; // finest first, each node of 4 x 4 of those below; the last has one node
    std::vector<std::uint8_t> m_maxima; // in 255ths, rounded up

    std::uint8_t maximum(int x, int y) const;
    std::uint8_t maximumBelow(const Grid& below, int x, int y) const;
};

} // namespace relievo
