// A mesh as the walk through the prisms of its relief reads it (shaders/view_ray/prisms.glsl).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace relievo {

inline constexpr std::size_t kPrismVertexTexels = 5, kPrismTriangleTexels = 2;

// One texel that says where the triangles begin, those of the vertices, those of the triangles; what each holds stands in the shader file.
// across: edgesAcross(mesh) of any pose; isPlain: for each part whether the relief ends there.
std::vector<glm::vec4> prismTexels(const Mesh& mesh, const std::vector<std::uint32_t>& across, const std::vector<char>& isPlain);

} // namespace relievo
