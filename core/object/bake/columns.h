// What rays along one axis of a mesh's box pass through, in bands of rows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/bake/mesh_shells.h"
#include "core/object/bake/mesh_surface.h"
#include "core/object/bake/object_box.h"
#include "core/object/bake/raster.h"
#include <functional>
#include <span>

namespace relievo {

inline constexpr int kBandRows = 16; // texels

// The triangles that reach into each band of kBandRows rows of a map, one texel further on both sides.
class Bands {
public:
    using Corners = std::function<Winding::Triangle(std::size_t)>; // of a triangle, by u, v and depth
    Bands(std::size_t triangles, const Corners& corners, int rows);
    int count() const { return int(m_first.size()) - 1; }
    std::span<const std::uint32_t> of(int band) const
    {
        return std::span(m_triangles).subspan(m_first[std::size_t(band)], m_first[std::size_t(band) + 1] - m_first[std::size_t(band)]);
    }

private:
    std::vector<std::uint32_t> m_triangles;
    std::vector<std::size_t> m_first;
};

// Stretches of solid along one ray, depths in 0..1, in order and apart from each other.
using Stretch = std::pair<double, double>;
using Stretches = std::vector<Stretch>;

// A mesh as rays along one axis see it.
struct AxisView {
    const MeshSurface* surface = nullptr;
    const MeshShells* shells = nullptr;
    ObjectBox box;
    std::size_t axis = 0;
    bool areSheetsWide = false; // what the sheets' edges hide is filled: other axes tell where they are
    // Corners by u, v and depth.
    Winding::Triangle onAxis(Winding::Triangle corners) const
    {
        for (glm::dvec3& corner : corners)
            corner = box.onAxis(axis, corner);
        return corners;
    }
    Winding::Triangle corners(std::uint32_t triangle) const { return onAxis(cornersOf(surface->mesh(), triangle)); }
};

// One band of a square map, `size` texels wide.
struct Band {
    std::span<const std::uint32_t> triangles, lids; // that reach into it
    int number = 0, size = 0;
    int first() const { return number * kBandRows; } // row
    int rows() const { return std::min(kBandRows, size - first()); }
};
// The stretches of each texel of a band, row-major.
std::vector<Stretches> bandStretches(const AxisView& view, const Band& band, int supersample);

} // namespace relievo
