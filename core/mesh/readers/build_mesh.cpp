// From a file's triangles to a mesh with normals, UVs and frames at every vertex.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/frames.h"
#include "core/mesh/numbering.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;
constexpr std::uint32_t kNone = RawMesh::kNone;
// Beyond this, squares of lengths leave the range of float.
constexpr float kLargest = 1e15f;

bool usable(glm::vec3 v)
{
    return std::abs(v.x) < kLargest && std::abs(v.y) < kLargest && std::abs(v.z) < kLargest; // false for NaN
}

std::string counted(std::size_t count, const char* one, const char* many)
{
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// Keeps the triangles that `keep` accepts, and the parts in step with them.
template <class Keep> std::size_t filterTriangles(RawMesh& raw, Keep keep)
{
    std::vector<Corner> kept;
    kept.reserve(raw.corners.size());
    for (MeshPart& part : raw.parts) {
        const auto first = std::uint32_t(kept.size());
        for (std::size_t i = part.firstIndex; i + 2 < std::size_t(part.firstIndex) + part.indexCount; i += 3)
            if (keep(&raw.corners[i]))
                kept.insert(kept.end(), &raw.corners[i], &raw.corners[i] + 3);
        part.firstIndex = first;
        part.indexCount = std::uint32_t(kept.size()) - first;
    }
    const std::size_t dropped = (raw.corners.size() - kept.size()) / 3;
    raw.corners = std::move(kept);
    std::erase_if(raw.parts, [](const MeshPart& part) { return part.indexCount == 0; });
    return dropped;
}

void dropBroken(RawMesh& raw)
{
    const std::size_t dropped = filterTriangles(raw, [&raw](const Corner* corner) {
        return usable(raw.positions[corner[0].position]) && usable(raw.positions[corner[1].position])
            && usable(raw.positions[corner[2].position]);
    });
    if (dropped > 0)
        raw.warn("triangles-dropped",
            counted(dropped, "triangle has", "triangles have") + " positions that are not finite numbers and were left out.");
}

// Normals of length 0 or not finite are forgotten, the others made unit; UVs that are not finite are forgotten.
void repairAttributes(RawMesh& raw)
{
    std::vector<char> badNormal(raw.normals.size(), 0), badUV(raw.uvs.size(), 0);
    for (std::size_t i = 0; i < raw.normals.size(); ++i) {
        const float length = usable(raw.normals[i]) ? glm::length(raw.normals[i]) : 0.f;
        if (length > 1e-12f)
            raw.normals[i] /= length;
        else
            badNormal[i] = 1;
    }
    for (std::size_t i = 0; i < raw.uvs.size(); ++i)
        badUV[i] = !usable(glm::vec3(raw.uvs[i], 0.f));
    std::size_t normals = 0, uvs = 0;
    for (Corner& corner : raw.corners) {
        if (corner.normal != kNone && badNormal[corner.normal]) {
            corner.normal = kNone;
            ++normals;
        }
        if (corner.uv != kNone && badUV[corner.uv]) {
            corner.uv = kNone;
            ++uvs;
        }
    }
    if (normals > 0)
        raw.warn("normals-repaired", counted(normals, "corner has a normal", "corners have normals") + " of no direction.");
    if (uvs > 0)
        raw.warn("uvs-repaired", counted(uvs, "corner has a UV that is", "corners have UVs that are") + " not finite; they were left out.");
}

void tellLosses(RawMesh& raw)
{
    if (raw.shortFaces > 0)
        raw.warn("triangles-dropped", counted(raw.shortFaces, "face of", "faces of") + " fewer than three corners cannot be shown.");
    if (raw.fannedPolygons > 0)
        raw.warn("polygons-fanned",
            counted(raw.fannedPolygons, "polygon has", "polygons have")
                + " more than 1000 corners and bends inwards; it may cover too much. Split it into triangles.");
    if (raw.cutNumbers > 0)
        raw.warn("numbers-cut",
            counted(raw.cutNumbers, "number is", "numbers are")
                + " followed by what is no number, which was ignored; decimals are written with a point (0.5).");
}

struct Tuples {
    std::size_t distinct = 0; // of position, normal and UV by value
    std::size_t repeated = 0; // written more often than needed
};

Tuples countTuples(const RawMesh& raw)
{
    const auto count
        = [](std::uint32_t index, const std::vector<std::uint32_t>& numbers) { return index == kNone ? kNone : numbers[index]; };
    const std::vector<std::uint32_t> positions = numbersOf(raw.positions), normals = numbersOf(raw.normals), uvs = numbersOf(raw.uvs);
    Numbering<3> written(raw.positions.size()), distinct(raw.positions.size());
    std::vector<bool> used(raw.positions.size());
    for (const Corner& corner : raw.corners) {
        used[corner.position] = true;
        if (written({corner.position, corner.normal, corner.uv}).isNew)
            distinct({count(corner.position, positions), count(corner.normal, normals), count(corner.uv, uvs)});
    }
    Tuples tuples{distinct.size(), raw.sharesVertices ? written.size() - distinct.size() : 0};
    for (std::size_t i = 0; raw.countsUnused && i < used.size(); ++i)
        if (!used[i])
            tuples.distinct += distinct({positions[i], kNone - 1, 0}).isNew;
    return tuples;
}

struct Face {
    glm::vec3 normal{0.f}; // unit, or 0 for a triangle without area
    std::array<float, 3> angles{}; // at its corners, radians
};

Face faceOf(const RawMesh& raw, const Corner* corner)
{
    Face face;
    const std::array<glm::dvec3, 3> p = {glm::dvec3(raw.positions[corner[0].position]), glm::dvec3(raw.positions[corner[1].position]),
        glm::dvec3(raw.positions[corner[2].position])};
    const glm::dvec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(across);
    if (!(length > 0.0))
        return face;
    face.normal = glm::vec3(across / length);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
        face.angles[k] = float(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    }
    return face;
}

// Corners by place: those of place g are order[starts[g]] .. order[starts[g + 1] - 1].
struct Places {
    std::vector<std::uint32_t> order, starts;
};

Places placesOf(const RawMesh& raw)
{
    const std::vector<std::uint32_t> numbers = numbersOf(raw.positions);
    std::vector<std::uint32_t> place(raw.corners.size());
    for (std::size_t i = 0; i < raw.corners.size(); ++i)
        place[i] = numbers[raw.corners[i].position];
    Places places;
    places.starts.assign(numbers.size() + 1, 0); // at most so many
    for (const std::uint32_t g : place)
        ++places.starts[g + 1];
    for (std::size_t g = 1; g < places.starts.size(); ++g)
        places.starts[g] += places.starts[g - 1];
    places.order.resize(place.size());
    std::vector<std::uint32_t> next(places.starts.begin(), places.starts.end() - 1);
    for (std::size_t i = 0; i < place.size(); ++i)
        places.order[next[place[i]]++] = std::uint32_t(i);
    return places;
}

// Angle-weighted mean of the faces around a place that bend less than the crease from face `own`.
glm::vec3 smoothNormal(std::span<const std::uint32_t> around, const std::vector<Face>& faces, const Face& own, float minCosine)
{
    glm::vec3 sum(0.f);
    for (const std::uint32_t corner : around) {
        const Face& face = faces[corner / 3];
        if (glm::dot(face.normal, own.normal) >= minCosine)
            sum += face.normal * face.angles[corner % 3];
    }
    const float length = glm::length(sum);
    if (length > 1e-6f)
        return sum / length;
    return glm::dot(own.normal, own.normal) > 0.f ? own.normal : glm::vec3(0.f, 1.f, 0.f);
}

void makeNormals(RawMesh& raw)
{
    const auto missing = std::size_t(std::ranges::count_if(raw.corners, [](const Corner& corner) { return corner.normal == kNone; }));
    if (missing == 0)
        return;
    if (missing == raw.corners.size())
        raw.warn("normals-made", "The mesh holds no normals; they were made from its triangles.");
    else
        raw.warn("normals-made", counted(missing, "corner holds", "corners hold") + " no normal; they were made from the triangles.");
    std::vector<Face> faces(raw.corners.size() / 3);
    for (std::size_t i = 0; i < faces.size(); ++i)
        faces[i] = faceOf(raw, &raw.corners[i * 3]);
    const float minCosine = std::min(std::cos(glm::radians(raw.creaseDegrees)), 0.9999f);
    // A hub of very many triangles (a fan, a collapsed part) takes one mean: pairs would cost its square.
    constexpr std::size_t kHub = 512;
    const Places places = placesOf(raw);
    for (std::size_t g = 0; g + 1 < places.starts.size(); ++g) {
        const std::span around(places.order.begin() + places.starts[g], places.order.begin() + places.starts[g + 1]);
        for (const std::uint32_t at : around) {
            if (raw.corners[at].normal != kNone)
                continue;
            const Face& own = faces[at / 3];
            // A triangle without area has no side of its own: it follows all.
            const bool all = glm::dot(own.normal, own.normal) == 0.f;
            const glm::vec3 normal = around.size() > kHub ? (all ? glm::vec3(0.f, 1.f, 0.f) : own.normal)
                                                          : smoothNormal(around, faces, own, all ? -2.f : minCosine);
            raw.corners[at].normal = std::uint32_t(raw.normals.size());
            raw.normals.push_back(normal);
        }
    }
}

// Projects onto the box side that the triangle faces: u to the right and v down as seen from outside.
glm::vec2 boxUV(glm::vec3 p, glm::vec3 faceNormal)
{
    const glm::vec3 a = glm::abs(faceNormal);
    if (a.y >= a.x && a.y >= a.z)
        return {p.x, faceNormal.y < 0.f ? -p.z : p.z};
    if (a.x >= a.z)
        return {faceNormal.x < 0.f ? p.z : -p.z, -p.y};
    return {faceNormal.z < 0.f ? -p.x : p.x, -p.y};
}

void makeUVs(RawMesh& raw)
{
    glm::vec3 low(kLargest), high(-kLargest);
    for (const Corner& corner : raw.corners) {
        low = glm::min(low, raw.positions[corner.position]);
        high = glm::max(high, raw.positions[corner.position]);
    }
    const glm::vec3 size = high - low, middle = 0.5f * (low + high);
    const float side = std::max({size.x, size.y, size.z, 1e-12f});
    std::size_t made = 0;
    for (std::size_t i = 0; i < raw.corners.size(); i += 3) {
        Corner* corner = &raw.corners[i];
        if (corner[0].uv != kNone && corner[1].uv != kNone && corner[2].uv != kNone)
            continue;
        const glm::vec3 normal = faceOf(raw, corner).normal;
        for (int k = 0; k < 3; ++k) {
            corner[k].uv = std::uint32_t(raw.uvs.size());
            corner[k].tangent = kNone;
            raw.uvs.push_back(boxUV(raw.positions[corner[k].position] - middle, normal) / side + 0.5f);
        }
        ++made;
    }
    if (made > 0)
        raw.warn("uvs-made",
            made * 3 == raw.corners.size()
                ? "The mesh holds no UVs; the texture is projected from six sides, one tile to its largest side."
                : counted(made, "triangle holds", "triangles hold") + " no UVs; the texture is projected on them from six sides.");
}

// The file's tangent if it is sound, else w = 0.
glm::vec4 tangentOf(const RawMesh& raw, const Corner& corner)
{
    if (corner.tangent == kNone)
        return glm::vec4(0.f);
    const glm::vec4 tangent = raw.tangents[corner.tangent];
    const glm::vec3 n = raw.normals[corner.normal];
    const glm::vec3 flat = glm::vec3(tangent) - n * glm::dot(n, glm::vec3(tangent));
    const float length = usable(flat) ? glm::length(flat) : 0.f;
    if (length < 1e-6f || !std::isfinite(tangent.w))
        return glm::vec4(0.f);
    return glm::vec4(flat / length, tangent.w < 0.f ? -1.f : 1.f);
}

// Numbers of positions; those that are equal but move differently have different ones.
std::vector<std::uint32_t> positionNumbers(const RawMesh& raw)
{
    std::vector<std::uint32_t> numbers = numbersOf(raw.positions);
    if (!raw.moves)
        return numbers;
    Numbering<7> byInfluence(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Influence& influence = raw.moves->deformation.influences[i];
        const Bits<4> w = bitsOf(glm::vec4(influence.weights[0], influence.weights[1], influence.weights[2], influence.weights[3]));
        numbers[i] = byInfluence({numbers[i], std::uint32_t(influence.joints[0]) << 16 | influence.joints[1],
                                     std::uint32_t(influence.joints[2]) << 16 | influence.joints[3], w[0], w[1], w[2], w[3]})
                         .number;
    }
    std::size_t next = numbers.size(); // no number so far
    for (const RawDeformation::Piece& piece : raw.moves->pieces) {
        Numbering<7> byDelta(piece.positions.size());
        for (std::size_t i = 0; i < piece.positions.size(); ++i) {
            const Bits<3> p = bitsOf(piece.positions[i]), n = bitsOf(piece.normals.empty() ? glm::vec3(0.f) : piece.normals[i]);
            std::uint32_t& number = numbers[piece.first + i];
            if (p != Bits<3>{} || n != Bits<3>{}) // what stays is as what lies outside of the piece
                number = std::uint32_t(next + byDelta({number, p[0], p[1], p[2], n[0], n[1], n[2]}).number);
        }
        next += byDelta.size();
    }
    return numbers;
}

// Joins corners that agree in everything. Mirrored and unmirrored texture never share a vertex: their frames would cancel.
std::vector<glm::vec4> joinCorners(const RawMesh& raw, Mesh& mesh)
{
    const std::vector<std::uint32_t> positions = positionNumbers(raw), normals = numbersOf(raw.normals), uvs = numbersOf(raw.uvs);
    Numbering<8> numbering(raw.positions.size());
    std::vector<glm::vec4> tangents;
    mesh.indices.reserve(raw.corners.size());
    for (std::size_t i = 0; i < raw.corners.size(); ++i) {
        const Corner* triangle = &raw.corners[i - i % 3];
        const std::uint32_t mirrored = signedUVArea(raw.uvs[triangle[0].uv], raw.uvs[triangle[1].uv], raw.uvs[triangle[2].uv]) > 0.f;
        const Corner& corner = raw.corners[i];
        const glm::vec4 tangent = tangentOf(raw, corner);
        const Bits<4> t = bitsOf(tangent);
        const auto [number, isNew]
            = numbering({positions[corner.position], normals[corner.normal], uvs[corner.uv], mirrored, t[0], t[1], t[2], t[3]});
        if (isNew) {
            mesh.vertices.push_back({.position = raw.positions[corner.position],
                .normal = raw.normals[corner.normal],
                .uv = raw.uvs[corner.uv],
                .tangent = {},
                .dPdu = {},
                .dPdv = {}});
            tangents.push_back(tangent);
        }
        mesh.indices.push_back(number);
    }
    return tangents;
}

// A skin places its mesh, wherever the file's node for it stands: sizes are those of the pose at rest. Where nothing ever moves that pose
// is the mesh.
void measureAtRest(Mesh& mesh)
{
    if (!mesh.deformation)
        return;
    Pose pose = poseAt(mesh, -1, 0.f);
    if (!mesh.deformation->clips.empty())
        pose.weights = bindPose(mesh).weights; // of targets: clips say them
    Mesh rest = posed(mesh, pose);
    refreshFrames(rest, true);
    mesh.boundsMin = rest.boundsMin;
    mesh.boundsMax = rest.boundsMax;
    mesh.outline = std::move(rest.outline);
    mesh.metresPerUV = rest.metresPerUV;
    if (mesh.deformation->clips.empty() && mesh.deformation->targets.empty()) {
        mesh.vertices = std::move(rest.vertices);
        mesh.deformation = nullptr;
    }
}
} // namespace

Expected<Mesh> buildMesh(RawMesh raw, const std::string& where, const Progress& progress)
{
    dropBroken(raw);
    if (raw.corners.empty())
        return failure(ErrorCode::Unreadable, where,
            raw.warnings.empty() ? "the file holds no triangles" : "no triangle of the file has finite positions",
            "Export a surface of triangles or polygons");
    tellLosses(raw);
    settleOrigin(raw);
    const auto hasArea = [&raw](std::size_t i) { return faceOf(raw, &raw.corners[i]).normal != glm::vec3(0.f); };
    bool anyArea = false;
    for (std::size_t i = 0; i < raw.corners.size() && !anyArea; i += 3)
        anyArea = hasArea(i);
    if (!anyArea)
        return failure(ErrorCode::Unreadable, where, "none of its triangles has an area", "Export a surface that can be seen");
    Mesh mesh;
    const auto allHave = [&raw](std::uint32_t Corner::*member) {
        return std::ranges::all_of(raw.corners, [member](const Corner& corner) { return corner.*member != kNone; });
    };
    mesh.fileHasNormals = allHave(&Corner::normal);
    mesh.fileHasUVs = allHave(&Corner::uv);
    mesh.fileHasTangents = allHave(&Corner::tangent);
    repairAttributes(raw);
    const Tuples tuples = countTuples(raw);
    mesh.fileVertices = tuples.distinct;
    mesh.repeatedVertices = tuples.repeated;
    progress.at(0.6f);
    if (progress.cancelled())
        return cancelled(where);
    makeNormals(raw);
    makeUVs(raw);
    progress.at(0.8f);
    if (progress.cancelled())
        return cancelled(where);
    const std::vector<glm::vec4> tangents = joinCorners(raw, mesh);
    mesh.name = std::move(raw.name);
    mesh.parts = std::move(raw.parts);
    mesh.materials = std::move(raw.materials);
    mesh.warnings = std::move(raw.warnings);
    completeFrames(mesh, tangents);
    mesh.deformation = deformationOf(mesh, raw);
    measureAtRest(mesh);
    progress.at(1.f);
    return mesh;
}

} // namespace relievo
