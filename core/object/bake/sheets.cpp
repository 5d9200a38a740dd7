// Triangles cut to the squares of texels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/sheets.h"
#include <boost/container/static_vector.hpp>
#include <glm/geometric.hpp>

namespace relievo {

namespace {
constexpr double kAround = 1.; // texels

using Polygon = boost::container::static_vector<glm::dvec3, 12>; // a triangle cut four times has seven corners

// What of it lies at sign * (p[axis] - at) >= 0.
Polygon cut(const Polygon& polygon, int axis, double at, double sign)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
        if (da >= 0.)
            kept.push_back(a);
        if ((da >= 0.) != (db >= 0.))
            kept.push_back(a + (b - a) * (da / (da - db)));
    }
    return kept;
}
} // namespace

bool isFacing(const AxisView& view, const std::array<glm::dvec3, 3>& corners)
{
    if (!view.areSheetsWide)
        return true;
    const glm::dvec3 size = [&] {
        const AxisFrame& frame = kAxisFrames[view.axis];
        return glm::dvec3(glm::dot(view.box.half, glm::abs(frame.u)), glm::dot(view.box.half, glm::abs(frame.v)),
            glm::dot(view.box.half, glm::abs(frame.depth)));
    }();
    const glm::dvec3 up = glm::abs(glm::cross((corners[1] - corners[0]) * size, (corners[2] - corners[0]) * size));
    const glm::dvec3 world = glm::abs(up.x * kAxisFrames[view.axis].u) + glm::abs(up.y * kAxisFrames[view.axis].v)
        + glm::abs(up.z * kAxisFrames[view.axis].depth);
    const int most = world.x >= world.y && world.x >= world.z ? 0 : world.y >= world.z ? 1 : 2;
    return most == int(view.axis);
}

void addWideSheets(const AxisView& view, const Band& band, std::vector<Stretches>& texels)
{
    const double size = band.size;
    for (const std::uint32_t triangle : band.triangles) {
        if (!isSheet(view.shells->kinds[triangle]))
            continue;
        const auto c = view.corners(triangle);
        if (isFacing(view, c))
            continue;
        const Polygon whole(c.begin(), c.end());
        const glm::dvec3 low = glm::min(glm::min(c[0], c[1]), c[2]), high = glm::max(glm::max(c[0], c[1]), c[2]);
        const auto index = [&](double at) { return int(std::floor(at * size)); };
        const int fromY = std::max(index(low.y - kAround / size), band.first()),
                  toY = std::min(index(high.y + kAround / size), band.first() + band.rows() - 1);
        for (int y = fromY; y <= toY; ++y) {
            const Polygon strip = cut(cut(whole, 1, (y - kAround) / size, 1.), 1, (y + 1 + kAround) / size, -1.);
            if (strip.empty())
                continue;
            const auto [left, right] = std::ranges::minmax(strip, {}, &glm::dvec3::x);
            const int fromX = std::max(index(left.x - kAround / size), 0), toX = std::min(index(right.x + kAround / size), band.size - 1);
            for (int x = fromX; x <= toX; ++x) {
                const Polygon piece = cut(cut(strip, 0, (x - kAround) / size, 1.), 0, (x + 1 + kAround) / size, -1.);
                if (piece.empty())
                    continue;
                const auto [near, far] = std::ranges::minmax(piece, {}, &glm::dvec3::z);
                texels[std::size_t(y - band.first()) * std::size_t(band.size) + std::size_t(x)].push_back(
                    {std::max(near.z - kAround / size, 0.), std::min(far.z + kAround / size, 1.)});
            }
        }
    }
}

} // namespace relievo
