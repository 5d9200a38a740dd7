// The generalised winding number of loose triangles, from far away by what whole groups of them add up to.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo {

// Barill et al. 2018, "Fast Winding Numbers for Soups and Clouds": a tree of triangles; a group that is further away than twice its radius
// counts as one dipole, single triangles by their solid angle (van Oosterom and Strackee 1983). 1 inside of what is closed and faces
// outwards, 0 outside.
class Winding {
public:
    using Triangle = std::array<glm::dvec3, 3>;
    explicit Winding(std::vector<Triangle> triangles);

    bool isEmpty() const { return m_triangles.empty(); }
    double at(glm::dvec3 point) const;

private:
    struct Node {
        std::uint32_t first = 0, count = 0; // into the triangles; the left half's node follows, the right half's is `right`
        std::uint32_t right = 0; // 0: a leaf
        glm::dvec3 center{0.}, area{0.}; // area: the sum of the triangles' normals by their areas
        double radius = 0.;
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t count);
    double below(std::uint32_t node, glm::dvec3 point) const;

    std::vector<Triangle> m_triangles;
    std::vector<Node> m_nodes;
};

} // namespace relievo
