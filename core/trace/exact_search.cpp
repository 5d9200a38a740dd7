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
constexpr int kNodesAtFirst = 512; // a ray begins on the finest grid on which it crosses at most about so many nodes
constexpr double kRounding = 1e-6; // texels; more than the rounding of uv(t), the places of rays that begin within kFarthest
constexpr double kFarthest = double(1 << 29); // texels; cell indices are ints

// std::floor, for places within kFarthest and right to kRounding; a few instructions.
int floorOf(double place)
{
    constexpr int kShift = 1 << 30;
    return int(place + double(kShift)) - kShift;
}

// One axis of the search, in texels; texel centres at whole numbers. The crossing of a wall is computed as exactHit computes it and grows
// from wall to wall, so that both visit the same cells at the same t.
struct Axis {
    double start, slope, inverse;
    int size, direction, ahead; // to larger cells: 1 and 1, else -1 and 0
    int tile = 0; // its first cell
    bool repeats;

    Axis(double uv, double duv, int texels, Wrap wrap)
        : start(uv * texels - 0.5)
        , slope(duv * texels)
        , inverse(inverseSlope(slope))
        , size(texels)
        , direction(slope < 0. ? -1 : 1)
        , ahead(slope < 0. ? 0 : 1)
        , repeats(wrap == Wrap::Repeat)
    {
    }
    bool isNear() const { return std::abs(start) < kFarthest && std::abs(slope) < kMaxReferenceCells / 2 - 4; }
    double crossing(double wall) const { return (wall - start) * inverse; }
    double place(double t) const { return start - double(tile) + slope * t; } // in the tile
    // Of a node of 2^shift cells of the tile.
    double enter(int node, int shift) const { return crossing(double(tile + ((node + 1 - ahead) << shift))); }
    double leave(int node, int shift) const { return crossing(double(tile + ((node + ahead) << shift))); }
    double fraction(int cell, double t) const { return start - double(tile + cell) + slope * t; }

    // The tile that the ray is in at t; where it crosses a wall just then, the one beyond. A tile that is clamped goes on without end.
    void findTile(double t)
    {
        if (!repeats)
            return;
        const int cell = floorOf(start + slope * t - kRounding * direction);
        tile = cell - wrapIndex(cell, size, Wrap::Repeat);
        if (leaveTile() <= t)
            nextTile();
    }
    double leaveTile() const { return repeats ? crossing(double(tile + size * ahead)) : kNever; }
    void nextTile() { tile += direction * size; }
    // Texels of a cell of the tile, which may lie beyond a clamped border or, by rounding, beside the tile.
    int low(int cell) const { return std::clamp(cell, 0, size - 1); }
    int high(int cell) const { return cell + 1 < size ? std::max(cell + 1, 0) : (repeats ? 0 : size - 1); }
};

constexpr int kFraction = 32; // bits of the fixed point of rows and heights
constexpr std::int64_t kSlack = std::int64_t(1) << (kFraction - 8); // exceeds the rounding of the steps of the longest ray

std::int64_t fixedPoint(double value)
{
    return std::int64_t(value * double(std::int64_t(1) << kFraction));
}

class Walk {
public:
    Walk(const HeightField& field, const ExactSearch::Grid* grids, const std::uint8_t* maxima, const SearchRay& ray, double raise)
        : x(ray.uv.x, ray.duv.x, field.width(), field.wrap())
        , y(ray.uv.y, ray.duv.y, field.height(), field.wrap())
        , top(1. - raise)
        // Rounding of uv(t) moves the surface by this much at most.
        , clear(
              top - 1e-12 - 1e-15 * (1. + std::abs(x.start) + std::abs(y.start) + std::abs(x.slope) + std::abs(y.slope) + std::abs(raise)))
        , m_steep(std::abs(y.slope) > std::abs(x.slope))
        , m_drift(fixedPoint(across().slope / std::max(std::abs(along().slope), 1e-300)))
        , m_sink(255. / std::max(std::abs(along().slope), 1e-300))
        , m_grids(grids)
        , m_maxima(maxima)
        , m_texels(field.texels().data())
    {
    }

    Axis x, y;
    double top, clear; // the ray is surely above a node of maximum m until t = clear - m
    int fetches = 0;

    // The first root in the nodes of a grid from `begin` to `end`, where the ray stays in one tile, or kNever. Column by column across
    // the longer axis, along which the rows and the height of the ray at a column's end grow by a constant: in fixed point, with slack
    // for rounding. In a column the ray crosses one or two rows of nodes, by slack three; beyond a clamped border columns and rows go on.
    double inGrid(int level, double begin, double end)
    {
        const Axis &a = along(), &b = across();
        const ExactSearch::Grid& grid = m_grids[level];
        const int shift = grid.shift, direction = a.direction;
        const int lastColumn = (m_steep ? grid.height : grid.width) - 1, lastRow = (m_steep ? grid.width : grid.height) - 1;
        const int columnStride = m_steep ? grid.width : 1, rowStride = m_steep ? 1 : grid.width;
        const std::uint8_t* maxima = m_maxima + grid.offset;

        int column = floorOf(a.place(begin) * grid.scale - kRounding * direction);
        const int beyond = floorOf(a.place(end) * grid.scale + kRounding * direction) + direction;
        const double leaveFirst = std::clamp(a.leave(column, shift), begin, end);
        const std::int64_t slack = b.direction * kSlack, sink = fixedPoint(std::min(m_sink * double(1 << shift), 1e6));
        std::int64_t from = fixedPoint(b.place(begin) * grid.scale) - slack, to = fixedPoint(b.place(leaveFirst) * grid.scale) + slack;
        std::int64_t next = to - 2 * slack, above = fixedPoint((clear - leaveFirst) * 255.) - kSlack;
        double root = kNever;
        for (; column != beyond; column += direction) {
            ++fetches;
            const int first = std::clamp(int(from >> kFraction), 0, lastRow), last = std::clamp(int(to >> kFraction), 0, lastRow);
            const std::uint8_t* nodes = maxima + std::clamp(column, 0, lastColumn) * columnStride;
            int most = std::max(nodes[first * rowStride], nodes[last * rowStride]);
            if (std::abs(last - first) > 1) [[unlikely]]
                most = std::max(most, int(nodes[(first + last) / 2 * rowStride]));
            if (most > int(above >> kFraction)) {
                const double enter = std::max({begin, a.enter(column, shift), clear - double(most) / 255.});
                const double leave = std::min(a.leave(column, shift), end);
                if (enter < leave)
                    root = level > 0 ? inGrid(level - 1, enter, leave) : inCells(column, shift, enter, leave);
                if (root != kNever)
                    break;
            }
            from = next;
            next += m_drift;
            to += m_drift;
            above -= sink;
        }
        return root;
    }

private:
    bool m_steep; // the longer axis of the ray is y
    std::int64_t m_drift; // rows to a column
    double m_sink; // 255ths of height to a column of cells
    const ExactSearch::Grid* m_grids;
    const std::uint8_t* m_maxima;
    const float* m_texels;

    const Axis& along() const { return m_steep ? y : x; }
    const Axis& across() const { return m_steep ? x : y; }

    // The same in the columns of cells of a column of nodes of the finest grid; those whose texels the ray stays above are not solved.
    double inCells(int column, int shift, double begin, double end)
    {
        const Axis &a = along(), &b = across();
        const int columnStride = m_steep ? x.size : 1, rowStride = m_steep ? 1 : x.size;
        int cell = (column << shift) + (1 - a.ahead) * ((1 << shift) - 1);
        for (int k = 0; k < 1 << shift; ++k, cell += a.direction) {
            const double enter = std::max(begin, a.enter(cell, 0)), leave = std::min(end, a.leave(cell, 0));
            if (enter >= leave)
                continue;
            const int first = floorOf(b.place(enter) - kRounding * b.direction), last = floorOf(b.place(leave) + kRounding * b.direction);
            const float* low = m_texels + a.low(cell) * columnStride;
            const float* high = m_texels + a.high(cell) * columnStride;
            int texel = b.low(std::min(first, last)) * rowStride;
            float most = std::max(low[texel], high[texel]);
            for (int row = std::min(first, last); row <= std::max(first, last); ++row) {
                texel = b.high(row) * rowStride;
                most = std::max({most, low[texel], high[texel]});
            }
            const double root = leave > clear - double(most) ? inColumn(cell, begin, end) : kNever;
            if (root != kNever)
                return root;
        }
        return kNever;
    }

    // The first root in a column of cells, solved as exactHit solves them.
    double inColumn(int column, double begin, double end)
    {
        const Axis &a = along(), &b = across();
        const int columnStride = m_steep ? x.size : 1, rowStride = m_steep ? 1 : x.size;
        const double enterColumn = std::max(a.enter(column, 0), 0.), leaveColumn = std::min(a.leave(column, 0), 1.);
        const float* low = m_texels + a.low(column) * columnStride;
        const float* high = m_texels + a.high(column) * columnStride;
        end = std::min(end, leaveColumn);
        int row = floorOf(b.place(std::max(begin, enterColumn)) - kRounding * b.direction); // perhaps one too early
        for (;; row += b.direction) {
            const double enter = std::max(enterColumn, b.enter(row, 0)), leave = std::min(leaveColumn, b.leave(row, 0));
            if (enter >= end)
                return kNever;
            if (leave <= begin)
                continue;
            const int rowLow = b.low(row) * rowStride, rowHigh = b.high(row) * rowStride;
            HeightField::Corners k{low[rowLow], high[rowLow], low[rowHigh], high[rowHigh]};
            if (m_steep)
                std::swap(k.h10, k.h01);
            const double u = x.fraction(m_steep ? row : column, enter), v = y.fraction(m_steep ? column : row, enter);
            const double after = cellRoot(k, u, v, x.slope, y.slope, top - enter, leave - enter);
            if (after != kNever)
                return std::min(enter + after, 1.);
        }
    }
};

} // namespace

ExactSearch::ExactSearch(const HeightField& field) : m_field(field)
{
    std::size_t size = 0;
    for (int shift = kFinest;; shift += kStep) {
        const int width = ((field.width() - 1) >> shift) + 1, height = ((field.height() - 1) >> shift) + 1;
        m_grids.push_back({width, height, shift, 1. / double(1 << shift), size});
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
std::uint8_t ExactSearch::maximum(int x, int y) const
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
    return std::uint8_t(std::ceil(double(most) * 255.));
}

std::uint8_t ExactSearch::maximumBelow(const Grid& below, int x, int y) const
{
    const int endX = std::min((x + 1) << kStep, below.width), endY = std::min((y + 1) << kStep, below.height);
    std::uint8_t most = 0;
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

    double t = std::max(0., walk.clear - double(m_maxima.back()) / 255.);
    if (t >= 1.)
        return found(1.);
    x.findTile(t), y.findTile(t);
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
