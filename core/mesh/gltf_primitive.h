// The triangles of one glTF primitive with every attribute that is used, in its own space.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/error.h"
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace relievo {

// Numbers in rows of 3 (points, normals), 2 (uvs) and 4 (tangents) for each vertex; an attribute that the primitive lacks is empty.
struct GltfPrimitive {
    std::vector<float> points, normals, uvs, tangents;
    std::vector<std::uint32_t> indices; // triples within the vertices
    std::size_t vertices() const { return points.size() / 3; }
};

// Whether it is made of triangles (and not of points or lines).
bool hasTriangles(const tinygltf::Primitive& primitive);

// uvSet: TEXCOORD_n, or the first where it is missing. Errors name `where` and what is wrong.
Expected<GltfPrimitive> readPrimitive(
    const tinygltf::Model& model, const tinygltf::Primitive& primitive, int uvSet, const std::string& where);

// An attribute of `count` rows of `components` numbers; empty where `attributes` does not hold it.
Expected<std::vector<float>> readAttribute(const tinygltf::Model& model, const std::map<std::string, int>& attributes,
    const std::string& key, int components, std::size_t count, const std::string& where);

} // namespace relievo
