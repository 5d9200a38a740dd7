// A triangle mesh with everything that relief mapping needs at each vertex.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/state/camera_view.h"
#include "core/state/map_slots.h"
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relievo {

// World space in metres, y up, right-handed; counter-clockwise triangles face outwards. UVs are glTF's: v runs down the image.
struct Vertex {
    glm::vec3 position; // m
    glm::vec3 normal; // unit
    glm::vec2 uv;
    glm::vec4
        tangent; // xyz unit, along +u in the tangent plane; w = +-1 so that glTF's bitangent (-v, image up) = cross(normal, tangent) * w
    // Texture Jacobian (ARCHITECTURE.md, "Space, sign and unit"): change of position per unit of u and of v, m; not orthogonal, not equal,
    // not unit.
    // Degenerate UVs: a sound frame in the tangent plane.
    glm::vec3 dPdu, dPdv;
};

struct MeshPart {
    std::string name, material;
    std::uint32_t firstIndex = 0, indexCount = 0; // into Mesh::indices
    float relief = 1.f; // share of the relief's depth on this part; 0: plain
};

// What a file written by this program says about its height map (RELIEVO_materials_relief).
struct MeshRelief {
    double depth = 0.0; // m, from black to white; NaN: not told
    double midlevel = 1.0;
    std::string technique; // key; "" when not told
    std::vector<std::pair<std::string, double>> search; // parameters by key, as the file has them
};

// What multiplies a glTF material's maps; its own where it has none.
struct MeshFactors {
    glm::vec3 color{1.f}; // linear
    float roughness = 1.f, metallic = 1.f, normal = 1.f, occlusion = 1.f; // of occlusion the strength
    float emission = 0.f; // of its brightest channel
    std::optional<float> specular = {}; // of its brightest channel, where the material has one
    std::vector<std::pair<std::string_view, float>> layers = {}; // parameters by key, of extensions that the material has
    glm::vec3 sheen{0.f}; // linear
    bool clamped = false; // its pictures do not repeat
};

// A material as the mesh file describes it; parts refer to it by name.
struct MeshMaterial {
    std::string name; // as MeshPart::material, each once
    // As State::slots takes them: files that exist, absolute. A picture inside a glTF file is "FILE#N", which readImage understands.
    MapSlots maps;
    std::optional<MeshRelief> relief = {}; // with a height map in `maps`
    std::optional<MeshFactors> factors = {}; // of glTF files
};

struct Deformation; // pose.h
struct ObjectMaps; // of a storey above: what meshes only carry along

struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; // triples
    std::vector<MeshPart> parts; // at least one
    std::vector<MeshMaterial> materials; // empty when the file describes none; a part may name one that is not here
    glm::vec3 boundsMin{0.f}, boundsMax{0.f}; // m; of a mesh from a file with a deformation: of the pose at rest, as metresPerUV is
    std::vector<glm::vec3>
        outline; // m; of the same pose: the vertex furthest from the middle in each of some thousand directions; what a camera frames
    // sqrt(area in m2 / area in UV space), area-weighted over what is not plain (ARCHITECTURE.md, "Space, sign and unit"); > 0
    float metresPerUV = 1.f;
    bool fileHasUVs = true, fileHasNormals = true, fileHasTangents = false; // what the file held, before anything was made
    std::size_t fileVertices = 0; // distinct (position, normal, UV) tuples of the file, for `info`
    std::size_t repeatedVertices = 0; // vertices that the file writes out although an equal one exists (0 for STL, which cannot share)
    std::shared_ptr<const Deformation> deformation; // skeleton, morph targets and animations; null when the file has none
    std::shared_ptr<const ObjectMaps> object; // the relief object whose box this is; null for all others
    Warnings warnings; // "uvs-made" (box projection), "normals-made", "triangles-dropped", "mesh-moved" (from far away) ...
};

// What the camera sees of the mesh; aspect = width / height.
inline CameraView cameraOnto(const Mesh& mesh, const Camera& camera, float aspect)
{
    return cameraView(camera, mesh.boundsMin, mesh.boundsMax, aspect, mesh.outline);
}

// Which of mesh.parts show no relief: those that have none, and those of other materials than the chosen one. chosen: State::part; a name
// that no part of the mesh has (of another mesh) chooses none.
std::vector<char> plainParts(const Mesh& mesh, std::string_view chosen);

// nameOrFile: a row of kShapes, or a file: .gltf .glb .obj .ply .stl .off. Errors name the file and the cure; a file without
// triangles, with broken indices or missing buffers is refused. Finite positions only; bad normals are remade and told.
Expected<Mesh> openMesh(const std::string& nameOrFile, const Progress& progress = {});

// What an artist may want to mend, for `info`; each says how many: "degenerate-triangles", "degenerate-uvs", "duplicate-vertices",
// "non-manifold-edges" (more than two triangles meet), "flipped-normals" (they disagree with the winding), "other-tangents" (corners whose
// tangents, of the file, are not MikkTSpace's).
Warnings inspectMesh(const Mesh& mesh);

// `info MESH --json` (resources/help/command-line.md, "What info tells").
std::string meshJson(const Mesh& mesh);

} // namespace relievo
