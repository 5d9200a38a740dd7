// Sets of search rays: angle bands for measuring, and special rays that searches trip over.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/techniques.h"
#include "core/trace/ray.h"
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace relievo {

// Angles between the view and the surface's normal, degrees.
struct AngleBand {
    double from, to;
    bool operator==(const AngleBand&) const = default;
};
inline constexpr std::array<AngleBand, 4> kAngleBands = {{{0., 60.}, {60., 80.}, {80., 88.}, {88., 89.9}}};

// The ray at `angle` degrees from the normal, in azimuth `turn` (radians): |duv| = depth * tan(angle), cosView = cos(angle).
// depth: share of the tile. Every number of every ray here can be held by a float, so that all machines answer the same question.
SearchRay rayAt(glm::dvec2 uv, double angle, double turn, double depth);

// `count` rays, angle uniform in the band, azimuth and start uniform. Equal arguments give equal rays.
std::vector<SearchRay> bandRays(AngleBand band, double depth, int count, std::uint32_t seed);

// The same rays from where they meet the mesh that the technique draws on, if white lies where they begin (TechniqueRow::meshDepth).
std::vector<SearchRay> atMesh(const TechniqueRow& technique, std::span<const SearchRay> rays);

struct RaySetRow {
    std::string_view key;
    // width, height: texels of the field they are meant for; count: about how many.
    std::vector<SearchRay> (*make)(int width, int height, double depth, int count, std::uint32_t seed);
    bool measured; // has an exact answer worth comparing with; else a search only has to survive it
    std::string_view help;
};
extern const std::array<RaySetRow, 13> kSpecialRays;

} // namespace relievo
