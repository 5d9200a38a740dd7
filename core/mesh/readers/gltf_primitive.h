// The triangles of one glTF primitive with every attribute that is used, in its own space.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace relievo {

// Numbers in rows of 3 (points, normals), 2 (uvs) and 4 (tangents) for each vertex; an attribute that the primitive lacks is empty.
struct GltfPrimitive {
    std::vector<float> points, normals, uvs, tangents;
    std::vector<std::uint32_t> indices; // triples within the vertices
    bool hasData = true; // false: the positions are zeros, and perhaps some others, that take no room in the file
    int uvSet = -1; // the n of the TEXCOORD_n that uvs are; -1: none
    std::size_t vertices() const { return points.size() / 3; }
};

// Whether it is made of triangles (and not of points or lines).
bool hasTriangles(const tinygltf::Primitive& primitive);

// uvSet: TEXCOORD_n; where it is missing TEXCOORD_0, else any that there is. Errors name `where` and what is wrong.
Expected<GltfPrimitive> readPrimitive(
    const tinygltf::Model& model, const tinygltf::Primitive& primitive, int uvSet, const std::string& where);

// What the placement `world` does to directions, but for their length: so nothing vanishes in a scene of very small or large numbers.
struct Directions {
    glm::mat3 tangents, normals; // normals: they exist for flat scalings too
    bool mirrored;
};
Directions directionsOf(const glm::dmat4& world);

// An attribute of `count` rows of `components` numbers; empty where `attributes` does not hold it.
Expected<std::vector<float>> readAttribute(const tinygltf::Model& model, const std::map<std::string, int>& attributes,
    const std::string& key, int components, std::size_t count, const std::string& where);

} // namespace relievo
