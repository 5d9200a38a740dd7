// Exact ray against height field, down a pyramid of maxima.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/exact_search.h"
#include "core/trace/cell_root.h"
#include "core/trace/reference.h"
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

constexpr int kFinest = 2; // shift of the finest grid
constexpr int kStep = 2; // from grid to grid
constexpr int kNodesAtFirst = 32; // a ray begins on the finest grid on which it crosses at most about so many nodes
constexpr double kFarthest = double(1 << 29); // texels; cell indices are ints

// One axis of the search, in texels; texel centres at whole numbers. The crossing of a wall is computed as exactHit computes it and grows
// from wall to wall, so that both visit the same cells at the same t.
struct Axis {
    double start, slope, inverse;
    int size, ahead; // ahead: 1 where the ray goes to larger cells, else 0
    int cell = 0, tile = 0; // tile: its first cell
    bool repeats;

    Axis(double uv, double duv, int texels, Wrap wrap)
        : start(uv * texels - 0.5)
        , slope(duv * texels)
        , inverse(inverseSlope(slope))
        , size(texels)
        , ahead(slope < 0. ? 0 : 1)
        , repeats(wrap == Wrap::Repeat)
    {
    }
    bool isNear() const { return std::abs(start) < kFarthest && std::abs(slope) < kMaxReferenceCells / 2 - 4; }
    double crossing(int wall) const { return (double(wall) - start) * inverse; }
    double fraction(double t) const { return start - double(cell) + slope * t; }
    double enter() const { return crossing(cell + 1 - ahead); }
    double leave() const { return crossing(cell + ahead); }
    int direction() const { return 2 * ahead - 1; }
    void step() { cell += direction(); }

    // The cell that the ray is in at t; where it crosses a wall just then, the one beyond.
    void moveTo(double t)
    {
        const double at = start + slope * t + (double(ahead) - 0.5) * 1e-6; // rounding seldom leaves it on this side of a wall
        cell = int(at);
        cell -= at < double(cell);
        while (leave() <= t)
            step();
        while (enter() > t)
            cell -= direction();
    }

    // A tile that is clamped goes on without end.
    void findTile() { tile = repeats ? cell - wrapIndex(cell, size, Wrap::Repeat) : 0; }
    double leaveTile() const { return repeats ? crossing(tile + size * ahead) : kNever; }
    void nextTile() { tile += direction() * size; }
    // When the ray leaves a node of a grid; beyond a clamped border the node goes on.
    double leaveNode(int node, int shift) const
    {
        const int wall = std::min((node + ahead) << shift, size);
        return !repeats && wall == size * ahead ? kNever : crossing(tile + wall);
    }
    int node(int shift) const { return low() >> shift; }
    // Texels of the cell.
    int low() const { return repeats ? cell - tile : std::clamp(cell, 0, size - 1); }
    int high() const
    {
        const int next = cell - tile + 1;
        return repeats ? (next == size ? 0 : next) : std::clamp(next, 0, size - 1);
    }
};

float highest(const HeightField::Corners& k)
{
    return std::max(std::max(k.h00, k.h10), std::max(k.h01, k.h11));
}

class Walk {
public:
    Walk(const HeightField& field, const ExactSearch::Grid* grids, const float* maxima, const SearchRay& ray, double raise)
        : x(ray.uv.x, ray.duv.x, field.width(), field.wrap())
        , y(ray.uv.y, ray.duv.y, field.height(), field.wrap())
        , top(1. - raise)
        // Rounding of uv(t) moves the surface by this much at most.
        , clear(
              top - 1e-12 - 1e-15 * (1. + std::abs(x.start) + std::abs(y.start) + std::abs(x.slope) + std::abs(y.slope) + std::abs(raise)))
        , m_grids(grids)
        , m_maxima(maxima)
        , m_texels(field.texels().data())
        , m_width(std::size_t(field.width()))
    {
    }

    Axis x, y;
    double top, clear; // the ray is surely above a node of maximum m until t = clear - m
    int fetches = 0;

    // The first root in the cells from `begin` to `end`, or kNever.
    double inCells(double begin, double end)
    {
        x.moveTo(begin), y.moveTo(begin);
        double enter = std::max(0., std::max(x.enter(), y.enter()));
        for (;;) {
            ++fetches;
            const double leaveX = x.leave(), leaveY = y.leave(), leave = std::min(std::min(leaveX, leaveY), 1.);
            const float *row0 = m_texels + std::size_t(y.low()) * m_width, *row1 = m_texels + std::size_t(y.high()) * m_width;
            const HeightField::Corners k{row0[x.low()], row0[x.high()], row1[x.low()], row1[x.high()]};
            if (clear - double(highest(k)) < leave) {
                const double after = cellRoot(k, x.fraction(enter), y.fraction(enter), x.slope, y.slope, top - enter, leave - enter);
                if (after != kNever)
                    return std::min(enter + after, 1.);
            }
            if (leave >= end)
                return kNever;
            if (leaveX <= leave)
                x.step();
            if (leaveY <= leave)
                y.step();
            enter = leave;
        }
    }

    // The same in the nodes of a grid from `begin` to `end`, between which the ray stays in one node of the next coarser grid or in
    // one tile.
    double inGrid(int level, double begin, double end)
    {
        if (level < 0)
            return inCells(begin, end);
        const ExactSearch::Grid grid = m_grids[level];
        const float* maxima = m_maxima + grid.offset;
        x.moveTo(begin), y.moveTo(begin);
        int nodeX = x.node(grid.shift), nodeY = y.node(grid.shift);
        for (double enter = begin;;) {
            ++fetches;
            const double leaveX = x.leaveNode(nodeX, grid.shift), leaveY = y.leaveNode(nodeY, grid.shift);
            const double leave = std::min(std::min(leaveX, leaveY), end);
            const double down = clear - double(maxima[nodeY * grid.width + nodeX]);
            if (down < leave) {
                const double root = inGrid(level - 1, std::max(enter, down), leave);
                if (root != kNever)
                    return root;
            }
            if (leave >= end)
                return kNever;
            nodeX += int(leaveX <= leave) * x.direction();
            nodeY += int(leaveY <= leave) * y.direction();
            enter = leave;
        }
    }

private:
    const ExactSearch::Grid* m_grids;
    const float *m_maxima, *m_texels;
    std::size_t m_width;
};

} // namespace

ExactSearch::ExactSearch(const HeightField& field) : m_field(field)
{
    std::size_t size = 0;
    for (int shift = kFinest;; shift += kStep) {
        const int width = ((field.width() - 1) >> shift) + 1, height = ((field.height() - 1) >> shift) + 1;
        m_grids.push_back({width, height, shift, size});
        size += std::size_t(width) * std::size_t(height);
        if (width == 1 && height == 1)
            break;
    }
    m_maxima.resize(size);
    for (std::size_t level = 0; level < m_grids.size(); ++level) {
        const Grid grid = m_grids[level];
        tbb::parallel_for(0, grid.height, [&](int y) {
            for (int x = 0; x < grid.width; ++x)
                m_maxima[grid.offset + std::size_t(y) * std::size_t(grid.width) + std::size_t(x)]
                    = level == 0 ? maximum(x, y) : maximumBelow(m_grids[level - 1], x, y);
        });
    }
}

// Of the texels that the cells of a node of the finest grid touch.
float ExactSearch::maximum(int x, int y) const
{
    const int endX = std::min((x + 1) << kFinest, m_field.width()), endY = std::min((y + 1) << kFinest, m_field.height());
    float most = 0.f;
    for (int j = y << kFinest; j <= endY; ++j) {
        const float* row
            = m_field.texels().data() + std::size_t(wrapIndex(j, m_field.height(), m_field.wrap())) * std::size_t(m_field.width());
        for (int i = x << kFinest; i < endX; ++i)
            most = std::max(most, row[i]);
        most = std::max(most, row[wrapIndex(endX, m_field.width(), m_field.wrap())]);
    }
    return most;
}

float ExactSearch::maximumBelow(const Grid& below, int x, int y) const
{
    const int endX = std::min((x + 1) << kStep, below.width), endY = std::min((y + 1) << kStep, below.height);
    float most = 0.f;
    for (int j = y << kStep; j < endY; ++j)
        for (int i = x << kStep; i < endX; ++i)
            most = std::max(most, m_maxima[below.offset + std::size_t(j) * std::size_t(below.width) + std::size_t(i)]);
    return most;
}

SearchHit ExactSearch::hit(const SearchRay& ray, double raise) const
{
    Walk walk(m_field, m_grids.data(), m_maxima.data(), ray, raise);
    Axis &x = walk.x, &y = walk.y;
    if (!x.isNear() || !y.isNear())
        return exactHit(m_field, ray, raise);
    const auto found = [&](double t) { return SearchHit{true, t, ray.uv + ray.duv * t, walk.fetches, 0}; };

    double t = std::max(0., walk.clear - double(m_maxima.back()));
    if (t >= 1.)
        return found(1.);
    x.moveTo(t), y.moveTo(t);
    x.findTile(), y.findTile();
    const double travel = (1. - t) * (std::abs(x.slope) + std::abs(y.slope));
    int level = 0;
    while (level + 1 < int(m_grids.size()) && travel > double(kNodesAtFirst << m_grids[std::size_t(level)].shift))
        ++level;
    for (;;) {
        const double leaveX = x.leaveTile(), leaveY = y.leaveTile(), leave = std::min(std::min(leaveX, leaveY), 1.);
        const double root = walk.inGrid(level, t, leave);
        if (root != kNever)
            return found(root);
        if (leave >= 1.)
            return found(1.);
        t = leave;
        if (leaveX <= leave)
            x.nextTile();
        if (leaveY <= leave)
            y.nextTile();
    }
}

} // namespace relievo
