// Vertices, curvature, borders and pose of the mesh as OpenGL reads them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/uploads/mesh_upload.h"
#include "core/mesh/edges/across.h"
#include "core/mesh/edges/borders.h"
#include "core/mesh/edges/closed.h"
#include "core/mesh/edges/coarse.h"
#include "core/mesh/edges/prism_texels.h"
#include "core/mesh/frames/curvature.h"
#include "core/mesh/frames/push.h"
#include "core/scene/resources.h"
#include "render/gl/texture_units.h"
#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <span>
#include <utility>
#include <vector>

namespace relievo {

namespace {
Buffer vectorBuffer(std::span<const glm::vec3> values)
{
    Buffer buffer = newBuffer();
    glBindBuffer(GL_ARRAY_BUFFER, *buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(values.size_bytes()), values.data(), GL_STATIC_DRAW);
    return buffer;
}

// One vector a vertex for attribute `location` of the vertex array that is bound.
void vectorAttribute(GLuint location, const Buffer& buffer)
{
    glBindBuffer(GL_ARRAY_BUFFER, *buffer);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
}

// What shaders/view_ray/borders_cut.glsl reads: first and count of each triangle, then the segments. Nothing for a mesh without borders.
std::vector<glm::vec4> borderTexels(const Mesh& mesh)
{
    GLint limit = 0; // texels
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    const std::size_t triangles = mesh.indices.size() / 3, room = std::size_t(std::max(limit, 0));
    BorderLimits limits;
    limits.budget = std::min(limits.budget, room - std::min(triangles, room));
    const Borders borders = bordersOf(mesh, limits);
    if (borders.segments.empty())
        return {};
    std::vector<glm::vec4> texels;
    texels.reserve(triangles + borders.segments.size());
    for (std::size_t i = 0; i < triangles; ++i)
        texels.emplace_back(float(triangles + borders.starts[i]), float(borders.starts[i + 1] - borders.starts[i]), 0.f, 0.f);
    texels.insert(texels.end(), borders.segments.begin(), borders.segments.end());
    return texels;
}
} // namespace

void MeshUpload::show(const std::shared_ptr<const Mesh>& mesh)
{
    if (mesh != std::exchange(m_mesh, mesh))
        *this = MeshUpload(), m_mesh = mesh;
}

bool MeshUpload::showsBacks(glm::vec3 eye, float margin)
{
    if (!m_closed)
        m_closed = isClosed(*m_mesh);
    if (m_mesh->deformation) // may move out of the bounds, which are at rest
        margin += glm::distance(m_mesh->boundsMin, m_mesh->boundsMax);
    const glm::vec3 least = m_mesh->boundsMin - margin, most = m_mesh->boundsMax + margin;
    return !*m_closed || (glm::all(glm::greaterThanEqual(eye, least)) && glm::all(glm::lessThanEqual(eye, most)));
}

bool MeshUpload::isFinerThanPixels() const
{
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    return m_mesh->indices.size() / 3 > std::size_t(viewport[2]) * std::size_t(viewport[3]);
}

bool MeshUpload::hasBorders()
{
    if (!m_borders) {
        m_borders.emplace();
        glActiveTexture(GL_TEXTURE0 + kBorderUnit);
        if (const std::vector<glm::vec4> texels = borderTexels(*m_mesh); !texels.empty())
            m_borders->fill(texels, GL_STATIC_DRAW);
    }
    return m_borders->texture() != 0;
}

bool MeshUpload::hasPrisms()
{
    constexpr std::size_t kExact = std::size_t(1) << 24; // floats count so far
    GLint limit = 0; // texels
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    const std::size_t texels = 1 + kPrismVertexTexels * m_mesh->vertices.size() + kPrismTriangleTexels * (m_mesh->indices.size() / 3);
    return texels <= std::size_t(std::max(limit, 0)) && std::max(texels, m_mesh->indices.size()) < kExact;
}

void MeshUpload::bindPrisms(const LinkedProgram& program, const Pose& pose, std::string_view part)
{
    if (std::pair are(pose, std::string(part)); m_prismsAre != are) {
        if (m_across.empty())
            m_across = edgesAcross(*m_mesh);
        glActiveTexture(GL_TEXTURE0 + kBorderUnit);
        m_prisms.fill(
            prismTexels(posed(*m_mesh, pose), m_across, plainParts(*m_mesh, part)), m_mesh->deformation ? GL_STREAM_DRAW : GL_STATIC_DRAW);
        m_prismsAre = std::move(are);
    }
    program.bind("prismMap", GL_TEXTURE_BUFFER, m_prisms.texture(), kBorderUnit); // a program reads one of the two
}

void MeshUpload::bind(const LinkedProgram& program, const Parameters& parameters, std::string_view part, Silhouettes curvature)
{
    if (m_mesh->deformation && program.reads("poseMap"))
        m_pose.bind(program, *m_mesh, poseOf(*m_mesh, parameters), curvature);
    if (m_mesh->object)
        m_object.bind(program, *m_mesh->object);
    if (program.reads("prismMap"))
        bindPrisms(program, poseOf(*m_mesh, parameters), part);
    if (program.reads("borderMap") && hasBorders())
        program.bind("borderMap", GL_TEXTURE_BUFFER, m_borders->texture(), kBorderUnit);
}

bool MeshUpload::has(Parts parts, std::string_view part) const
{
    return std::ranges::count(plainParts(*m_mesh, part), char(parts == Parts::Plain)) > 0;
}

void MeshUpload::makeVertices()
{
    m_vertexArray = newVertexArray(), m_vertices = newBuffer(), m_indices = newBuffer();
    glBindVertexArray(*m_vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, *m_vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_mesh->vertices.size() * sizeof(Vertex)), m_mesh->vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, *m_indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(m_mesh->indices.size() * 4), m_mesh->indices.data(), GL_STATIC_DRAW);
    const auto attribute = [](GLuint location, GLint size, std::size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, uv));
    attribute(3, 3, offsetof(Vertex, dPdu));
    attribute(4, 3, offsetof(Vertex, dPdv));
    if (m_mesh->deformation)
        m_pose.addAttributes(*m_mesh);
}

// Along the longest side: about as many as a picture has pixels there that is drawn while the eye moves.
constexpr float kCoarseCubes = 96.f;

void MeshUpload::makeCoarse()
{
    const Mesh rest = posed(*m_mesh, poseAt(*m_mesh, -1, 0.f)); // what the bounds are of
    const glm::vec3 size = rest.boundsMax - rest.boundsMin;
    CoarseTriangles coarse = coarseTriangles(rest, std::max({size.x, size.y, size.z}) / kCoarseCubes);
    m_coarse = newBuffer();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, *m_coarse);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(coarse.indices.size() * 4), coarse.indices.data(), GL_STATIC_DRAW);
    m_coarseFirst = std::move(coarse.firstIndex);
}

void MeshUpload::draw(const LinkedProgram& program, Parts parts, std::string_view part, bool pushed, Silhouettes curvature, bool coarse)
{
    if (!m_vertexArray)
        makeVertices();
    glBindVertexArray(*m_vertexArray);
    if (pushed && !m_push) {
        m_push = vectorBuffer(pushDirections(*m_mesh));
        vectorAttribute(5, m_push);
    }
    if (curvature != Silhouettes::Off) {
        Buffer& falls = m_curvature[curvature];
        if (!falls)
            falls = vectorBuffer(vertexFalls(*m_mesh, curvature == Silhouettes::Axes));
        vectorAttribute(6, falls);
    }
    if (coarse && !m_coarse)
        makeCoarse();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, coarse ? *m_coarse : *m_indices);
    const std::vector<MeshPart>& all = m_mesh->parts;
    const std::vector<char> plain = plainParts(*m_mesh, part);
    for (std::size_t i = 0, last = 0; i < all.size(); i = std::max(last, i + 1)) { // neighbours in one call
        std::uint32_t count = 0;
        for (last = i; last < all.size() && plain[last] == char(parts == Parts::Plain); ++last)
            count += coarse ? m_coarseFirst[last + 1] - m_coarseFirst[last] : all[last].indexCount;
        if (count == 0)
            continue;
        const std::uint32_t first = coarse ? m_coarseFirst[i] : all[i].firstIndex;
        program.set("firstTriangle", float(first / 3));
        glDrawElements(
            GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_INT, reinterpret_cast<const void*>(std::uintptr_t(first) * sizeof(std::uint32_t)));
    }
    glBindVertexArray(0);
}

} // namespace relievo
