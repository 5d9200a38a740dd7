// Vertices joined by where they lie.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <cstdint>
#include <vector>

namespace relievo {

// One number a vertex, equal for all vertices of exactly one position, whatever their normals and UVs.
std::vector<std::uint32_t> placesOf(const Mesh& mesh);

} // namespace relievo
