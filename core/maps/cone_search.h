// Branch and bound for cone maps: at each texel, the smallest ratio of lateral distance to height among the obstacles of a quadrant.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/maps/max_levels.h"
#include "core/progress.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace relievo {

// The widest cone stored, in tiles per unit of height: a level field would allow any.
inline constexpr float kWidestCone = 64.f;
// A node whose bound is at least this share of the smallest ratio found is taken at its bound and not opened:
// the result is at most 1 - kConeKeep below the true ratio and never above it.
inline constexpr float kConeKeep = 0.92f;
// Covers the rounding of the search's float arithmetic (each bound is right to 1e-6).
inline constexpr float kConeMargin = 1.f - 1e-5f;

// safe <= true ratio <= reached, over what was searched so far.
struct ConeBounds {
    float safe = kWidestCone, reached = kWidestCone;
};

// The bounds of all texels, row by row in the order of the field that is not mirrored, as channels of images.
struct BoundsView {
    float *safe, *reached;
    std::size_t safeStride, reachedStride;
};

// What lies in the quadrant +u, +v of every texel: item (i, j), repeated with the tile, has its near corner at texel (i, j) and is an
// obstacle of at most the height in level 0 (below 0: none). The other quadrants are searched in mirrored fields.
struct ConeQuadrant {
    HeightField field; // mirrored
    bool mirrorU, mirrorV;
    MaxLevels items;
};

// The field with columns (and rows) in reverse order.
HeightField mirrored(const HeightField& field, bool mirrorU, bool mirrorV);

// The four quadrants' mirrors, in the order of the searches.
inline constexpr std::array<std::array<bool, 2>, 4> kMirrors = {{{false, false}, {true, false}, {false, true}, {true, true}}};

// Which part of the quadrant counts: all, or the half nearer to one axis (with the diagonal, in uv).
enum class Wedge { All, AlongU, AlongV };

// Near corners of the items of a node, as far as they lie in the quadrant: offsets from the apex in texels, first and last.
struct NodeExtent {
    int x0, x1, y0, y1;
};

// One texel's search. Leaf:
// float ratio(int i, int j, int x, int y, float apex): the smallest ratio of item (i, j), whose near corner lies x, y texels from the
//   apex, or up to 0.1 % less; kWidestCone when it is no obstacle;
// bool mayLimit(int level, int i, int j, const NodeExtent&): false when no item of the node is an obstacle; kAsCheapAsBound: whether ratio
// costs no more than the bound by distance and height.
template <class Leaf> class ConeSearch {
public:
    ConeSearch(const ConeQuadrant& quadrant, Wedge wedge, const Leaf& leaf)
        : m_quadrant(quadrant)
        , m_leaf(leaf)
        , m_wedge(wedge)
        , m_width(quadrant.field.width())
        , m_height(quadrant.field.height())
        , m_du(1.f / float(m_width))
        , m_dv(1.f / float(m_height))
        , m_highest(quadrant.items.at(quadrant.items.top(), 0, 0))
        , m_limits(std::size_t(m_width))
    {
    }

    // Texel (x, y) of the mirrored field. Rows in their order are fast: what limited the texels before and above is tried first.
    void search(int x, int y, ConeBounds& bounds)
    {
        m_x = x;
        m_y = y;
        m_apex = m_quadrant.field.texels()[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
        if (m_highest <= m_apex)
            return;
        Item& above = m_limits[std::size_t(x)];
        tryFirst(above, bounds);
        if (x > 0)
            tryFirst(m_limits[std::size_t(x - 1)], bounds);
        m_limit = {};
        const bool repeats = m_quadrant.field.wrap() == Wrap::Repeat;
        for (int ring = 0; ring == 0 || (repeats && ringDistance(ring) < bounds.safe * (m_highest - m_apex)); ++ring)
            for (int k = 0; k <= ring; ++k) {
                visitTile(ring, k, bounds);
                if (k != ring)
                    visitTile(k, ring, bounds);
            }
        if (m_limit.x >= 0)
            above = m_limit;
    }

private:
    struct Node {
        int level, i, j;
    };
    struct Item { // an item's near corner, in texels of the field and its repetitions; none below 0
        int x = -1, y = -1;
    };

    float ringDistance(int ring) const
    {
        return std::min(float(ring * m_width - m_x) * m_du, float(ring * m_height - m_y) * m_dv) * kConeMargin;
    }
    float squaredDistance(int x, int y) const
    {
        const float u = float(x) * m_du, v = float(y) * m_dv;
        return u * u + v * v;
    }
    NodeExtent extent(const Node& node, int left, int top) const
    {
        const int x = left + (node.i << node.level), y = top + (node.j << node.level), size = 1 << node.level;
        return {std::max(x, 0), std::min(x + size, left + m_width) - 1, std::max(y, 0), std::min(y + size, top + m_height) - 1};
    }
    bool outsideWedge(const NodeExtent& e) const
    {
        if (m_wedge == Wedge::All)
            return false;
        return m_wedge == Wedge::AlongU ? std::int64_t(e.x1) * m_height < std::int64_t(e.y0) * m_width
                                        : std::int64_t(e.y1) * m_width < std::int64_t(e.x0) * m_height;
    }

    void tryFirst(const Item& item, ConeBounds& bounds)
    {
        const int x = item.x - m_x, y = item.y - m_y;
        if (x >= 0 && y >= 0 && !outsideWedge({x, x, y, y}))
            leaf(item.x % m_width, item.y % m_height, x, y, bounds);
    }

    void leaf(int i, int j, int x, int y, ConeBounds& bounds)
    {
        const float ratio = m_leaf.ratio(i, j, x, y, m_apex);
        if (ratio < bounds.reached) {
            bounds.reached = ratio;
            m_limit = {m_x + x, m_y + y};
        }
        bounds.safe = std::min(bounds.safe, ratio);
    }

    // Depth first, near nodes before far ones.
    void visitTile(int tileX, int tileY, ConeBounds& bounds)
    {
        const int left = tileX * m_width - m_x, top = tileY * m_height - m_y;
        std::array<Node, 3 * 32> stack;
        std::size_t count = 0;
        stack[count++] = {m_quadrant.items.top(), 0, 0};
        while (count > 0) {
            const Node node = stack[--count];
            if (!opens(node, left, top, bounds))
                continue;
            const MaxLevels::Level& below = m_quadrant.items.levels[std::size_t(node.level) - 1];
            const int i = 2 * node.i, j = 2 * node.j;
            const bool right = i + 1 < below.width, down = j + 1 < below.height;
            if (right && down)
                stack[count++] = {node.level - 1, i + 1, j + 1};
            if (down)
                stack[count++] = {node.level - 1, i, j + 1};
            if (right)
                stack[count++] = {node.level - 1, i + 1, j};
            stack[count++] = {node.level - 1, i, j};
        }
    }

    // Whether the node's children must be looked at; a leaf and a node taken at its bound change `bounds`.
    bool opens(const Node& node, int left, int top, ConeBounds& bounds)
    {
        const float reach = m_quadrant.items.at(node.level, node.i, node.j) - m_apex;
        if (!(reach > 0.f))
            return false;
        const NodeExtent e = extent(node, left, top);
        if (e.x1 < 0 || e.y1 < 0)
            return false;
        const float distance = squaredDistance(e.x0, e.y0), limit = bounds.safe * reach;
        if (distance >= limit * limit || outsideWedge(e) || !m_leaf.mayLimit(node.level, node.i, node.j, e))
            return false;
        const float kept = kConeKeep * bounds.reached * reach;
        if (distance >= kept * kept && (node.level > 0 || !Leaf::kAsCheapAsBound)) {
            bounds.safe = std::sqrt(distance) / reach;
            return false;
        }
        if (node.level > 0)
            return true;
        leaf(node.i, node.j, e.x0, e.y0, bounds);
        return false;
    }

    const ConeQuadrant& m_quadrant;
    const Leaf& m_leaf;
    Wedge m_wedge;
    int m_width, m_height;
    float m_du, m_dv, m_highest;
    std::vector<Item> m_limits; // of the texels before in this row and of the others in the row above
    Item m_limit;
    int m_x = 0, m_y = 0;
    float m_apex = 0.f;
};

// Narrows each texel's bounds by the quadrant's obstacles.
// progress: this part's share of the whole is [from, to]. Stops early when cancelled.
template <class Leaf>
void searchQuadrant(
    const ConeQuadrant& quadrant, Wedge wedge, const Leaf& leaf, const BoundsView& view, const Progress& progress, float from, float to)
{
    const int width = quadrant.field.width(), height = quadrant.field.height();
    std::atomic<int> done = 0;
    constexpr int kRows = 16;
    const int blocks = (height + kRows - 1) / kRows;
    tbb::parallel_for(0, blocks, [&](int block) {
        ConeSearch<Leaf> search(quadrant, wedge, leaf); // anew for each block: the same map however the blocks are shared out
        for (int y = block * kRows; y < std::min((block + 1) * kRows, height); ++y) {
            for (int x = 0; x < width; ++x) {
                if (x % 32 == 0 && progress.cancelled())
                    return;
                const int toX = quadrant.mirrorU ? width - 1 - x : x, toY = quadrant.mirrorV ? height - 1 - y : y;
                const std::size_t texel = std::size_t(toY) * std::size_t(width) + std::size_t(toX);
                ConeBounds bounds{view.safe[texel * view.safeStride], view.reached[texel * view.reachedStride]};
                search.search(x, y, bounds);
                view.safe[texel * view.safeStride] = bounds.safe;
                view.reached[texel * view.reachedStride] = bounds.reached;
            }
        }
        progress.at(from + (to - from) * float(++done) / float(blocks));
    });
}

} // namespace relievo
