// Exact ray against height field, down and up a pyramid of maxima.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/exact_search.h"
#include "core/trace/cell_root.h"
#include "core/trace/reference.h"
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

constexpr double kFarthest = double(1 << 29); // texels; cell indices are ints

// One axis of the search, in texels; texel centres at whole numbers. A level l node spans 2^l cells, counted from its tile's first, and
// ends where the tile does. The crossing of a wall is computed as exactHit computes it and grows with the wall, so that both visit
// the same cells at the same t.
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
    double crossing(int wall) const { return (double(wall) - start) * inverse; }
    double fraction(double t) const { return start - double(cell) + slope * t; }
    double enter() const { return crossing(cell + 1 - ahead); }

    // The cell that the ray is in at t; where it crosses a wall just then, the one beyond.
    void moveTo(double t)
    {
        const double at = start + slope * t;
        cell = int(at);
        cell -= at < double(cell);
        while (crossing(cell + ahead) <= t)
            cell += 2 * ahead - 1;
        while (enter() > t)
            cell -= 2 * ahead - 1;
    }
    void findTile()
    {
        if (repeats)
            tile = cell - wrapIndex(cell, size, Wrap::Repeat);
    }
    // The cell as an index of the pyramid; beyond a clamped border the last one goes on.
    int key() const { return repeats ? cell - tile : std::clamp(cell, 0, size - 1); }

    // The wall through which the ray leaves its node of a level, and when.
    int wall(int level) const { return level == 0 ? cell + ahead : tile + std::min(((key() >> level) + ahead) << level, size); }
    double leave(int level, int wallThere) const
    {
        if (!repeats && level > 0 && wallThere == size * ahead)
            return kNever;
        return crossing(wallThere);
    }
    void pass(int wallThere)
    {
        cell = wallThere - 1 + ahead;
        if (repeats && cell >= tile + size)
            tile += size;
        else if (repeats && cell < tile)
            tile -= size;
    }
    int low() const { return key(); }
    int high() const
    {
        if (repeats)
            return cell - tile + 1 == size ? 0 : cell - tile + 1;
        return std::clamp(cell + 1, 0, size - 1);
    }
};

bool isNear(const Axis& axis)
{
    return std::abs(axis.start) < kFarthest && std::abs(axis.slope) < kMaxReferenceCells / 2 - 4;
}

SearchHit found(const SearchRay& ray, double t, int fetches)
{
    return {true, t, ray.uv + ray.duv * t, fetches};
}

float highest(const HeightField::Corners& k)
{
    return std::max(std::max(k.h00, k.h10), std::max(k.h01, k.h11));
}

// Maximum of the texels that the cells [x, x + 2) x [y, y + 2) touch.
float maximumOfCells(const HeightField& field, int x, int y)
{
    float most = 0.f;
    for (int j = y; j <= std::min(y + 2, field.height()); ++j)
        for (int i = x; i <= std::min(x + 2, field.width()); ++i)
            most = std::max(most, field.texel(i, j));
    return most;
}

} // namespace

ExactSearch::ExactSearch(const HeightField& field)
    : m_field(field)
    , m_maxima(makeMaxLevels((field.width() + 1) / 2, (field.height() + 1) / 2))
{
    const MaxLevels::Level finest = m_maxima.levels.front();
    tbb::parallel_for(0, finest.height, [&](int j) {
        for (int i = 0; i < finest.width; ++i)
            m_maxima.values[std::size_t(j) * std::size_t(finest.width) + std::size_t(i)] = maximumOfCells(field, 2 * i, 2 * j);
    });
    finishMaxLevels(m_maxima);
}

SearchHit ExactSearch::hit(const SearchRay& ray, double raise) const
{
    Axis x(ray.uv.x, ray.duv.x, m_field.width(), m_field.wrap()), y(ray.uv.y, ray.duv.y, m_field.height(), m_field.wrap());
    if (!isNear(x) || !isNear(y))
        return exactHit(m_field, ray, raise);

    // Rounding of uv(t) moves the surface by this much at most, and the ray is above a node when it is above it by the margin.
    const double size = 1. + std::abs(x.start) + std::abs(y.start) + std::abs(x.slope) + std::abs(y.slope);
    const double top = 1. - raise, clear = top - 1e-12 - 1e-15 * (size + std::abs(raise));
    double t = std::max(0., clear - double(m_maxima.values.back()));
    if (t >= 1.)
        return found(ray, 1., 1);
    x.moveTo(t), y.moveTo(t);
    x.findTile(), y.findTile();

    const float* texels = m_field.texels().data();
    const std::size_t width = std::size_t(m_field.width());
    const int root = int(m_maxima.levels.size());
    int level = root;
    for (int fetches = 1;; ++fetches) {
        const int wallX = x.wall(level), wallY = y.wall(level);
        const double leaveX = x.leave(level, wallX), leaveY = y.leave(level, wallY);
        const double leave = std::min(std::min(leaveX, leaveY), 1.);
        if (level > 0) {
            const double down = clear - double(m_maxima.at(level - 1, x.key() >> level, y.key() >> level));
            if (down < leave) {
                if (down > t) {
                    t = down;
                    x.moveTo(t), y.moveTo(t);
                }
                --level;
                continue;
            }
        } else {
            const float *row0 = texels + std::size_t(y.low()) * width, *row1 = texels + std::size_t(y.high()) * width;
            const HeightField::Corners k{row0[x.low()], row0[x.high()], row1[x.low()], row1[x.high()]};
            if (clear - double(highest(k)) < leave) {
                const double enter = std::max(0., std::max(x.enter(), y.enter()));
                const double after = cellRoot(k, x.fraction(enter), y.fraction(enter), x.slope, y.slope, top - enter, leave - enter);
                if (after != kNever)
                    return found(ray, std::min(enter + after, 1.), fetches);
            }
        }
        if (leave >= 1.)
            return found(ray, 1., fetches);
        const int keyX = x.key(), keyY = y.key();
        t = leave;
        if (leaveX <= leave)
            x.pass(wallX);
        else if (level > 0)
            x.moveTo(t);
        if (leaveY <= leave)
            y.pass(wallY);
        else if (level > 0)
            y.moveTo(t);
        if (level < root && ((keyX ^ x.key()) | (keyY ^ y.key())) >> (level + 1) != 0)
            ++level;
    }
}

} // namespace relievo
