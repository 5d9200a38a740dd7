// What rays along one axis of a mesh's box pass through, in bands of rows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/bake/mesh_shells.h"
#include "core/object/bake/mesh_surface.h"
#include "core/object/bake/object_box.h"
#include "core/object/bake/raster.h"
#include <span>

namespace relievo {

inline constexpr int kBandRows = 16; // texels

// The triangles that reach into each band of kBandRows rows of a map, one texel further on both sides.
class Bands {
public:
    Bands(const Mesh& mesh, const ObjectBox& box, std::size_t axis, int rows);
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
    std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const
    {
        auto corners = cornersOf(surface->mesh(), triangle);
        for (glm::dvec3& corner : corners)
            corner = box.onAxis(axis, corner);
        return corners;
    }
};

// One band of a square map, `size` texels wide: the stretches of each of its texels (row-major, from row band * kBandRows on).
std::vector<Stretches> bandStretches(const AxisView& view, std::span<const std::uint32_t> triangles, int band, int size, int supersample);

} // namespace relievo
