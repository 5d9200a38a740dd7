// Crossings of rays, sorted by depth, and the solid between them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/columns.h"
#include "core/object/bake/sheets.h"
#include <glm/geometric.hpp>

namespace relievo {

namespace {
constexpr double kBeside = 1e-3; // of a gap between two crossings: where next to them it is asked what is inside
constexpr int kHalvings = 20; // of a gap in which an open mesh ends without a surface

struct Crossing {
    std::uint32_t ray; // row-major in the band
    float depth;
    std::int8_t winds; // by how much the winding number grows there
    bool isSheet;
};

// All rays of a grid `times` as fine as the texels, but for those of texels that are not wanted.
template <class Wanted> std::vector<Crossing> crossingsOf(const AxisView& view, const Band& band, int times, Wanted isWanted)
{
    const int width = band.size * times, first = band.first() * times;
    const RayGrid grid{width, width, first, first + band.rows() * times};
    std::vector<Crossing> found;
    const auto cross = [&](const Winding::Triangle& c, bool winds, bool isFlat, auto isThere) {
        forCrossings(grid, {glm::dvec2(c[0]), glm::dvec2(c[1]), glm::dvec2(c[2])}, [&](const RayCrossing& at) {
            const int row = at.y - first;
            if (!isWanted(at.x / times, row / times) || !isThere(at.weights))
                return;
            const double depth = c[0].z * at.weights.x + c[1].z * at.weights.y + c[2].z * at.weights.z;
            found.push_back({std::uint32_t(row) * std::uint32_t(width) + std::uint32_t(at.x), float(std::clamp(depth, 0., 1.)),
                std::int8_t(!winds  ? 0
                        : at.enters ? 1
                                    : -1),
                isFlat});
        });
    };
    const auto always = [](glm::dvec3) { return true; };
    for (const std::uint32_t triangle : band.triangles) {
        const auto c = view.corners(triangle);
        const TriangleKind kind = view.shells->kinds[triangle];
        const bool isFlat = isSheet(kind) && isFacing(view, c);
        if (kind != TriangleKind::Loose)
            cross(c, true, isFlat, always);
        else if (isFlat)
            cross(c, false, true, [&](glm::dvec3 weights) { return view.surface->isOpaque(triangle, weights); });
    }
    for (const std::uint32_t lid : band.lids)
        cross(view.onAxis(view.shells->lids[lid]), true, false, always);
    std::ranges::sort(found,
        [](const Crossing& a, const Crossing& b) { return std::tuple(a.ray, a.depth, -a.winds) < std::tuple(b.ray, b.depth, -b.winds); });
    return found;
}

// Along one ray.
class Resolver {
public:
    Resolver(const AxisView& view, glm::dvec2 uv) : m_view(view), m_uv(uv) { }

    Stretches resolve(std::span<const Crossing> crossings)
    {
        int closed = 0;
        double before = 0.;
        bool wasInside = false;
        for (std::size_t i = 0; i <= crossings.size(); ++i) {
            const bool isLast = i == crossings.size();
            const double next = isLast ? 1. : double(crossings[i].depth);
            if (i > 0 || !m_view.shells->ofLids.isEmpty())
                gap(before, next, closed, wasInside, i == 0, isLast);
            if (isLast)
                break;
            closed += crossings[i].winds;
            if (crossings[i].isSheet)
                m_found.push_back({next, next});
            before = next;
        }
        return std::move(m_found);
    }

private:
    bool isInside(int closed, double depth) const
    {
        if (m_view.shells->ofLids.isEmpty())
            return closed != 0;
        const AxisFrame& frame = kAxisFrames[m_view.axis];
        const glm::dvec3 p = (2. * m_uv.x - 1.) * frame.u + (2. * m_uv.y - 1.) * frame.v + (2. * depth - 1.) * frame.depth;
        return std::abs(closed - m_view.shells->ofLids.at(m_view.box.center + p * m_view.box.half)) > 0.5;
    }

    // Between two crossings; an open mesh may end in it without a surface. The box's borders are outside.
    void gap(double from, double to, int closed, bool& wasInside, bool isFirst, bool isLast)
    {
        const double beside = kBeside * (to - from);
        bool atStart = !isFirst && isInside(closed, from + beside), atEnd = !isLast && isInside(closed, to - beside);
        if (m_view.shells->ofLids.isEmpty() || !(to > from))
            atStart = atEnd = closed != 0 && !isFirst && !isLast;
        else if (!atStart && !atEnd && !isFirst && !isLast && isInside(closed, 0.5 * (from + to))) { // from hole to hole
            const double middle = 0.5 * (from + to);
            add(border(closed, from + beside, middle), border(closed, to - beside, middle), false);
            wasInside = false;
            return;
        }
        if (atStart == atEnd) {
            if (atStart)
                add(from, to, wasInside);
            wasInside = atEnd;
            return;
        }
        if (atStart)
            add(from, border(closed, to - beside, from + beside), wasInside);
        else
            add(border(closed, from + beside, to - beside), to, false);
        wasInside = atEnd;
    }

    // Where a gap that is open at one depth and solid at another becomes solid.
    double border(int closed, double open, double solid) const
    {
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (open + solid);
            (isInside(closed, middle) ? solid : open) = middle;
        }
        return solid;
    }

    void add(double from, double to, bool goesOn)
    {
        if (goesOn && !m_found.empty())
            m_found.back().second = to;
        else
            m_found.push_back({from, to});
    }

    const AxisView& m_view;
    glm::dvec2 m_uv;
    Stretches m_found;
};

// In order, and joined where they meet.
void tidy(Stretches& stretches)
{
    std::ranges::sort(stretches);
    std::size_t kept = 0;
    for (const Stretch& next : stretches)
        if (kept > 0 && next.first <= stretches[kept - 1].second)
            stretches[kept - 1].second = std::max(stretches[kept - 1].second, next.second);
        else
            stretches[kept++] = next;
    stretches.resize(kept);
}

// Calls found(column, row, stretches) for each ray that meets something; column and row in the finer grid of the band.
template <class Found> void forRays(const AxisView& view, const std::vector<Crossing>& crossings, const Band& band, int times, Found found)
{
    const int width = band.size * times;
    for (std::size_t i = 0, end = 0; i < crossings.size(); i = end) {
        while (end < crossings.size() && crossings[end].ray == crossings[i].ray)
            ++end;
        const int x = int(crossings[i].ray) % width, y = int(crossings[i].ray) / width;
        const glm::dvec2 uv{(x + 0.5) / width, (band.first() * times + y + 0.5) / width};
        Stretches stretches = Resolver(view, uv).resolve(std::span(crossings).subspan(i, end - i));
        tidy(stretches);
        if (!stretches.empty())
            found(x, y, std::move(stretches));
    }
}
} // namespace

Bands::Bands(std::size_t triangles, const Corners& corners, int rows)
{
    const int bands = (rows + kBandRows - 1) / kBandRows;
    const auto reach = [&](std::size_t triangle) {
        const Winding::Triangle c = corners(triangle);
        const auto [low, high] = std::minmax({c[0].y, c[1].y, c[2].y});
        const auto bandAt = [&](double row) { return std::clamp(int(std::floor(row / kBandRows)), 0, bands - 1); };
        return std::pair(bandAt(low * rows - 1.5), bandAt(high * rows + 1.5));
    };
    m_first.assign(std::size_t(bands) + 1, 0);
    for (std::size_t t = 0; t < triangles; ++t)
        for (auto [band, last] = reach(t); band <= last; ++band)
            ++m_first[std::size_t(band) + 1];
    for (std::size_t band = 0; band < std::size_t(bands); ++band)
        m_first[band + 1] += m_first[band];
    m_triangles.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t t = 0; t < triangles; ++t)
        for (auto [band, last] = reach(t); band <= last; ++band)
            m_triangles[next[std::size_t(band)]++] = std::uint32_t(t);
}

std::vector<Stretches> bandStretches(const AxisView& view, const Band& band, int supersample)
{
    const auto width = std::size_t(band.size);
    std::vector<Stretches> texels(std::size_t(band.rows()) * width);
    const auto number = [width](int x, int y) { return std::size_t(y) * width + std::size_t(x); };
    const auto isAny = [](int, int) { return true; };
    forRays(view, crossingsOf(view, band, 1, isAny), band, 1,
        [&](int x, int y, Stretches stretches) { texels[number(x, y)] = std::move(stretches); });
    if (supersample > 1) {
        std::vector<char> isFilled(texels.size());
        std::ranges::transform(texels, isFilled.begin(), [](const Stretches& s) { return char(!s.empty()); });
        const auto isEmpty = [&](int x, int y) { return !isFilled[number(x, y)]; };
        std::vector<float> nearest(texels.size(), 4.f); // squared, of where a texel is taken from, in texels from its middle
        forRays(view, crossingsOf(view, band, supersample, isEmpty), band, supersample, [&](int x, int y, Stretches stretches) {
            const auto aside = [&](int i) { return (float(i % supersample) + 0.5f) / float(supersample) - 0.5f; };
            const float distance = aside(x) * aside(x) + aside(y) * aside(y);
            const std::size_t texel = number(x / supersample, y / supersample);
            if (distance < nearest[texel]) {
                nearest[texel] = distance;
                texels[texel] = std::move(stretches);
            }
        });
    }
    if (view.areSheetsWide)
        addWideSheets(view, band, texels);
    for (Stretches& stretches : texels)
        tidy(stretches);
    return texels;
}

} // namespace relievo
