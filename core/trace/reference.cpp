// Exact ray against height field: a cell walk with a quadratic in each cell.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/reference.h"
#include "core/trace/cell_root.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {

namespace {

// One axis of the walk, in texels; texel centres at whole numbers.
struct CellAxis {
    double start, slope, inverse;
    std::int64_t cell, first, last; // beyond a clamped border the outermost cells go on without end

    CellAxis(double uv, double duv, int size, Wrap wrap)
        : start(uv * size - 0.5)
        , slope(duv * size)
        , inverse(inverseSlope(slope))
        , cell(0)
        , first(wrap == Wrap::Clamp ? -1 : std::numeric_limits<std::int64_t>::min())
        , last(wrap == Wrap::Clamp ? size - 1 : std::numeric_limits<std::int64_t>::max())
    {
        // Far from the origin only the phase within the tile matters, and 64 bits hold any cell index below 2^53.
        cell = std::int64_t(std::clamp(std::floor(start), -9e15, 9e15));
        if (slope < 0. && start == std::floor(start) && cell > -9'000'000'000'000'000)
            --cell; // starts on the wall and leaves downwards
        cell = std::clamp(cell, first, last);
    }
    double exit() const
    {
        const bool goesOn = slope < 0. ? cell == first : cell == last;
        return goesOn ? kNever : (double(slope < 0. ? cell : cell + 1) - start) * inverse;
    }
    // In a cell that goes on without end all places are alike.
    double fraction(double t) const { return cell == first || cell == last ? 0. : start - double(cell) + slope * t; }
};

int wrapped(std::int64_t cell, int size, Wrap wrap)
{
    if (wrap == Wrap::Clamp)
        return int(cell);
    const std::int64_t remainder = cell % size;
    return int(remainder < 0 ? remainder + size : remainder);
}

} // namespace

SearchHit exactHit(const HeightField& field, const SearchRay& ray, double raise)
{
    SearchHit hit;
    if (!isFinite(ray))
        return hit;
    CellAxis x(ray.uv.x, ray.duv.x, field.width(), field.wrap()), y(ray.uv.y, ray.duv.y, field.height(), field.wrap());
    if (!std::isfinite(x.slope) || !std::isfinite(y.slope) || !std::isfinite(x.start) || !std::isfinite(y.start))
        return unfinished(ray, 0);
    double enter = 0.;
    while (hit.fetches < kMaxReferenceCells) {
        ++hit.fetches;
        const double exitX = x.exit(), exitY = y.exit();
        const double leave = std::max(enter, std::min({exitX, exitY, 1.}));
        const HeightField::Corners k
            = field.corners(wrapped(x.cell, field.width(), field.wrap()), wrapped(y.cell, field.height(), field.wrap()));
        const double root = cellRoot(k, x.fraction(enter), y.fraction(enter), x.slope, y.slope, 1. - enter - raise, leave - enter);
        if (root != kNever || leave >= 1.) {
            hit.found = true;
            hit.t = root == kNever ? 1. : std::min(enter + root, 1.);
            hit.uv = ray.uv + ray.duv * hit.t;
            return hit;
        }
        if (exitX <= leave)
            x.cell += x.slope > 0. ? 1 : -1;
        if (exitY <= leave)
            y.cell += y.slope > 0. ? 1 : -1;
        enter = leave;
    }
    return unfinished(ray, hit.fetches);
}

} // namespace relievo
