// Vertices and triangles as glTF's accessors.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/gltf_mesh.h"
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

namespace {
constexpr int kFloat = 5126, kUint = 5125, kVertices = 34962, kIndices = 34963; // glTF's numbers for types and targets

template <class T> std::size_t addAttribute(GlbFile& file, const std::vector<T>& values, const char* type)
{
    return file.addAccessor(file.addView(values.data(), values.size() * sizeof(T), kVertices), values.size(), kFloat, type);
}

// Tangents run along the texture's u as it lies on the mesh: the material may be turned, its normal map turns with it.
glm::vec4 tangentOf(const Vertex& vertex, float rotation)
{
    const float angle = glm::radians(rotation);
    if (angle == 0.f)
        return vertex.tangent;
    const glm::vec3 t(vertex.tangent), b = glm::cross(vertex.normal, t) * vertex.tangent.w; // b is image up
    return glm::vec4(glm::normalize(std::cos(angle) * t + std::sin(angle) * b), vertex.tangent.w);
}
} // namespace

void addMesh(GlbFile& file, const Mesh& mesh, const std::vector<char>& isPlain, float rotation)
{
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec4> tangents;
    for (const Vertex& vertex : mesh.vertices) {
        positions.push_back(vertex.position);
        normals.push_back(vertex.normal);
        uvs.push_back(vertex.uv);
        tangents.push_back(tangentOf(vertex, rotation));
    }
    const std::size_t position = addAttribute(file, positions, "VEC3");
    glm::vec3 least = positions.front(), most = least;
    for (const glm::vec3& p : positions)
        least = glm::min(least, p), most = glm::max(most, p);
    const auto point = [](glm::vec3 p) { return GlbJson::array({p.x, p.y, p.z}); };
    file.json["accessors"][position]["min"] = point(least);
    file.json["accessors"][position]["max"] = point(most);
    const GlbJson attributes = {{"POSITION", position}, {"NORMAL", addAttribute(file, normals, "VEC3")},
        {"TANGENT", addAttribute(file, tangents, "VEC4")}, {"TEXCOORD_0", addAttribute(file, uvs, "VEC2")}};
    GlbJson primitives = GlbJson::array();
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const MeshPart& part = mesh.parts[i];
        const std::size_t view = file.addView(mesh.indices.data() + part.firstIndex, part.indexCount * sizeof(std::uint32_t), kIndices);
        primitives.push_back({{"attributes", attributes}, {"indices", file.addAccessor(view, part.indexCount, kUint, "SCALAR")},
            {"material", isPlain[i] != 0 ? 1 : 0}});
    }
    file.json["meshes"] = GlbJson::array({{{"name", mesh.name}, {"primitives", primitives}}});
    file.json["nodes"] = GlbJson::array({{{"name", mesh.name}, {"mesh", 0}}});
    file.json["scenes"] = GlbJson::array({{{"nodes", {0}}}});
    file.json["scene"] = 0;
}

} // namespace relievo
