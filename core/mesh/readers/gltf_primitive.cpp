// Reading the attributes and indices of a glTF primitive; strips and fans become triangles.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/gltf_primitive.h"
#include "core/gltf/gltf_json.h"
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/gltf_accessor.h"
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <numeric>

namespace relievo {

namespace {

std::vector<std::uint32_t> triples(int mode, std::vector<std::uint32_t> in)
{
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        in.resize(in.size() - in.size() % 3);
        return in;
    }
    std::vector<std::uint32_t> out;
    for (std::size_t i = 2; i < in.size(); ++i) {
        const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP, odd = i % 2 == 1;
        const std::uint32_t a = strip ? in[odd ? i - 1 : i - 2] : in[0], b = strip ? in[odd ? i - 2 : i - 1] : in[i - 1];
        if (!strip || (a != b && b != in[i] && in[i] != a)) // equal corners only stitch strips together
            out.insert(out.end(), {a, b, in[i]});
    }
    return out;
}

int modeOf(const tinygltf::Primitive& primitive)
{
    return primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
}

Expected<std::vector<std::uint32_t>> trianglesOf(
    const tinygltf::Model& model, const tinygltf::Primitive& primitive, std::size_t vertices, const std::string& where)
{
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0) {
        Expected<std::vector<std::uint32_t>> read = readIndices(model, primitive.indices, where);
        if (!read)
            return read;
        indices = std::move(*read);
    } else {
        indices.resize(vertices);
        std::iota(indices.begin(), indices.end(), 0u);
    }
    for (const std::uint32_t index : indices)
        if (index >= vertices)
            return failure(ErrorCode::Unreadable, where,
                "a triangle names the vertex " + std::to_string(index) + " of " + std::to_string(vertices), kDamagedGltf);
    return triples(modeOf(primitive), std::move(indices));
}

// The set that is wanted, else one that there is; -1: there is none.
int uvSetOf(const tinygltf::Primitive& primitive, int wanted)
{
    for (const int set : {wanted, 0})
        if (primitive.attributes.contains("TEXCOORD_" + std::to_string(set)))
            return set;
    for (const auto& [key, accessor] : primitive.attributes)
        if (key.starts_with("TEXCOORD_"))
            if (const std::optional<long long> set = integerOf(std::string_view(key).substr(9)); set && *set > 0 && *set < 100)
                return int(*set);
    return -1;
}

glm::mat3 withLargest1(const glm::dmat3& matrix)
{
    double largest = 0.0;
    for (int k = 0; k < 9; ++k)
        largest = std::max(largest, std::abs(matrix[k / 3][k % 3]));
    return largest > 0.0 ? glm::mat3(matrix / largest) : glm::mat3(0.f);
}
} // namespace

Directions directionsOf(const glm::dmat4& world)
{
    const glm::dmat3 m(world);
    const bool mirrored = glm::determinant(m) < 0.0;
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return {withLargest1(m), withLargest1(mirrored ? -cofactors : cofactors), mirrored};
}

bool hasTriangles(const tinygltf::Primitive& primitive)
{
    return modeOf(primitive) >= TINYGLTF_MODE_TRIANGLES && modeOf(primitive) <= TINYGLTF_MODE_TRIANGLE_FAN;
}

Expected<std::vector<float>> readAttribute(const tinygltf::Model& model, const std::map<std::string, int>& attributes,
    const std::string& key, int components, std::size_t count, const std::string& where)
{
    const auto found = attributes.find(key);
    if (found == attributes.end())
        return std::vector<float>();
    Expected<std::vector<float>> values = readFloats(model, found->second, components, where);
    if (values && values->size() != count * std::size_t(components))
        return failure(ErrorCode::Unreadable, where, "a primitive has another number of " + key + " than of positions", kDamagedGltf);
    return values;
}

Expected<GltfPrimitive> readPrimitive(
    const tinygltf::Model& model, const tinygltf::Primitive& primitive, int uvSet, const std::string& where)
{
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end())
        return failure(ErrorCode::Unreadable, where, "a primitive has no positions", kDamagedGltf);
    if (primitive.extensions.contains("KHR_draco_mesh_compression") && std::size_t(position->second) < model.accessors.size()
        && model.accessors[std::size_t(position->second)].bufferView < 0)
        return failure(ErrorCode::Unreadable, where, "its triangles are compressed by KHR_draco_mesh_compression, which is not read",
            "Export it without compression");
    Expected<std::vector<float>> points = readFloats(model, position->second, 3, where);
    if (!points)
        return tl::unexpected(points.error());
    GltfPrimitive read;
    read.points = std::move(*points);
    read.hasData = model.accessors[std::size_t(position->second)].bufferView >= 0;
    read.uvSet = uvSetOf(primitive, uvSet);
    const std::string texCoord = "TEXCOORD_" + std::to_string(read.uvSet);
    struct AttributeRow {
        std::string key;
        int components;
        std::vector<float>* values;
    };
    for (const AttributeRow& row : {AttributeRow{"NORMAL", 3, &read.normals}, {texCoord, 2, &read.uvs}, {"TANGENT", 4, &read.tangents}}) {
        Expected<std::vector<float>> values = readAttribute(model, primitive.attributes, row.key, row.components, read.vertices(), where);
        if (!values)
            return tl::unexpected(values.error());
        *row.values = std::move(*values);
    }
    Expected<std::vector<std::uint32_t>> indices = trianglesOf(model, primitive, read.vertices(), where);
    if (!indices)
        return tl::unexpected(indices.error());
    read.indices = std::move(*indices);
    return read;
}

} // namespace relievo
