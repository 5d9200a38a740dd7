// Silhouettes by prisms on the CPU: the prisms' shader text with a technique's own search.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "core/trace/shader_on_cpu.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string_view>
#include <vector>

namespace relievo {

struct TechniqueRow;

// Where a ray ends that goes from prism to prism.
struct PrismRayHit {
    bool found = false; // false: it left the relief, or its triangle is turned over there
    float depth = 0.f; // share of the relief's depth
    glm::vec2 uv{0.f}; // of the texture
    glm::vec3 point{0.f}; // m
    int triangle = -1; // in whose prism it lies
    int fetches = 0; // with those of the mesh's texels
};

// The relief on a mesh as it stands. Immutable; safe to read from any thread.
class Prisms {
public:
    // mesh: posed. parameters: depth, tiling, midlevel ... and those of the technique. Errors: a technique that does not search or has no
    // text, maps that are wanted and missing, those of the bake.
    static Expected<Prisms> make(std::string_view technique, const Parameters& parameters, const Mesh& mesh, const HeightField& field);

    // start: where the ray meets the outer surface of the triangle (with the push for the midlevel), from either side; way: unit.
    PrismRayHit hit(int triangle, glm::vec3 start, glm::vec3 way) const;
    // Whether relief hides the light from a point that was found; toLight: unit; isFront: seen from the triangle's front.
    bool isHidden(const PrismRayHit& from, glm::vec3 toLight, bool isFront = true) const;
    // The corners of a triangle of the outer surface, m.
    glm::vec3 outerCorner(int triangle, int corner) const;

private:
    struct Impl;
    std::shared_ptr<const Impl> m;
};

} // namespace relievo
