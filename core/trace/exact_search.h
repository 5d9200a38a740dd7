// The exact first hit for many rays: the answers of exactHit, found with a pyramid of maxima.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/maps/max_levels.h"
#include "core/trace/ray.h"

namespace relievo {

// Made once for a field (a few milliseconds for 1024 x 1024 texels; a third of the field's own memory, which it shares) and asked from
// any thread. Nodes whose maximum the ray stays above are passed over, with a margin for rounding; every cell that the ray may touch is
// solved as exactHit solves it, from the same entry, so that t is the same (tests allow 1e-12).
// Tevs, Ihrke, Seidel 2008, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering.
class ExactSearch {
public:
    explicit ExactSearch(const HeightField& field);

    // As exactHit (core/trace/reference.h), but for `fetches`: nodes and cells visited. Rays of millions of texels, or that begin
    // so far away, are left to exactHit and its bound.
    SearchHit hit(const SearchRay& ray, double raise = 0.) const;

    std::size_t bytes() const { return m_maxima.values.size() * sizeof(float); } // beside the field

private:
    HeightField m_field;
    MaxLevels m_maxima; // its level 0 holds the maxima of 2 x 2 cells, hence of 3 x 3 texels
};

} // namespace relievo
