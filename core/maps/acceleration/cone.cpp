// The cone maps: what counts as an obstacle in each, searched quadrant by quadrant.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/cone.h"
#include "core/maps/acceleration/cone_search.h"
#include "core/maps/acceleration/relaxed_cell.h"
#include "core/maps/float_image.h"

namespace relievo {

HeightField mirrored(const HeightField& field, bool mirrorU, bool mirrorV)
{
    if (!mirrorU && !mirrorV)
        return field;
    const int width = field.width(), height = field.height();
    std::vector<float> heights(field.texels().size());
    tbb::parallel_for(0, height, [&](int y) {
        const auto from = field.texels().subspan(std::size_t(mirrorV ? height - 1 - y : y) * std::size_t(width), std::size_t(width));
        float* to = heights.data() + std::size_t(y) * std::size_t(width);
        if (mirrorU)
            std::reverse_copy(from.begin(), from.end(), to);
        else
            std::copy(from.begin(), from.end(), to);
    });
    return {width, height, std::move(heights), field.wrap(), field.storedBits()};
}

namespace {

using Corners = HeightField::Corners;
// The height up to which an item may be an obstacle for apexes towards -u and -v of it, or -1: by the cell between it and the next texels.
using Obstacle = float (*)(const Corners&);

float everyTexel(const Corners& c)
{
    return c.h00;
}
bool falls(const Corners& c)
{
    return c.h10 < c.h00 || c.h01 < c.h00 || c.h11 < c.h10 || c.h11 < c.h01;
}
float texelBeforeFall(const Corners& c)
{
    return falls(c) ? c.h00 : -1.f;
}
float fallingCell(const Corners& c)
{
    return falls(c) ? std::max(std::max(c.h00, c.h10), std::max(c.h01, c.h11)) : -1.f;
}

ConeQuadrant quadrantOf(const HeightField& field, bool mirrorU, bool mirrorV, Obstacle obstacle, const Progress& progress)
{
    ConeQuadrant quadrant{mirrored(field, mirrorU, mirrorV), mirrorU, mirrorV, makeMaxLevels(field.width(), field.height())};
    tbb::parallel_for(0, field.height(), [&](int y) {
        if (progress.cancelled())
            return;
        float* row = quadrant.items.values.data() + std::size_t(y) * std::size_t(field.width());
        for (int x = 0; x < field.width(); ++x)
            row[x] = obstacle(quadrant.field.corners(x, y));
    });
    finishMaxLevels(quadrant.items);
    return quadrant;
}

// An obstacle that is the texel itself.
struct TexelLeaf {
    static constexpr bool kAsCheapAsBound = true;
    const ConeQuadrant& quadrant;
    TexelLeaf(const ConeQuadrant& q, const Progress&) : quadrant(q) { }
    static bool mayLimit(int, int, int, const NodeExtent&) { return true; }
    float ratio(int i, int j, int x, int y, float apex) const
    {
        const float u = float(x) / float(quadrant.field.width()), v = float(y) / float(quadrant.field.height());
        const float rise = quadrant.items.at(0, i, j) - apex;
        return rise > 0.f ? std::min(kWidestCone, std::sqrt(u * u + v * v) / rise) : kWidestCone;
    }
};

// An obstacle that is the part of a cell from which rays leave. A node's tangent planes reach up to its highest point plus its steepest
// falls times the way back to the apex: where that is not above 1, no ray leaves.
struct CellLeaf {
    static constexpr bool kAsCheapAsBound = false;
    const ConeQuadrant& quadrant;
    MaxLevels fallU, fallV; // steepest fall of a node, height per texel; negative where all of it rises

    CellLeaf(const ConeQuadrant& q, const Progress& progress)
        : quadrant(q)
        , fallU(makeMaxLevels(q.field.width(), q.field.height()))
        , fallV(fallU)
    {
        tbb::parallel_for(0, q.field.height(), [&](int y) {
            if (progress.cancelled())
                return;
            const std::size_t row = std::size_t(y) * std::size_t(q.field.width());
            for (int x = 0; x < q.field.width(); ++x) {
                const Corners c = q.field.corners(x, y);
                fallU.values[row + std::size_t(x)] = std::max(c.h00 - c.h10, c.h01 - c.h11);
                fallV.values[row + std::size_t(x)] = std::max(c.h00 - c.h01, c.h10 - c.h11);
            }
        });
        finishMaxLevels(fallU);
        finishMaxLevels(fallV);
    }
    bool mayLimit(int level, int i, int j, const NodeExtent& e) const
    {
        const float u = fallU.at(level, i, j), v = fallV.at(level, i, j);
        return quadrant.items.at(level, i, j) + u * float(u > 0.f ? e.x1 + 1 : e.x0) + v * float(v > 0.f ? e.y1 + 1 : e.y0) > kConeMargin;
    }
    float ratio(int i, int j, int x, int y, float apex) const
    {
        const HeightField& field = quadrant.field;
        const RelaxedCell cell{field.corners(i, j), double(x), double(y), 1. / field.width(), 1. / field.height()};
        return float(std::min(double(kWidestCone), relaxedRatio(cell, double(apex))));
    }
};

// (safe bound in channel 1, reached in channel 0): the channels double as the search's memory. No levels when cancelled.
template <class Leaf> BakedMap searched(const HeightField& field, Obstacle obstacle, const Progress& progress)
{
    BakedMap map = oneLevel(floatImage(field.width(), field.height(), 2));
    const auto out = floats(map.levels[0]);
    std::ranges::fill(out, kWidestCone);
    for (std::size_t q = 0; q < kMirrors.size() && !progress.cancelled(); ++q) {
        const ConeQuadrant quadrant = quadrantOf(field, kMirrors[q][0], kMirrors[q][1], obstacle, progress);
        searchQuadrant(quadrant, Wedge::All, Leaf(quadrant, progress), {out.data() + 1, out.data(), 2, 2}, progress, float(q) / 4.f,
            float(q + 1) / 4.f);
    }
    return progress.cancelled() ? BakedMap() : map;
}

// Puts the heights where the search had its memory.
BakedMap heightAndRatio(const HeightField& field, BakedMap map)
{
    if (map.levels.empty())
        return map;
    const auto out = floats(map.levels[0]);
    for (std::size_t i = 0; i < field.texels().size(); ++i) {
        out[2 * i] = field.texels()[i];
        out[2 * i + 1] *= kConeMargin;
    }
    return map;
}

// The smallest of 3 x 3 texels in channel 1, under the field's wrap mode; by way of channel 0. Stops early when cancelled.
void takeSmallestAround(const HeightField& field, Image& image, const Progress& progress)
{
    const int width = field.width(), height = field.height();
    const auto out = floats(image);
    tbb::parallel_for(0, height, [&](int y) {
        if (progress.cancelled())
            return;
        for (int x = 0; x < width; ++x) {
            float smallest = kWidestCone;
            for (int j = y - 1; j <= y + 1; ++j)
                for (int i = x - 1; i <= x + 1; ++i)
                    smallest = std::min(smallest, image.value(wrapIndex(i, width, field.wrap()), wrapIndex(j, height, field.wrap()), 1));
            out[2 * (std::size_t(y) * std::size_t(width) + std::size_t(x))] = smallest;
        }
    });
    for (std::size_t i = 0; i < out.size(); i += 2)
        out[i + 1] = out[i];
}

} // namespace

BakedMap bakeCone(const HeightField& field, const Parameters&, const Progress& progress)
{
    return heightAndRatio(field, searched<TexelLeaf>(field, everyTexel, progress));
}

BakedMap bakeConeRelaxed(const HeightField& field, const Parameters&, const Progress& progress)
{
    return heightAndRatio(field, searched<CellLeaf>(field, fallingCell, progress));
}

BakedMap bakeConeRobust(const HeightField& field, const Parameters&, const Progress& progress)
{
    BakedMap map = searched<TexelLeaf>(field, texelBeforeFall, progress);
    if (!map.levels.empty())
        takeSmallestAround(field, map.levels[0], progress);
    return progress.cancelled() ? BakedMap() : heightAndRatio(field, std::move(map));
}

BakedMap bakeConeQuad(const HeightField& field, const Parameters&, const Progress& progress)
{
    // Channel by channel: the two quadrants that share its axis, their half along it.
    constexpr std::array<std::array<std::size_t, 2>, 4> kQuadrants = {{{0, 2}, {1, 3}, {0, 1}, {2, 3}}};
    BakedMap map = oneLevel(floatImage(field.width(), field.height(), 4));
    const auto out = floats(map.levels[0]);
    std::ranges::fill(out, kWidestCone);
    std::vector<float> reached(field.texels().size());
    for (std::size_t c = 0; c < 4; ++c) {
        std::ranges::fill(reached, kWidestCone);
        for (std::size_t half = 0; half < 2 && !progress.cancelled(); ++half) {
            const auto [mirrorU, mirrorV] = kMirrors[kQuadrants[c][half]];
            const ConeQuadrant quadrant = quadrantOf(field, mirrorU, mirrorV, everyTexel, progress);
            const float share = float(2 * c + half) / 8.f;
            searchQuadrant(quadrant, c < 2 ? Wedge::AlongU : Wedge::AlongV, TexelLeaf(quadrant, progress),
                {out.data() + c, reached.data(), 4, 1}, progress, share, share + 0.125f);
        }
    }
    if (progress.cancelled())
        return {};
    for (float& ratio : out)
        ratio *= kConeMargin;
    return map;
}

} // namespace relievo
