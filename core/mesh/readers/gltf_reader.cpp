// glTF 2.0, text and binary: the triangles of a scene in world space.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/gltf_document.h"
#include "core/gltf/gltf_json.h"
#include "core/mesh/animation/gltf_deformation.h"
#include "core/mesh/compression/gltf_compression.h"
#include "core/mesh/readers/gltf_materials.h"
#include "core/mesh/readers/gltf_not_shown.h"
#include "core/mesh/readers/gltf_primitive.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <set>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;
// Of all nodes together: a small file can show its meshes very often, and accessors without data cost it nothing.
constexpr std::size_t kMostVertices = 32'000'000, kMostCorners = 200'000'000, kMostWithoutData = std::size_t(1) << 22;

// Gathers a scene's primitives into one RawMesh.
class Gatherer {
public:
    Gatherer(const tinygltf::Model& model, std::string where, const Progress& progress)
        : m_model(model)
        , m_where(std::move(where))
        , m_progress(progress)
        , m_materials(readMaterials(model, m_where))
        , m_deformation(model, m_where)
    {
    }

    Expected<RawMesh> gather()
    {
        m_raw.countsUnused = true;
        m_raw.creaseDegrees = 0.f; // glTF 2.0, 3.7.2.1: without normals a mesh is flat
        Expected<void> done = m_model.nodes.empty() ? addLooseMeshes() : addScene();
        if (!done)
            return tl::unexpected(done.error());
        if (m_raw.corners.empty())
            return failure(ErrorCode::Unreadable, m_where,
                m_lines > 0 ? "the file holds points and lines, but no triangles" : "its scene holds no triangles",
                m_vanished > 0 ? "Its nodes are scaled to nothing: give them a size" : "Export a scene with a mesh in it");
        if (m_lines > 0)
            m_raw.warn("lines-skipped", std::to_string(m_lines) + " primitives of points or lines were left out.");
        if (m_vanished > 0)
            m_raw.warn("nodes-dropped", std::to_string(m_vanished) + " nodes are scaled to nothing and were left out.");
        if (m_instanced > 0)
            m_raw.warn("instances-skipped",
                std::to_string(m_instanced) + " nodes show copies of their mesh (EXT_mesh_gpu_instancing); one of each is shown.");
        if (std::optional<Warning> losses = notShown(m_model))
            m_raw.warnings.push_back(std::move(*losses));
        m_raw.moves = m_deformation.finished(m_raw.warnings);
        m_raw.materials = std::move(m_materials.materials);
        m_raw.warnings.insert(m_raw.warnings.end(), m_materials.warnings.begin(), m_materials.warnings.end());
        return std::move(m_raw);
    }

private:
    // Where a mesh stands in the scene.
    struct Place {
        int node; // -1: in none
        glm::dmat4 world; // double: shared by what stands far from the origin
    };

    tl::unexpected<Error> damaged(std::string what) const { return failure(ErrorCode::Unreadable, m_where, std::move(what), kDamagedGltf); }

    // Whether nothing but a point or a line is left of what is scaled so.
    static bool vanishes(const glm::mat3& linear)
    {
        int empty = 0;
        for (int k = 0; k < 3; ++k)
            empty += linear[k] == glm::vec3(0.f);
        return empty >= 2;
    }

    Expected<void> addLooseMeshes()
    {
        if (!m_model.meshes.empty())
            m_raw.warn("no-scene", "The file has meshes but no scene; all of them are shown at the origin.");
        for (std::size_t i = 0; i < m_model.meshes.size(); ++i)
            if (Expected<void> added = addMesh(int(i), m_model.meshes[i].name, {-1, glm::dmat4(1.0)}); !added)
                return added;
        return {};
    }

    std::vector<int> roots() const
    {
        const std::size_t scene = m_model.defaultScene >= 0 ? std::size_t(m_model.defaultScene) : 0;
        if (scene < m_model.scenes.size())
            return m_model.scenes[scene].nodes;
        std::vector<bool> isChild(m_model.nodes.size());
        for (const tinygltf::Node& node : m_model.nodes)
            for (const int child : node.children)
                if (child >= 0 && std::size_t(child) < isChild.size())
                    isChild[std::size_t(child)] = true;
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
            glm::dmat4 worldFromParent;
        };
        std::vector<Visit> open;
        for (const int root : roots())
            open.push_back({root, glm::dmat4(1.0)});
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
            const glm::dmat4 world = visit.worldFromParent * localMatrix(poseNodeOf(node));
            m_instanced += node.mesh >= 0 && node.extensions.contains("EXT_mesh_gpu_instancing");
            if (node.mesh >= 0 && vanishes(glm::mat3(world)))
                ++m_vanished;
            else if (node.mesh >= 0)
                if (Expected<void> added = addMesh(node.mesh, node.name, {visit.node, world}); !added)
                    return added;
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
                open.push_back({*child, world});
            if (m_progress.cancelled())
                return cancelled(m_where);
        }
        return {};
    }

    Expected<void> addMesh(int index, const std::string& nodeName, const Place& place)
    {
        if (index < 0 || std::size_t(index) >= m_model.meshes.size())
            return damaged("a node names the mesh " + std::to_string(index) + ", which does not exist");
        const tinygltf::Mesh& mesh = m_model.meshes[std::size_t(index)];
        const std::string name = !nodeName.empty() ? nodeName : mesh.name;
        if (m_raw.name.empty() && m_model.meshes.size() == 1)
            m_raw.name = name;
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (Expected<void> added = addPrimitive(primitive, name, place); !added)
                return added;
        return {};
    }

    Expected<void> addPrimitive(const tinygltf::Primitive& primitive, const std::string& name, const Place& place)
    {
        if (!hasTriangles(primitive)) {
            ++m_lines;
            return {};
        }
        MeshPart part;
        part.name = name;
        part.firstIndex = std::uint32_t(m_raw.corners.size());
        TextureSpace space;
        if (primitive.material >= 0 && std::size_t(primitive.material) < m_materials.materials.size()) {
            part.material = m_materials.materials[std::size_t(primitive.material)].name;
            space = m_materials.spaces[std::size_t(primitive.material)];
        }
        const Expected<GltfPrimitive> read = readPrimitive(m_model, primitive, space.set, m_where);
        if (!read)
            return tl::unexpected(read.error());
        const std::size_t before = m_raw.positions.size();
        m_withoutData += read->hasData ? 0 : read->vertices();
        if (before + read->vertices() > kMostVertices || m_raw.corners.size() + read->indices.size() > kMostCorners
            || m_withoutData > kMostWithoutData)
            return failure(ErrorCode::Unreadable, m_where, "the scene has more vertices or triangles than can be held",
                "Split it, or show its meshes less often");
        tellUVSet(part.material, space.set, read->uvSet);
        const glm::dmat4 world = m_deformation.storedAt(primitive, place.node, place.world);
        append(*read, space, world);
        if (Expected<void> moves = m_deformation.addPrimitive(primitive, place.node, world, before, m_raw); !moves)
            return moves;
        part.indexCount = std::uint32_t(read->indices.size());
        m_raw.parts.push_back(std::move(part));
        return {};
    }

    void tellUVSet(const std::string& material, int wanted, int used)
    {
        if (used < 0 || (used == 0 && wanted == 0))
            return;
        const std::string owner = material.empty() ? "What has no material" : "The material \"" + material + '"',
                          set = std::to_string(used);
        const std::string text = used == wanted || material.empty()
            ? owner + " is mapped by UV set " + set + " of the file."
            : owner + " asks for UV set " + std::to_string(wanted) + ", which its mesh lacks; set " + set + " is used.";
        if (m_told.insert(text).second)
            m_raw.warn("uv-set", text);
    }

    void appendPositions(const GltfPrimitive& from, const glm::dmat4& world)
    {
        const auto point = [&from](std::size_t i) { return glm::dvec3(from.points[i], from.points[i + 1], from.points[i + 2]); };
        glm::dvec3 low(0.0), high(0.0);
        for (std::size_t i = 0; i < from.points.size(); i += 3) {
            low = i == 0 ? point(i) : glm::min(low, point(i));
            high = i == 0 ? point(i) : glm::max(high, point(i));
        }
        const glm::dvec3 centre(world * glm::dvec4(0.5 * (low + high), 1.0)), half = 0.5 * (high - low);
        const glm::dvec3 reach
            = glm::abs(glm::dvec3(world[0])) * half.x + glm::abs(glm::dvec3(world[1])) * half.y + glm::abs(glm::dvec3(world[2])) * half.z;
        const glm::dvec3 origin = originFor(centre - reach, centre + reach);
        m_raw.origins.push_back({m_raw.positions.size(), origin});
        for (std::size_t i = 0; i < from.points.size(); i += 3)
            m_raw.positions.emplace_back(glm::dvec3(world * glm::dvec4(point(i), 1.0)) - origin);
    }

    void append(const GltfPrimitive& from, const TextureSpace& space, const glm::dmat4& world)
    {
        const Directions directions = directionsOf(world);
        const bool mirrored = directions.mirrored;
        const bool hasTangents = !from.tangents.empty() && space.keepsTangents();
        const auto base = Corner{std::uint32_t(m_raw.positions.size()), std::uint32_t(m_raw.normals.size()),
            std::uint32_t(m_raw.uvs.size()), std::uint32_t(m_raw.tangents.size())};
        m_raw.positions.reserve(m_raw.positions.size() + from.vertices());
        m_raw.normals.reserve(m_raw.normals.size() + from.normals.size() / 3);
        m_raw.uvs.reserve(m_raw.uvs.size() + from.uvs.size() / 2);
        m_raw.corners.reserve(m_raw.corners.size() + from.indices.size());
        appendPositions(from, world);
        for (std::size_t i = 0; i < from.normals.size(); i += 3)
            m_raw.normals.push_back(directions.normals * glm::vec3(from.normals[i], from.normals[i + 1], from.normals[i + 2]));
        for (std::size_t i = 0; i < from.uvs.size(); i += 2)
            m_raw.uvs.push_back(space.uvFromSet * glm::vec3(from.uvs[i], from.uvs[i + 1], 1.f));
        for (std::size_t i = 0; hasTangents && i < from.tangents.size(); i += 4)
            m_raw.tangents.emplace_back(directions.tangents * glm::vec3(from.tangents[i], from.tangents[i + 1], from.tangents[i + 2]),
                mirrored ? -from.tangents[i + 3] : from.tangents[i + 3]);
        for (std::size_t i = 0; i < from.indices.size(); ++i) {
            const std::size_t turned
                = mirrored && i % 3 != 0 ? i + (i % 3 == 1 ? 1 : std::size_t(-1)) : i; // a mirror swaps inside and outside
            const std::uint32_t at = from.indices[turned];
            m_raw.corners.push_back({base.position + at, from.normals.empty() ? RawMesh::kNone : base.normal + at,
                from.uvs.empty() ? RawMesh::kNone : base.uv + at, hasTangents ? base.tangent + at : RawMesh::kNone});
        }
    }

    const tinygltf::Model& m_model;
    std::string m_where;
    const Progress& m_progress;
    GltfMaterials m_materials;
    RawMesh m_raw;
    GltfDeformation m_deformation;
    std::set<std::string> m_told; // what tellUVSet said
    std::size_t m_lines = 0, m_vanished = 0, m_instanced = 0, m_withoutData = 0;
};
} // namespace

Expected<RawMesh> readGltf(const std::filesystem::path& file, const Progress& progress)
{
    Expected<GltfDocument> document = loadGltf(file);
    if (!document)
        return tl::unexpected(document.error());
    if (const Expected<void> done = decompress(document->model, file.string(), progress); !done)
        return tl::unexpected(done.error());
    progress.at(0.3f);
    Expected<RawMesh> raw = Gatherer(document->model, file.string(), progress).gather();
    if (raw)
        raw->warnings.insert(raw->warnings.end(), document->warnings.begin(), document->warnings.end());
    return raw;
}

} // namespace relievo
