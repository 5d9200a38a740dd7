// Micro-triangles of a displaced mesh in Embree.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/displaced_mesh.h"
#include "core/mesh/edges/across.h"
#include "core/mesh/edges/closed.h"
#include "core/mesh/frames/push.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/state.h"
#include "core/trace/relief_room.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <tbb/parallel_for.h>

namespace relievo {

struct DisplacedMesh::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::size_t sheets = 0, triangles = 0; // micro-triangles of the displaced surface come first, then those of walls
    std::vector<char> turned; // by sheet: whether it faces the other way than the mesh's triangle
    std::atomic<std::ptrdiff_t> bytes = 0;
    float coarseness = 1.f;
    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        if (scene)
            rtcReleaseScene(scene);
        if (device)
            rtcReleaseDevice(device);
    }
};

namespace {

// The base mesh and what displaces it.
struct Base {
    const Mesh& mesh;
    const HeightField& field;
    std::vector<glm::vec3> push;
    SceneUniforms uniforms;

    glm::vec3 position(std::uint32_t vertex) const
    {
        return mesh.vertices[vertex].position + (push.empty() ? glm::vec3(0.f) : push[vertex] * uniforms.pushOut);
    }
    glm::vec2 uv(std::uint32_t vertex) const { return uniforms.textureFromMesh * mesh.vertices[vertex].uv + uniforms.textureShift; }

    // How far in a point of a triangle is moved, share of the depth; relief: of the depth on this triangle's part.
    float below(const std::uint32_t* corners, glm::vec3 weights, float relief) const
    {
        glm::dvec2 at(0.);
        for (int k = 0; k < 3; ++k)
            at += glm::dvec2(uv(corners[k])) * double(weights[k]);
        return (1.f - field.at(glm::vec2(at))) * relief;
    }

    glm::vec3 displaced(const std::uint32_t* corners, glm::vec3 weights, float relief) const
    {
        glm::vec3 place(0.f), normal(0.f);
        for (int k = 0; k < 3; ++k) {
            place += (relief > 0.f ? position(corners[k]) : mesh.vertices[corners[k]].position) * weights[k];
            normal += mesh.vertices[corners[k]].normal * weights[k];
        }
        return place - normal * (below(corners, weights, relief) * uniforms.reliefDepth);
    }
};

// Pieces along each side of a triangle.
double piecesWanted(const Base& base, const std::uint32_t* corners, float finest)
{
    const glm::vec2 size(float(base.field.width()), float(base.field.height()));
    double wanted = 1.;
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
        const double texels = 2. * double(glm::length((base.uv(b) - base.uv(a)) * size));
        const double finestPieces = finest > 0.f ? double(glm::length(base.position(b) - base.position(a)) / finest) : 1e9;
        wanted = std::max(wanted, std::min(texels, finestPieces));
    }
    return std::isfinite(wanted) ? wanted : 1.;
}

// Of a point in a triangle's grid: row i from the first corner, j-th in it.
std::uint32_t gridIndex(std::uint32_t i, std::uint32_t j)
{
    return i * (i + 1) / 2 + j;
}

// The grid of one triangle: (pieces + 1) (pieces + 2) / 2 points and pieces^2 micro-triangles; turned: of each of these.
void cut(const Base& base, const std::uint32_t* corners, float relief, std::uint32_t pieces, float* vertices, std::uint32_t firstVertex,
    std::uint32_t* triangles, char* turned)
{
    const auto weightsOf = [pieces](std::uint32_t i, std::uint32_t j) {
        return glm::vec3(float(pieces - i) / float(pieces), float(i - j) / float(pieces), float(j) / float(pieces));
    };
    for (std::uint32_t i = 0; i <= pieces; ++i)
        for (std::uint32_t j = 0; j <= i; ++j) {
            const glm::vec3 point = base.displaced(corners, weightsOf(i, j), relief);
            float* out = vertices + std::size_t(gridIndex(i, j)) * 3;
            out[0] = point.x, out[1] = point.y, out[2] = point.z;
        }
    const auto& v = base.mesh.vertices;
    const float turns = turningDepth(v[corners[0]], v[corners[1]], v[corners[2]]) / base.uniforms.reliefDepth; // share of the depth
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, glm::vec3 first) {
        *triangles++ = firstVertex + a, *triangles++ = firstVertex + b, *triangles++ = firstVertex + c;
        *turned++ = turns < relief && base.below(corners, first, relief) > turns;
    };
    for (std::uint32_t i = 0; i < pieces; ++i)
        for (std::uint32_t j = 0; j <= i; ++j) {
            add(gridIndex(i, j), gridIndex(i + 1, j), gridIndex(i + 1, j + 1), weightsOf(i, j));
            if (j < i)
                add(gridIndex(i, j), gridIndex(i + 1, j + 1), gridIndex(i, j + 1), weightsOf(i, j));
        }
}

// How the triangles are cut, and where their grids lie in the buffers.
struct Plan {
    std::vector<std::uint32_t> pieces;
    std::vector<std::size_t> firstVertex, firstTriangle; // one more than triangles: the last is the total
    float coarseness = 1.f;

    // The k-th of the points on a triangle's side, from corner `edge` of Mesh::indices to the next.
    std::uint32_t onSide(std::uint32_t edge, std::uint32_t k) const
    {
        const std::uint32_t n = pieces[edge / 3];
        const std::uint32_t inGrid = edge % 3 == 0 ? gridIndex(k, 0) : edge % 3 == 1 ? gridIndex(n, k) : gridIndex(n - k, n - k);
        return std::uint32_t(firstVertex[edge / 3]) + inGrid;
    }
};

// The walls that close what opens between two triangles where the surface goes on: at UV seams their heights differ, at edges that are not
// smooth their ways in do, and where they are cut into different numbers of pieces their sides do. Three indices a micro-triangle.
std::vector<std::uint32_t> wallsOf(const Mesh& mesh, const Plan& plan)
{
    const std::vector<std::uint32_t> across = edgesAcross(mesh);
    const auto parts = [&](std::uint32_t own, std::uint32_t other) {
        const Vertex &a = mesh.vertices[mesh.indices[own]], &b = mesh.vertices[mesh.indices[other]];
        return a.uv != b.uv || a.normal != b.normal;
    };
    std::vector<std::uint32_t> walls;
    for (std::uint32_t e = 0; e < mesh.indices.size(); ++e) {
        const std::uint32_t o = across[e];
        if (o == kNoEdge || o < e)
            continue;
        const std::uint32_t n = plan.pieces[e / 3], m = plan.pieces[o / 3];
        if (n == m && !parts(e, nextCorner(o)) && !parts(nextCorner(e), o))
            continue;
        for (std::uint32_t i = 0, j = 0; i < n || j < m;) {
            const std::uint32_t own = plan.onSide(e, i), other = plan.onSide(o, m - j);
            const bool ownGoesOn = j == m || (i < n && std::uint64_t(i + 1) * m <= std::uint64_t(j + 1) * n);
            walls.insert(walls.end(), {own, other, ownGoesOn ? plan.onSide(e, ++i) : plan.onSide(o, m - ++j)});
        }
    }
    return walls;
}

Plan plan(const Base& base, const DisplacedMesh::Detail& detail)
{
    const std::size_t count = base.mesh.indices.size() / 3;
    std::vector<double> wanted(count);
    tbb::parallel_for(
        std::size_t(0), count, [&](std::size_t i) { wanted[i] = piecesWanted(base, &base.mesh.indices[3 * i], detail.finest); });
    double total = 0.;
    for (const double w : wanted)
        total += w * w;
    const double scale = std::min(1. / double(detail.coarser), std::sqrt(double(detail.maxTriangles) / std::max(total, 1.)));
    Plan result;
    result.coarseness = float(std::max(1., 1. / scale));
    std::size_t vertices = 0, triangles = 0;
    for (const double w : wanted) {
        const auto pieces = std::uint32_t(std::clamp(scale < 1. ? std::floor(w * scale) : std::ceil(w * scale), 1., 4096.));
        result.firstVertex.push_back(vertices), result.firstTriangle.push_back(triangles);
        result.pieces.push_back(pieces);
        vertices += std::size_t(pieces + 1) * (pieces + 2) / 2, triangles += std::size_t(pieces) * pieces;
    }
    result.firstVertex.push_back(vertices), result.firstTriangle.push_back(triangles);
    return result;
}

std::vector<float> reliefOfTriangles(const Mesh& mesh)
{
    std::vector<float> reliefs(mesh.indices.size() / 3, 1.f);
    for (const MeshPart& part : mesh.parts)
        std::fill_n(reliefs.begin() + std::ptrdiff_t(part.firstIndex / 3), part.indexCount / 3, part.relief);
    return reliefs;
}

// Lets rays pass through the backs of a closed mesh's sheets: where they part at a hard edge, the inside is not seen, as in a picture.
// Walls and what is turned over stop rays from either side.
void onlyFronts(const RTCFilterFunctionNArguments* hit)
{
    const auto& turned = *static_cast<const std::vector<char>*>(hit->geometryUserPtr);
    const std::size_t index = RTCHitN_primID(hit->hit, hit->N, 0);
    if (index >= turned.size() || turned[index] != 0)
        return;
    const float facing = RTCHitN_Ng_x(hit->hit, hit->N, 0) * RTCRayN_dir_x(hit->ray, hit->N, 0)
        + RTCHitN_Ng_y(hit->hit, hit->N, 0) * RTCRayN_dir_y(hit->ray, hit->N, 0)
        + RTCHitN_Ng_z(hit->hit, hit->N, 0) * RTCRayN_dir_z(hit->ray, hit->N, 0);
    if (facing > 0.f)
        hit->valid[0] = 0;
}

bool countMemory(void* user, ssize_t bytes, bool)
{
    *static_cast<std::atomic<std::ptrdiff_t>*>(user) += bytes;
    return true;
}

Error noEmbree(RTCDevice device)
{
    const bool memory = rtcGetDeviceError(device) == RTC_ERROR_OUT_OF_MEMORY;
    return {memory ? "there is not enough memory for the displaced mesh" : "Embree cannot be used", "reference",
        memory ? "Take a smaller picture or a mesh with fewer tiles" : "Check its installation",
        memory ? ErrorCode::NoMemory : ErrorCode::Refused};
}
} // namespace

Expected<DisplacedMesh> DisplacedMesh::build(
    const Mesh& mesh, const HeightField& field, const Parameters& parameters, const Detail& detail, const Progress& progress)
{
    Base base{mesh, field, {}, sceneUniforms(parameters, {}, mesh.metresPerUV)};
    base.uniforms.pushOut = (1.f - parameters.midlevel) * base.uniforms.reliefDepth;
    if (base.uniforms.pushOut != 0.f)
        base.push = pushDirections(mesh);
    const Plan cuts = plan(base, detail);
    const std::vector<float> reliefs = reliefOfTriangles(mesh);

    const std::vector<std::uint32_t> walls = wallsOf(mesh, cuts);

    const auto impl = std::make_shared<Impl>();
    impl->sheets = cuts.firstTriangle.back();
    impl->triangles = impl->sheets + walls.size() / 3;
    impl->turned.resize(impl->sheets);
    impl->coarseness = cuts.coarseness;
    impl->device = rtcNewDevice(nullptr);
    if (!impl->device)
        return tl::unexpected(noEmbree(nullptr));
    rtcSetDeviceMemoryMonitorFunction(impl->device, countMemory, &impl->bytes);
    impl->scene = rtcNewScene(impl->device);
    rtcSetSceneFlags(impl->scene, RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT));
    RTCGeometry geometry = rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryUserData(geometry, &impl->turned);
    if (isClosed(mesh))
        rtcSetGeometryIntersectFilterFunction(geometry, onlyFronts);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), cuts.firstVertex.back()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), impl->triangles));
    if (vertices && indices) {
        std::atomic<std::size_t> done = 0;
        tbb::parallel_for(std::size_t(0), cuts.pieces.size(), [&](std::size_t i) {
            if (progress.cancelled())
                return;
            cut(base, &mesh.indices[3 * i], reliefs[i], cuts.pieces[i], vertices + 3 * cuts.firstVertex[i],
                std::uint32_t(cuts.firstVertex[i]), indices + 3 * cuts.firstTriangle[i], impl->turned.data() + cuts.firstTriangle[i]);
            if (++done % 256 == 0)
                progress.at(0.5f * float(done) / float(cuts.pieces.size()));
        });
        std::ranges::copy(walls, indices + 3 * impl->sheets);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(impl->scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    if (progress.cancelled())
        return cancelled("reference");
    if (!vertices || !indices)
        return tl::unexpected(noEmbree(impl->device));
    rtcCommitScene(impl->scene);
    if (rtcGetDeviceError(impl->device) != RTC_ERROR_NONE)
        return tl::unexpected(noEmbree(impl->device));
    DisplacedMesh result;
    result.m = impl;
    return result;
}

DisplacedMesh::Detail DisplacedMesh::detailFor(const Mesh& mesh, const CameraView& camera, float fovDegrees, int height)
{
    const glm::vec3 centre = 0.5f * (mesh.boundsMin + mesh.boundsMax);
    const float radius = 0.5f * glm::length(mesh.boundsMax - mesh.boundsMin), toCentre = glm::length(camera.eye - centre);
    const float nearest = std::max(toCentre - radius, 0.05f * toCentre);
    return {.finest = 0.5f * nearest * 2.f * std::tan(0.5f * glm::radians(fovDegrees)) / float(std::max(height, 1))};
}

DisplacedMesh::Hit DisplacedMesh::hit(glm::vec3 origin, glm::vec3 direction) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray = {
        origin.x, origin.y, origin.z, 0.f, direction.x, direction.y, direction.z, 0.f, std::numeric_limits<float>::infinity(), ~0u, 0, 0};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return {};
    const bool isSheet = ray.hit.primID < m->sheets;
    const bool back = isSheet && glm::dot(glm::vec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z), direction) > 0.f;
    return {ray.ray.tfar, back, isSheet && m->turned[ray.hit.primID] != 0};
}

std::size_t DisplacedMesh::triangles() const
{
    return m->triangles;
}
std::size_t DisplacedMesh::bytes() const
{
    return std::size_t(std::max<std::ptrdiff_t>(m->bytes, 0));
}
float DisplacedMesh::coarseness() const
{
    return m->coarseness;
}

Expected<PixelDistances> pixelDistances(
    const DisplacedMesh& surface, const CameraView& camera, int width, int height, const Progress& progress)
{
    PixelDistances seen{width, height, surface.triangles(), std::vector<float>(std::size_t(width) * std::size_t(height)), {}};
    const glm::mat4 worldFromClip = glm::inverse(camera.clipFromView * camera.viewFromWorld);
    std::atomic<int> done = 0;
    tbb::parallel_for(0, height, [&](int y) {
        if (progress.cancelled())
            return;
        for (int x = 0; x < width; ++x) {
            const glm::vec4 clip(2.f * (float(x) + 0.5f) / float(width) - 1.f, 1.f - 2.f * (float(y) + 0.5f) / float(height), 0.f, 1.f);
            const glm::vec4 world = worldFromClip * clip;
            const DisplacedMesh::Hit hit = surface.hit(camera.eye, glm::normalize(glm::vec3(world) / world.w - camera.eye));
            seen.metres[std::size_t(y) * std::size_t(width) + std::size_t(x)] = hit.back || hit.turned ? std::nanf("") : hit.distance;
        }
        progress.at(float(++done) / float(height));
    });
    if (progress.cancelled())
        return cancelled("reference");
    return seen;
}

} // namespace relievo
