// Branch and bound for cone maps: at each texel, the smallest ratio of lateral distance to height among the obstacles of a quadrant.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/acceleration/max_levels.h"
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

// Four texels beside each other are searched together: they see nearly the same of the field.
inline constexpr int kLanes = 4;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using LaneMask = int __attribute__((vector_size(kLanes * sizeof(int)))); // -1 where true

inline bool any(LaneMask mask)
{
    using Halves = long long __attribute__((vector_size(sizeof(LaneMask))));
    const Halves halves = (Halves)mask;
    return (halves[0] | halves[1]) != 0;
}

// The search of kLanes texels. Leaf:
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

    // Texels (x, y) to (x + count - 1, y) of the mirrored field, count <= kLanes. Rows in their order are fast: what limited the texels
    // before and above is tried first.
    void search(int x, int y, int count, std::array<ConeBounds, kLanes>& bounds)
    {
        m_x = x;
        m_y = y;
        for (int k = 0; k < kLanes; ++k) { // lanes beyond the last texel search nothing
            m_apex[k] = k < count ? m_quadrant.field.texels()[std::size_t(y) * std::size_t(m_width) + std::size_t(x + k)] : m_highest;
            m_safe[k] = bounds[std::size_t(k)].safe;
            m_reached[k] = bounds[std::size_t(k)].reached;
        }
        if (!any(m_apex < m_highest))
            return;
        for (int k = 0; k < count; ++k) {
            tryFirst(k, m_limits[std::size_t(x + k)]);
            if (x > 0)
                tryFirst(k, m_limits[std::size_t(x - 1)]);
        }
        m_limit = {};
        const bool repeats = m_quadrant.field.wrap() == Wrap::Repeat;
        for (int ring = 0; ring == 0 || (repeats && any(ringDistance(ring) < m_safe * (m_highest - m_apex))); ++ring)
            for (int k = 0; k <= ring; ++k) {
                visitTile(ring, k);
                if (k != ring)
                    visitTile(k, ring);
            }
        for (int k = 0; k < count; ++k) {
            if (m_limit[std::size_t(k)].x >= 0)
                m_limits[std::size_t(x + k)] = m_limit[std::size_t(k)];
            bounds[std::size_t(k)] = {m_safe[k], m_reached[k]};
        }
    }

private:
    struct Node {
        int level, i, j;
    };
    struct Item { // an item's near corner, in texels of the field and its repetitions; none below 0
        int x = -1, y = -1;
    };

    Lanes ringDistance(int ring) const
    {
        const Lanes u = (float(ring * m_width - m_x) - kLane) * m_du;
        const float v = float(ring * m_height - m_y) * m_dv;
        return (u < v ? u : Lanes{} + v) * kConeMargin;
    }
    // As far as the node lies in the quadrant of the first texel.
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
    static NodeExtent seenFrom(int lane, const NodeExtent& e) { return {std::max(e.x0 - lane, 0), e.x1 - lane, e.y0, e.y1}; }

    void tryFirst(int lane, const Item& item)
    {
        const int x = item.x - m_x - lane, y = item.y - m_y;
        if (x >= 0 && y >= 0 && !outsideWedge({x, x, y, y}))
            leaf(lane, item.x % m_width, item.y % m_height, x, y);
    }

    void leaf(int lane, int i, int j, int x, int y)
    {
        const float ratio = m_leaf.ratio(i, j, x, y, m_apex[lane]);
        if (ratio < m_reached[lane]) {
            m_reached[lane] = ratio;
            m_limit[std::size_t(lane)] = {m_x + lane + x, m_y + y};
        }
        m_safe[lane] = std::min(m_safe[lane], ratio);
    }

    // Depth first, near nodes before far ones.
    void visitTile(int tileX, int tileY)
    {
        const int left = tileX * m_width - m_x, top = tileY * m_height - m_y;
        std::array<Node, 3 * 32> stack;
        std::size_t count = 0;
        stack[count++] = {m_quadrant.items.top(), 0, 0};
        while (count > 0) {
            const Node node = stack[--count];
            if (!opens(node, left, top))
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

    // Whether the node's children must be looked at for any of the texels; a leaf and a node taken at its bound change their bounds.
    bool opens(const Node& node, int left, int top)
    {
        const Lanes reach = m_quadrant.items.at(node.level, node.i, node.j) - m_apex;
        const NodeExtent e = extent(node, left, top);
        if (e.x1 < 0 || e.y1 < 0)
            return false;
        const Lanes across = (float(e.x0) - kLane) * m_du, u = across > 0.f ? across : Lanes{}, limit = m_safe * reach;
        const float v = float(e.y0) * m_dv;
        const Lanes distance = u * u + v * v; // squared
        LaneMask open = (reach > 0.f) & (distance < limit * limit) & (kLane <= float(e.x1));
        if (m_wedge != Wedge::All)
            for (int k = 0; k < kLanes; ++k)
                open[k] = outsideWedge(seenFrom(k, e)) ? 0 : open[k];
        if (!any(open) || !m_leaf.mayLimit(node.level, node.i, node.j, {std::max(e.x0 - kLanes + 1, 0), e.x1, e.y0, e.y1}))
            return false;
        if (node.level > 0 || !Leaf::kAsCheapAsBound) {
            const Lanes kept = kConeKeep * m_reached * reach;
            const LaneMask taken = open & (distance >= kept * kept);
            for (int k = 0; any(taken) && k < kLanes; ++k)
                m_safe[k] = taken[k] != 0 ? std::sqrt(distance[k]) / reach[k] : m_safe[k];
            open &= ~taken;
        }
        if (node.level > 0)
            return any(open);
        for (int k = 0; k < kLanes; ++k)
            if (open[k] != 0)
                leaf(k, node.i, node.j, std::max(e.x0 - k, 0), e.y0);
        return false;
    }

    static constexpr Lanes kLane = {0.f, 1.f, 2.f, 3.f};
    const ConeQuadrant& m_quadrant;
    const Leaf& m_leaf;
    Wedge m_wedge;
    int m_width, m_height;
    float m_du, m_dv, m_highest;
    std::vector<Item> m_limits; // of the texels before in this row and of the others in the row above
    int m_x = 0, m_y = 0; // the first texel
    Lanes m_apex{}, m_safe{}, m_reached{};
    std::array<Item, kLanes> m_limit;
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
            for (int x = 0; x < width; x += kLanes) {
                if (x % 32 == 0 && progress.cancelled())
                    return;
                const int count = std::min(kLanes, width - x), toY = quadrant.mirrorV ? height - 1 - y : y;
                const auto texel = [&](int k) {
                    return std::size_t(toY) * std::size_t(width) + std::size_t(quadrant.mirrorU ? width - 1 - x - k : x + k);
                };
                std::array<ConeBounds, kLanes> bounds;
                for (int k = 0; k < count; ++k)
                    bounds[std::size_t(k)] = {view.safe[texel(k) * view.safeStride], view.reached[texel(k) * view.reachedStride]};
                search.search(x, y, count, bounds);
                for (int k = 0; k < count; ++k) {
                    view.safe[texel(k) * view.safeStride] = bounds[std::size_t(k)].safe;
                    view.reached[texel(k) * view.reachedStride] = bounds[std::size_t(k)].reached;
                }
            }
        }
        progress.at(from + (to - from) * float(++done) / float(blocks));
    });
}

} // namespace relievo
