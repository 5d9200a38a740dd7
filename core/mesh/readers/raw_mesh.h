// A mesh as a file holds it, and the step from there to a Mesh: what the readers of this folder share.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/pose.h"
#include <span>

namespace relievo {

// How a file's positions move.
struct RawDeformation {
    // Its targets hold no deltas yet; its influences are one for each of RawMesh::positions.
    Deformation deformation;
    struct Piece { // of a target: what it adds to positions first, first + 1 ... at weight 1
        std::size_t target = 0; // into deformation.targets
        std::size_t first = 0;
        std::vector<glm::vec3> positions, normals; // normals: of unit normals, may be empty
    };
    std::vector<Piece> pieces; // no two pieces of a target overlap
    bool isCut = false; // targets were left out
};

// Every target has a delta, of 48 bytes, for each vertex; of all targets together 2^24 are kept.
constexpr std::size_t kMostDeltas = std::size_t(1) << 24;
std::size_t mostTargets(std::size_t vertices);
// Leaves out whole targets, the last ones, until the rest fit for so many vertices.
void cutTargets(RawDeformation& moves, std::size_t vertices);

// Triangles whose corners name a position and perhaps a normal, UV and tangent, each in its own list (as OBJ does).
struct RawMesh {
    static constexpr std::uint32_t kNone = ~std::uint32_t(0);
    struct Corner {
        std::uint32_t position = kNone, normal = kNone, uv = kNone, tangent = kNone;
    };

    std::string name;
    std::vector<glm::vec3> positions, normals; // positions: m, from their origin; normals of any length
    struct Origin { // of the positions from number `first` on, up to the next one's
        std::size_t first = 0;
        glm::dvec3 at{0.0}; // m
    };
    std::vector<Origin> origins{Origin()}; // ascending; one alone for all when the mesh is built
    std::vector<glm::vec2> uvs; // v runs down already
    std::vector<glm::vec4> tangents; // as glTF's
    std::vector<Corner> corners; // triples; every index lies within its list
    std::vector<MeshPart> parts; // firstIndex and indexCount count corners, in order and without gaps
    std::vector<MeshMaterial> materials;
    std::optional<RawDeformation> moves;
    Warnings warnings;
    // Made normals are averaged over neighbouring triangles that meet at less than this angle.
    float creaseDegrees = 50.f;
    // Whether a position that no triangle uses is a vertex of the file (in OBJ it is only a number to refer to).
    bool countsUnused = false;
    // Whether the format lets triangles share vertices, so that equal ones are a waste.
    bool sharesVertices = true;
    // What was lost on the way, told by buildMesh: faces of fewer than three corners, polygons with too many corners to look for the way
    // they bend, numbers of a text followed by something else.
    std::size_t shortFaces = 0, fannedPolygons = 0, cutNumbers = 0;

    // Chooses the origin by the first position when that is far from 0.
    void addPosition(glm::dvec3 position);
    const glm::dvec3& originOf(std::size_t position) const;

    void warn(std::string code, std::string text) { warnings.push_back({std::move(code), std::move(text)}); }
};

// Appends the triangles of a polygon: a fan where it is convex, else ears are cut. Polygons of fewer than three corners add nothing, very
// large ones always become a fan; both are counted.
void addPolygon(RawMesh& raw, std::span<const RawMesh::Corner> polygon);

// Whether floats lose detail of what lies there, m; not for places that they cannot hold at all.
bool isFar(glm::dvec3 position);

// What lies between low and high, m, is best stored relative to: 0, unless it is much farther from there than it is large.
glm::dvec3 originFor(glm::dvec3 low, glm::dvec3 high);

// One origin for all: where the mesh is much farther from 0 than it is large that of its first corner, told as "mesh-moved"; else 0. What
// moves follows. For positions that are finite.
void settleOrigin(RawMesh& raw);

// The materials of the .mtl files that `names` (what follows "mtllib", one entry a line of the OBJ) lists. Missing or unreadable ones are
// warnings "material-missing", missing pictures "map-missing"; texture options that are not followed "map-options".
std::vector<MeshMaterial> readMtl(const std::filesystem::path& obj, std::span<const std::string> names, Warnings& warnings);

// Drops what is not finite, makes missing normals and UVs, joins equal corners, computes frames; each told in `warnings`.
// where: the file, for errors.
Expected<Mesh> buildMesh(RawMesh raw, const std::string& where, const Progress& progress);

// The deformation of a finished mesh whose corner i was raw.corners[i]: influences by vertex, targets with all their deltas. What
// raw.moves holds is used up; targets that were left out are told in mesh.warnings, "morph-too-large".
std::shared_ptr<const Deformation> deformationOf(Mesh& mesh, RawMesh& raw);

// Readers by format. Errors name the file and the cure. Allocation stays in proportion to the size of the file.
Expected<RawMesh> readGltf(const std::filesystem::path& file, const Progress& progress);
Expected<RawMesh> readObj(const std::filesystem::path& file, const Progress& progress);
Expected<RawMesh> readPly(const std::filesystem::path& file, const Progress& progress);
Expected<RawMesh> readStl(const std::filesystem::path& file, const Progress& progress);
Expected<RawMesh> readOff(const std::filesystem::path& file, const Progress& progress);

} // namespace relievo
