// glTF 2.0, text and binary: the triangles of a scene in world space.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/gltf_accessor.h"
#include "core/mesh/gltf_document.h"
#include "core/mesh/raw_mesh.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;
const char* const kDamaged = "Check the file with a glTF validator and export it again";

glm::mat4 localMatrix(const tinygltf::Node& node)
{
    glm::mat4 matrix(1.f);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = float(node.matrix[std::size_t(i)]);
        return matrix;
    }
    const auto number = [](const std::vector<double>& list, std::size_t i) { return float(list[i]); };
    if (node.translation.size() == 3)
        matrix = glm::translate(matrix, {number(node.translation, 0), number(node.translation, 1), number(node.translation, 2)});
    if (node.rotation.size() == 4)
        matrix *= glm::mat4_cast(
            glm::quat(number(node.rotation, 3), number(node.rotation, 0), number(node.rotation, 1), number(node.rotation, 2)));
    if (node.scale.size() == 3)
        matrix = glm::scale(matrix, {number(node.scale, 0), number(node.scale, 1), number(node.scale, 2)});
    return matrix;
}

// Gathers a scene's primitives into one RawMesh.
class Gatherer {
public:
    Gatherer(const tinygltf::Model& model, std::string where, const Progress& progress)
        : m_model(model)
        , m_where(std::move(where))
        , m_progress(progress)
    {
    }

    Expected<RawMesh> gather()
    {
        m_raw.countsUnused = true;
        m_raw.creaseDegrees = 0.f; // glTF 2.0, 3.7.2.1: without normals a mesh is flat
        Expected<void> done = m_model.nodes.empty() ? addLooseMeshes() : addScene();
        if (!done)
            return tl::unexpected(done.error());
        if (m_raw.corners.size() > 0xffffffffu)
            return failure(m_where, "the mesh has more corners than can be counted in 32 bits", "Split it");
        if (m_raw.corners.empty())
            return failure(m_where, m_lines > 0 ? "the file holds points and lines, but no triangles" : "its scene holds no triangles",
                "Export a scene with a mesh in it");
        if (m_skinned)
            m_raw.warn("skin-ignored", "The mesh has a skeleton; it is shown in the pose in which it was bound.");
        if (m_morphed)
            m_raw.warn("morph-ignored", "The mesh has morph targets; its base shape is shown.");
        if (m_lines > 0)
            m_raw.warn("lines-skipped", std::to_string(m_lines) + " primitives of points or lines were left out.");
        return std::move(m_raw);
    }

private:
    tl::unexpected<Error> damaged(std::string what) const { return failure(m_where, std::move(what), kDamaged); }

    Expected<void> addLooseMeshes()
    {
        if (!m_model.meshes.empty())
            m_raw.warn("no-scene", "The file has meshes but no scene; all of them are shown at the origin.");
        for (std::size_t i = 0; i < m_model.meshes.size(); ++i)
            if (Expected<void> added = addMesh(int(i), m_model.meshes[i].name, glm::mat4(1.f)); !added)
                return added;
        return {};
    }

    std::vector<int> roots() const
    {
        const std::size_t scene = m_model.defaultScene >= 0 ? std::size_t(m_model.defaultScene) : 0;
        if (scene < m_model.scenes.size())
            return m_model.scenes[scene].nodes;
        std::vector<char> isChild(m_model.nodes.size(), 0);
        for (const tinygltf::Node& node : m_model.nodes)
            for (const int child : node.children)
                if (child >= 0 && std::size_t(child) < isChild.size())
                    isChild[std::size_t(child)] = 1;
        std::vector<int> all;
        for (std::size_t i = 0; i < isChild.size(); ++i)
            if (!isChild[i])
                all.push_back(int(i));
        return all;
    }

    Expected<void> addScene()
    {
        struct Visit {
            int node;
            glm::mat4 worldFromParent;
        };
        std::vector<Visit> open;
        for (const int root : roots())
            open.push_back({root, glm::mat4(1.f)});
        std::reverse(open.begin(), open.end());
        std::vector<char> seen(m_model.nodes.size(), 0);
        while (!open.empty()) {
            const Visit visit = open.back();
            open.pop_back();
            if (visit.node < 0 || std::size_t(visit.node) >= m_model.nodes.size())
                return damaged("the scene names the node " + std::to_string(visit.node) + ", which does not exist");
            if (seen[std::size_t(visit.node)]++)
                return damaged("node " + std::to_string(visit.node) + " has two parents or contains itself");
            const tinygltf::Node& node = m_model.nodes[std::size_t(visit.node)];
            const glm::mat4 world = visit.worldFromParent * localMatrix(node);
            m_skinned |= node.skin >= 0;
            if (node.mesh >= 0)
                if (Expected<void> added = addMesh(node.mesh, node.name, world); !added)
                    return added;
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
                open.push_back({*child, world});
            if (m_progress.cancelled())
                return failure(m_where, "cancelled");
        }
        return {};
    }

    Expected<void> addMesh(int index, const std::string& nodeName, const glm::mat4& world)
    {
        if (index < 0 || std::size_t(index) >= m_model.meshes.size())
            return damaged("a node names the mesh " + std::to_string(index) + ", which does not exist");
        const tinygltf::Mesh& mesh = m_model.meshes[std::size_t(index)];
        const std::string name = !nodeName.empty() ? nodeName : mesh.name;
        if (m_raw.name.empty() && m_model.meshes.size() == 1)
            m_raw.name = name;
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (Expected<void> added = addPrimitive(primitive, name, world); !added)
                return added;
        return {};
    }

    // An optional attribute: absent, or unusable and told.
    Expected<std::vector<float>> attribute(const tinygltf::Primitive& primitive, const char* key, int components, std::size_t count)
    {
        const auto found = primitive.attributes.find(key);
        if (found == primitive.attributes.end())
            return std::vector<float>();
        Expected<std::vector<float>> values = readFloats(m_model, found->second, components, m_where);
        if (values && values->size() != count * std::size_t(components))
            return damaged(std::string("a primitive has another number of ") + key + " than of positions");
        return values;
    }

    Expected<std::vector<std::uint32_t>> indicesOf(const tinygltf::Primitive& primitive, std::size_t vertices)
    {
        std::vector<std::uint32_t> indices;
        if (primitive.indices >= 0) {
            Expected<std::vector<std::uint32_t>> read = readIndices(m_model, primitive.indices, m_where);
            if (!read)
                return read;
            indices = std::move(*read);
        } else {
            for (std::size_t i = 0; i < vertices; ++i)
                indices.push_back(std::uint32_t(i));
        }
        for (const std::uint32_t index : indices)
            if (index >= vertices)
                return damaged("a triangle names the vertex " + std::to_string(index) + " of " + std::to_string(vertices));
        return triples(primitive.mode, indices);
    }

    static std::vector<std::uint32_t> triples(int mode, const std::vector<std::uint32_t>& in)
    {
        if (mode == TINYGLTF_MODE_TRIANGLES)
            return {in.begin(), in.begin() + std::ptrdiff_t(in.size() - in.size() % 3)};
        std::vector<std::uint32_t> out;
        for (std::size_t i = 2; i < in.size(); ++i) {
            const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP, odd = i % 2 == 1;
            const std::uint32_t a = strip ? in[odd ? i - 1 : i - 2] : in[0], b = strip ? in[odd ? i - 2 : i - 1] : in[i - 1];
            if (!strip || (a != b && b != in[i] && in[i] != a)) // equal corners only stitch strips together
                out.insert(out.end(), {a, b, in[i]});
        }
        return out;
    }

    Expected<void> addPrimitive(const tinygltf::Primitive& primitive, const std::string& name, const glm::mat4& world)
    {
        const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
        if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
            ++m_lines;
            return {};
        }
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end())
            return damaged("a primitive has no positions");
        if (primitive.extensions.contains("KHR_draco_mesh_compression") && std::size_t(position->second) < m_model.accessors.size()
            && m_model.accessors[std::size_t(position->second)].bufferView < 0)
            return failure(
                m_where, "its triangles are compressed by KHR_draco_mesh_compression, which is not read", "Export it without compression");
        m_morphed |= !primitive.targets.empty();
        const Expected<std::vector<float>> points = readFloats(m_model, position->second, 3, m_where);
        if (!points)
            return tl::unexpected(points.error());
        const std::size_t count = points->size() / 3;
        const Expected<std::vector<float>> normals = attribute(primitive, "NORMAL", 3, count),
                                           uvs = attribute(primitive, "TEXCOORD_0", 2, count),
                                           tangents = attribute(primitive, "TANGENT", 4, count);
        for (const auto* read : {&normals, &uvs, &tangents})
            if (!*read)
                return tl::unexpected(read->error());
        const Expected<std::vector<std::uint32_t>> indices = indicesOf(primitive, count);
        if (!indices)
            return tl::unexpected(indices.error());
        append(*points, *normals, *uvs, *tangents, *indices, world);
        const bool hasMaterial = primitive.material >= 0 && std::size_t(primitive.material) < m_model.materials.size();
        const auto first = std::uint32_t(m_raw.corners.size() - indices->size());
        m_raw.parts.push_back(
            {name, hasMaterial ? m_model.materials[std::size_t(primitive.material)].name : "", first, std::uint32_t(indices->size())});
        return {};
    }

    void append(const std::vector<float>& points, const std::vector<float>& normals, const std::vector<float>& uvs,
        const std::vector<float>& tangents, const std::vector<std::uint32_t>& indices, const glm::mat4& world)
    {
        const glm::mat3 linear(world);
        const float determinant = glm::determinant(linear);
        const bool mirrored = determinant < 0.f;
        // Cofactors instead of the inverse transpose: they exist for flat scalings too.
        const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
        const float side = mirrored ? -1.f : 1.f;
        const auto base = Corner{std::uint32_t(m_raw.positions.size()), std::uint32_t(m_raw.normals.size()),
            std::uint32_t(m_raw.uvs.size()), std::uint32_t(m_raw.tangents.size())};
        for (std::size_t i = 0; i + 2 < points.size(); i += 3)
            m_raw.positions.emplace_back(world * glm::vec4(points[i], points[i + 1], points[i + 2], 1.f));
        for (std::size_t i = 0; i + 2 < normals.size(); i += 3)
            m_raw.normals.push_back(side * (cofactors * glm::vec3(normals[i], normals[i + 1], normals[i + 2])));
        for (std::size_t i = 0; i + 1 < uvs.size(); i += 2)
            m_raw.uvs.emplace_back(uvs[i], uvs[i + 1]);
        for (std::size_t i = 0; i + 3 < tangents.size(); i += 4)
            m_raw.tangents.emplace_back(linear * glm::vec3(tangents[i], tangents[i + 1], tangents[i + 2]), side * tangents[i + 3]);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const std::size_t turned
                = mirrored && i % 3 != 0 ? i + (i % 3 == 1 ? 1 : std::size_t(-1)) : i; // a mirror swaps inside and outside
            const std::uint32_t at = indices[turned];
            m_raw.corners.push_back({base.position + at, normals.empty() ? RawMesh::kNone : base.normal + at,
                uvs.empty() ? RawMesh::kNone : base.uv + at, tangents.empty() ? RawMesh::kNone : base.tangent + at});
        }
    }

    const tinygltf::Model& m_model;
    std::string m_where;
    const Progress& m_progress;
    RawMesh m_raw;
    bool m_skinned = false, m_morphed = false;
    std::size_t m_lines = 0;
};
} // namespace

Expected<RawMesh> readGltf(const std::filesystem::path& file, const Progress& progress)
{
    Expected<GltfDocument> document = loadGltf(file);
    if (!document)
        return tl::unexpected(document.error());
    progress.at(0.3f);
    Expected<RawMesh> raw = Gatherer(document->model, file.string(), progress).gather();
    if (raw)
        raw->warnings.insert(raw->warnings.end(), document->warnings.begin(), document->warnings.end());
    return raw;
}

} // namespace relievo
