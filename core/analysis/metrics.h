// How far the hits of a search are from the exact ones.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/trace/ray.h"
#include <span>

namespace relievo {

// A hit is wrong when it lies more than both from the exact one (so that grazing rays, which cross many texels in little depth, and
// coarse maps, where half a texel is much depth, are not blamed for what nobody sees).
inline constexpr double kWrongDepth = 0.002; // share of the depth
inline constexpr double kWrongTexels = 0.5; // sideways: between the places of the texture that are shown
// ... and is a tie, counted apart, when raising or lowering the whole surface by this much makes it right.
inline constexpr double kTieHeight = 1e-4;

struct HitErrors {
    std::size_t rays = 0; // compared: all but `invalid`
    std::size_t invalid = 0; // t or uv not a number, or t outside [0, 1]
    std::size_t tooDeep = 0; // wrong, and past the first hit; also a ray that found nothing where there is something
    std::size_t tooShort = 0; // wrong, and before it
    std::size_t ties = 0; // neither of the two, and left out of the figures of t
    std::size_t notFound = 0; // the search gave up; it counts as t = 1
    double rmse = 0., largest = 0.; // of t, share of the depth
    double rmseTexels = 0., largestTexels = 0.; // between the uv found and the exact one
    double rmsePixels = 0.; // by which what is seen is shifted; 0 where no `pixels` were told
    double meanFetches = 0., p99Fetches = 0.;
    int maxFetches = 0;
    double meanBytes = 0.; // fetched

    double share(std::size_t count) const { return rays ? double(count) / double(rays) : 0.; }
    std::size_t wrong() const { return tooDeep + tooShort; }
    double wrongShare() const { return share(wrong()); }
};

// hits[i] and exact[i] answer rays[i]. Rays whose exact answer is missing (not finite, or too long to walk) are left out.
// pixels: of each ray, by how many pixels an error of the whole depth shifts what is seen; may be empty.
HitErrors compareHits(const HeightField& field, std::span<const SearchRay> rays, std::span<const SearchHit> hits,
    std::span<const SearchHit> exact, std::span<const double> pixels = {});

// Several sets as one: counts add, roots of mean squares are weighted by rays that are no ties, p99 is the mean of those (weighted), maxima
// are kept.
HitErrors together(std::span<const HitErrors> sets);

} // namespace relievo
