// Branch and bound for cell cones: the steepest rise from a node of cells to anything outside it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/cell_cones.h"
#include "core/maps/acceleration/max_levels.h"
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// A branch is taken at its bound, not opened, when the steepest bound of a cell found is at least this share of it.
constexpr float kKeep = 0.88f;
constexpr float kMargin = 1.f + 2e-6f; // covers the float arithmetic of one ratio

struct Rect {
    float x0, y0, x1, y1; // texels
};
float gap(float a0, float a1, float b0, float b1)
{
    return std::max({0.f, b0 - a1, a0 - b1});
}

// The cells' maxima as a pyramid, and how it lies in the plane.
struct Grid {
    const HeightField& field;
    MaxLevels cells;
    float du, dv; // tiles per texel
    int width, height, reach; // reach: tiles to each side that are searched

    explicit Grid(const HeightField& f)
        : field(f)
        , cells(makeMaxLevels(f.width(), f.height()))
        , du(1.f / float(f.width()))
        , dv(1.f / float(f.height()))
        , width(f.width())
        , height(f.height())
        , reach(f.wrap() == Wrap::Repeat ? 1 : 0)
    {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const HeightField::Corners c = field.corners(x, y);
                cells.values[std::size_t(y) * std::size_t(width) + std::size_t(x)] = std::max({c.h00, c.h10, c.h01, c.h11});
            }
        finishMaxLevels(cells);
    }
    Rect rect(int level, int i, int j, int tileX, int tileY) const
    {
        const int x = tileX * width, y = tileY * height;
        return {float(x + (i << level)), float(y + (j << level)), float(x + std::min((i + 1) << level, width)),
            float(y + std::min((j + 1) << level, height))};
    }
    float distance(const Rect& a, const Rect& b) const
    {
        const float x = du * gap(a.x0, a.x1, b.x0, b.x1), y = dv * gap(a.y0, a.y1, b.y0, b.y1);
        return std::sqrt(x * x + y * y);
    }
};

// One node's search.
class RiseSearch {
public:
    explicit RiseSearch(const Grid& grid) : m_grid(grid) { }

    // At least the true rise, and at most 1/kKeep of the steepest bound of a cell.
    float rise(const Rect& node, float cap)
    {
        m_node = node;
        m_cap = cap;
        m_reached = m_safe = 0.f;
        if (m_grid.cells.at(m_grid.cells.top(), 0, 0) <= cap)
            return 0.f;
        tryLast();
        visitTile(0, 0);
        for (int y = -m_grid.reach; y <= m_grid.reach; ++y)
            for (int x = -m_grid.reach; x <= m_grid.reach; ++x)
                if (x != 0 || y != 0)
                    visitTile(x, y);
        return std::max(m_safe, m_reached) * kMargin;
    }

private:
    struct Item {
        int level, i, j;
        float bound;
    };

    void tryLast()
    {
        const Rect at = m_grid.rect(0, m_lastI, m_lastJ, m_lastX, m_lastY);
        if (m_grid.distance(m_node, at) > 0.f)
            cell(m_lastI, m_lastJ, m_lastX, m_lastY);
    }

    // Steepest possible rise to a node; infinity when it touches. Below 0: no obstacle.
    float bound(int level, int i, int j, int tileX, int tileY) const
    {
        const float over = m_grid.cells.at(level, i, j) - m_cap;
        if (over <= 0.f)
            return -1.f;
        const float d = m_grid.distance(m_node, m_grid.rect(level, i, j, tileX, tileY));
        return d > 0.f ? over / d : 1e30f;
    }

    void visitTile(int tileX, int tileY)
    {
        int count = 0;
        push(count, {m_grid.cells.top(), 0, 0, bound(m_grid.cells.top(), 0, 0, tileX, tileY)});
        while (count > 0) {
            const Item item = m_stack[std::size_t(--count)];
            if (item.bound * kKeep <= m_reached) {
                m_safe = std::max(m_safe, item.bound);
                continue;
            }
            if (item.level == 0) {
                cell(item.i, item.j, tileX, tileY);
                continue;
            }
            open(item, tileX, tileY, count);
        }
    }

    // Children, the most limiting one on top of the stack.
    void open(const Item& item, int tileX, int tileY, int& count)
    {
        const MaxLevels::Level& below = m_grid.cells.levels[std::size_t(item.level - 1)];
        const int first = count;
        for (int j = 2 * item.j; j <= 2 * item.j + 1 && j < below.height; ++j)
            for (int i = 2 * item.i; i <= 2 * item.i + 1 && i < below.width; ++i) {
                push(count, {item.level - 1, i, j, bound(item.level - 1, i, j, tileX, tileY)});
                for (int k = count - 1; k > first && m_stack[std::size_t(k - 1)].bound > m_stack[std::size_t(k)].bound; --k)
                    std::swap(m_stack[std::size_t(k - 1)], m_stack[std::size_t(k)]);
            }
    }
    void push(int& count, const Item& item)
    {
        if (item.bound > 0.f)
            m_stack[std::size_t(count++)] = item;
    }

    // The rise to one cell: for any direction (a, b) >= 0 of length 1, |q - p| >= a X(q) + b Y(q), where X and Y, the axis distances of q
    // to the node, are linear over the cell, and h(q) is a mean of corners weighted alike; so the steepest corner bounds all of the cell.
    void cell(int i, int j, int tileX, int tileY)
    {
        const Rect at = m_grid.rect(0, i, j, tileX, tileY);
        if (at.x0 >= m_node.x0 && at.x1 <= m_node.x1 && at.y0 >= m_node.y0 && at.y1 <= m_node.y1)
            return; // within the node
        const HeightField::Corners c = m_grid.field.corners(i, j);
        const std::array<float, 4> over = {c.h00 - m_cap, c.h10 - m_cap, c.h01 - m_cap, c.h11 - m_cap};
        const auto axis = [](float low, float high, float p) { return std::max({0.f, low - p, p - high}); };
        const float X[2] = {m_grid.du * axis(m_node.x0, m_node.x1, at.x0), m_grid.du * axis(m_node.x0, m_node.x1, at.x1)};
        const float Y[2] = {m_grid.dv * axis(m_node.y0, m_node.y1, at.y0), m_grid.dv * axis(m_node.y0, m_node.y1, at.y1)};
        const float middleX = 0.5f * (X[0] + X[1]), middleY = 0.5f * (Y[0] + Y[1]);
        const float length = std::sqrt(middleX * middleX + middleY * middleY);
        const float directions[3][2] = {{1.f, 0.f}, {0.f, 1.f}, {middleX / length, middleY / length}};
        float least = std::max({over[0], over[1], over[2], over[3]}) / std::max(m_grid.distance(m_node, at), 1e-30f);
        for (const auto& [a, b] : directions) {
            float steepest = 0.f;
            for (std::size_t k = 0; k < 4; ++k)
                if (over[k] > 0.f)
                    steepest = std::max(steepest, over[k] / std::max(a * X[k & 1] + b * Y[k >> 1], 1e-30f));
            least = std::min(least, steepest);
        }
        if (least > m_reached) {
            m_reached = least;
            m_lastI = i, m_lastJ = j, m_lastX = tileX, m_lastY = tileY;
        }
    }

    const Grid& m_grid;
    Rect m_node{};
    float m_cap = 0.f, m_reached = 0.f, m_safe = 0.f;
    int m_lastI = 0, m_lastJ = 0, m_lastX = 0, m_lastY = 0; // limited the node before: a good first guess
    std::array<Item, 128> m_stack;
};

// Rises of all nodes of one pyramid level.
std::vector<float> risesOf(const Grid& grid, int level, const std::function<void(float)>& report, const Progress& progress)
{
    const MaxLevels::Level& nodes = grid.cells.levels[std::size_t(level)];
    std::vector<float> rises(std::size_t(nodes.width) * std::size_t(nodes.height));
    std::atomic<int> done = 0;
    tbb::parallel_for(tbb::blocked_range<int>(0, nodes.height), [&](const auto& rows) {
        for (int j = rows.begin(); j < rows.end() && !progress.cancelled(); ++j) {
            RiseSearch search(grid); // anew for each row: the same map however the rows are shared out
            for (int i = 0; i < nodes.width; ++i)
                rises[std::size_t(j) * std::size_t(nodes.width) + std::size_t(i)]
                    = search.rise(grid.rect(level, i, j, 0, 0), grid.cells.at(level, i, j));
            report(float(++done) / float(nodes.height));
        }
    });
    return rises;
}

struct Codes {
    float lowest, range, steepest;

    unsigned cap(float h) const
    {
        const float unit = range / 255.f;
        unsigned c = unit > 0.f ? unsigned(std::clamp((h - lowest) / unit, 0.f, 255.f)) : 0u;
        while (c < 255 && lowest + float(c) * unit < h)
            ++c;
        return c;
    }
    unsigned steep(float rise) const
    {
        const float unit = steepest / 65025.f;
        unsigned k = unit > 0.f ? unsigned(std::clamp(std::sqrt(rise / unit), 0.f, 255.f)) : 0u;
        while (k < 255 && float(k) * float(k) * unit < rise)
            ++k;
        return k;
    }
};

} // namespace

BakedMap bakeCellCones(const HeightField& field, const Parameters&, const Progress& progress)
{
    const Grid grid(field);
    std::array<int, 4> levels; // of the pyramid, for each channel; a small field ends earlier
    std::array<std::vector<float>, 4> rises;
    float steepest = 0.f;
    for (std::size_t n = 0; n < 4; ++n) {
        levels[n] = std::min(2 * int(n) + 1, grid.cells.top());
        const float from = n == 0 ? 0.f : 0.8f + 0.05f * float(n), to = n == 0 ? 0.8f : from + 0.05f;
        rises[n] = risesOf(
            grid, levels[n], [&](float share) { progress.at(from + share * (to - from)); }, progress);
        for (const float rise : rises[n])
            steepest = std::max(steepest, rise);
    }
    const auto [low, high] = std::ranges::minmax(field.texels());
    const Codes codes{low, (high - low) * (1.f + 4e-7f), steepest * (1.f + 4e-7f)};
    const int width = (field.width() + 1) / 2, height = (field.height() + 1) / 2;
    Image image{width, height, 4, PixelType::U16, 16, false, {}};
    image.data.resize(image.texelCount() * 8);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            std::array<std::uint16_t, 4> texel;
            for (std::size_t n = 0; n < 4; ++n) {
                const int i = 2 * x >> levels[n], j = 2 * y >> levels[n];
                const int across = grid.cells.levels[std::size_t(levels[n])].width;
                texel[n] = std::uint16_t(256u * codes.cap(grid.cells.at(levels[n], i, j))
                    + codes.steep(rises[n][std::size_t(j) * std::size_t(across) + std::size_t(i)]));
            }
            std::memcpy(image.data.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 8, texel.data(), 8);
        }
    });
    BakedMap map;
    map.levels.push_back(std::move(image));
    map.scale = {codes.lowest, codes.range, codes.steepest, high};
    return map;
}

} // namespace relievo
