// What a mesh looks like at a point of a triangle: its materials' maps, read there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/material.h"
#include "core/mesh/mesh.h"
#include <glm/vec3.hpp>

namespace relievo {

// Below it a surface is not there, as alpha masks have it.
inline constexpr float kOpaque = 0.5f;

struct SurfacePoint {
    glm::vec3 color{0.f}; // linear
    glm::vec3 normal{0.f}; // unit, world; with the normal map's detail
    float roughness = 1.f;
};

class MeshSurface {
public:
    // The mesh must outlive it. A map that cannot be read is left out, with its warning. Errors: cancelled.
    static Expected<MeshSurface> load(const Mesh& mesh, const Progress& progress);

    const Mesh& mesh() const { return *m_mesh; }
    const Warnings& warnings() const { return m_warnings; }
    bool isCut(std::size_t triangle) const { return lookOf(triangle).opacity != nullptr; } // by opacity, somewhere perhaps
    // weights: what of each corner; they add up to 1.
    bool isOpaque(std::size_t triangle, glm::dvec3 weights) const;
    SurfacePoint at(std::size_t triangle, glm::dvec3 weights) const;

private:
    struct Look {
        std::shared_ptr<const Image> color, normal, roughness, gloss, opacity;
        MeshFactors factors;
        bool isPlain = true; // no colour is told
    };
    const Look& lookOf(std::size_t triangle) const { return m_looks[m_lookOfTriangle.empty() ? 0 : m_lookOfTriangle[triangle]]; }
    static Look lookOf(const MeshMaterial& material, Warnings& warnings, const Progress& progress);
    glm::vec2 uvAt(std::size_t triangle, glm::dvec3 weights) const;

    const Mesh* m_mesh = nullptr;
    std::vector<Look> m_looks; // at least one
    std::vector<std::uint16_t> m_lookOfTriangle; // empty: the first for all
    Warnings m_warnings;
};

} // namespace relievo
