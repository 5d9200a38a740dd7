// Distance transform of the solid below the surface, slice by slice, on a lattice of half voxels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/distance.h"
#include "core/maps/float_image.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// Along one axis: `voxels` voxels, each two columns wide; the columns reach `border` to each side of the tile.
struct Axis {
    int voxels, size; // size: texels of the field
    int columns() const { return 2 * voxels; }
    int border() const { return voxels + 4; } // half a tile: the distance never exceeds kDistanceHeightScale, a quarter
    int padded() const { return columns() + 2 * border(); }
    double columnWidth() const { return 0.5 / voxels; } // tiles
};

// The texel coordinates at which column `c` is cut by the texel centres: where the surface of a column may be highest.
std::vector<double> cuts(const Axis& axis, int c)
{
    const double from = double(c) * axis.size / axis.columns() - 0.5, to = double(c + 1) * axis.size / axis.columns() - 0.5;
    std::vector<double> list{from};
    for (double x = std::floor(from) + 1.; x < to; x += 1.)
        list.push_back(x);
    list.push_back(to);
    return list;
}

double heightAt(const HeightField& field, double x, double y)
{
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const HeightField::Corners c = field.corners(int(std::floor(x)), int(std::floor(y)));
    const double top = double(c.h00) * (1. - fx) + double(c.h10) * fx, bottom = double(c.h01) * (1. - fx) + double(c.h11) * fx;
    return top * (1. - fy) + bottom * fy;
}

// The highest point of the surface above each column of the tile; a bilinear patch is highest at a corner of its part of the column.
// Stops early when cancelled.
std::vector<float> columnHeights(const HeightField& field, const Axis& u, const Axis& v, const Progress& progress)
{
    std::vector<float> heights(std::size_t(u.columns()) * std::size_t(v.columns()));
    tbb::parallel_for(0, v.columns(), [&](int j) {
        if (progress.cancelled())
            return;
        const std::vector<double> ys = cuts(v, j);
        for (int i = 0; i < u.columns(); ++i) {
            double highest = 0.;
            for (const double x : cuts(u, i))
                for (const double y : ys)
                    highest = std::max(highest, heightAt(field, x, y));
            heights[std::size_t(j) * std::size_t(u.columns()) + std::size_t(i)] = std::nextafter(float(highest), 2.f);
        }
    });
    return heights;
}

// Squared distances in units of half voxels. The centre of voxel b of a line of columns is node 2 b + 1 of the lattice; column m spans the
// nodes m to m + 1, and the nearer of them is the gap.
class Line {
public:
    explicit Line(int padded) : m_lowest(std::size_t(padded)), m_site(std::size_t(padded)), m_from(std::size_t(padded) + 1) { }

    // costs: of the padded columns; out(b) for each voxel b: min over m of gap^2 + costs[m].
    template <class Out> void transform(const std::vector<float>& costs, const Axis& axis, float squaredStep, Out out)
    {
        const int count = axis.padded();
        for (int n = 0; n < count; ++n) { // least cost of the columns that reach node n
            float least = std::numeric_limits<float>::infinity();
            for (int m = std::max(0, n - 1); m <= n; ++m)
                least = std::min(least, costs[std::size_t(m)]);
            m_lowest[std::size_t(n)] = least / squaredStep;
        }
        envelope(count);
        std::size_t k = 0;
        for (int b = 0; b < axis.voxels; ++b) {
            const int node = axis.border() + 2 * b + 1;
            while (k + 1 < m_count && m_from[k + 1] < float(node))
                ++k;
            const float gap = float(node - m_site[k]);
            out(b, (gap * gap + m_lowest[std::size_t(m_site[k])]) * squaredStep);
        }
    }

private:
    void envelope(int count)
    {
        m_count = 0;
        for (int n = 0; n < count; ++n) {
            float from = -std::numeric_limits<float>::infinity();
            while (m_count > 0) {
                const int site = m_site[m_count - 1];
                const float a = m_lowest[std::size_t(n)] + float(n) * float(n), b = m_lowest[std::size_t(site)] + float(site) * float(site);
                from = (a - b) / (2.f * float(n - site));
                if (from > m_from[m_count - 1])
                    break;
                --m_count;
                from = -std::numeric_limits<float>::infinity();
            }
            m_site[m_count] = n;
            m_from[m_count++] = from;
        }
    }

    std::vector<float> m_lowest;
    std::vector<int> m_site;
    std::vector<float> m_from;
    std::size_t m_count = 0;
};

struct Volume {
    const HeightField& field;
    Axis u, v;
    std::vector<float> heights; // of the tile's columns

    float columnHeight(int i, int j) const
    {
        return heights[std::size_t(wrapIndex(j, v.columns(), field.wrap())) * std::size_t(u.columns())
            + std::size_t(wrapIndex(i, u.columns(), field.wrap()))];
    }

    // Slice k into out (u.voxels x v.voxels).
    void slice(int k, float* out) const
    {
        const float middle = 1.f - (float(k) + 0.5f) / float(kDistanceSlices); // height of the voxels' centres
        std::vector<float> costs(std::size_t(std::max(u.padded(), v.padded())));
        std::vector<float> rows(std::size_t(u.voxels) * std::size_t(v.columns()));
        Line line(int(costs.size()));
        const float stepU = float(u.columnWidth() * u.columnWidth()), stepV = float(v.columnWidth() * v.columnWidth());
        for (int j = 0; j < v.columns(); ++j) {
            for (int i = 0; i < u.padded(); ++i) {
                const float above = kDistanceHeightScale * std::max(0.f, middle - columnHeight(i - u.border(), j));
                costs[std::size_t(i)] = above * above;
            }
            line.transform(
                costs, u, stepU, [&](int b, float squared) { rows[std::size_t(j) * std::size_t(u.voxels) + std::size_t(b)] = squared; });
        }
        for (int i = 0; i < u.voxels; ++i) {
            for (int j = 0; j < v.padded(); ++j)
                costs[std::size_t(j)]
                    = rows[std::size_t(wrapIndex(j - v.border(), v.columns(), field.wrap())) * std::size_t(u.voxels) + std::size_t(i)];
            // Lattice coordinates are below 2^10, so their float squares are right to 1e-6 of a step.
            line.transform(costs, v, stepV, [&](int b, float squared) {
                out[std::size_t(b) * std::size_t(u.voxels) + std::size_t(i)]
                    = std::max(0.f, std::sqrt(std::max(0.f, squared)) * 0.9999f - 1e-5f);
            });
        }
    }
};

} // namespace

BakedMap bakeDistance(const HeightField& field, const Parameters&, const Progress& progress)
{
    const Axis u{std::min(field.width(), kDistanceSize), field.width()}, v{std::min(field.height(), kDistanceSize), field.height()};
    const Volume volume{field, u, v, columnHeights(field, u, v, progress)};
    BakedMap map = oneLevel(floatImage(u.voxels, v.voxels * kDistanceSlices, 1), kDistanceSlices);
    const std::size_t size = std::size_t(u.voxels) * std::size_t(v.voxels);
    std::atomic<int> done = 0;
    tbb::parallel_for(0, kDistanceSlices, [&](int k) {
        if (progress.cancelled())
            return;
        volume.slice(k, floats(map.levels[0]).data() + std::size_t(k) * size);
        progress.at(float(++done) / float(kDistanceSlices));
    });
    return map;
}

} // namespace relievo
