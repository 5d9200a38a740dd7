// STL, binary and text, through the reader of OpenMesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The reader fills our own importer instead of a half-edge mesh, which would drop every face at an edge that more than two
// share. It trusts the count of a file, so that is checked here first.
#include "core/file.h"
#include "core/mesh/raw_mesh.h"
#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <cstring>
#include <mutex>
#include <sstream>

namespace relievo {

namespace {
using namespace OpenMesh;
using Corner = RawMesh::Corner;

// Collects vertices and faces as they come; what relief does not need (colours, edges, states) is passed over.
class Collector : public IO::BaseImporter {
public:
    explicit Collector(RawMesh& raw) : m_raw(raw) { }
    std::size_t badFaces() const { return m_badFaces; }

    VertexHandle add_vertex(const Vec3f& p) override
    {
        m_raw.positions.emplace_back(p[0], p[1], p[2]);
        return VertexHandle(int(m_raw.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(Vec3f(0.f, 0.f, 0.f)); }
    void set_point(VertexHandle v, const Vec3f& p) override { m_raw.positions.at(index(v)) = {p[0], p[1], p[2]}; }
    void set_normal(VertexHandle, const Vec3f&) override { }
    void set_normal(VertexHandle, const Vec3d&) override { }
    void set_texcoord(VertexHandle, const Vec2f&) override { }
    void set_texcoord(VertexHandle, const Vec3f&) override { }
    FaceHandle add_face(const VHandles& corners) override
    {
        m_polygon.clear();
        for (const VertexHandle v : corners) {
            if (index(v) >= m_raw.positions.size()) {
                ++m_badFaces;
                return FaceHandle(m_faces++);
            }
            const auto at = std::uint32_t(v.idx());
            m_polygon.push_back({at, RawMesh::kNone, RawMesh::kNone, RawMesh::kNone});
        }
        addPolygon(m_raw, m_polygon);
        return FaceHandle(m_faces++);
    }
    size_t n_vertices() const override { return m_raw.positions.size(); }
    size_t n_faces() const override { return std::size_t(m_faces); }
    size_t n_edges() const override { return 0; }

    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(0); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(0); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override { }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override { }
    void set_face_texindex(FaceHandle, int) override { }
    void set_halfedge(VertexHandle, HalfedgeHandle) override { }
    void set_color(VertexHandle, const Vec3uc&) override { }
    void set_color(VertexHandle, const Vec4uc&) override { }
    void set_color(VertexHandle, const Vec3f&) override { }
    void set_color(VertexHandle, const Vec4f&) override { }
    void set_status(VertexHandle, const Attributes::StatusInfo&) override { }
    void set_next(HalfedgeHandle, HalfedgeHandle) override { }
    void set_face(HalfedgeHandle, FaceHandle) override { }
    void request_face_texcoords2D() override { }
    void set_texcoord(HalfedgeHandle, const Vec2f&) override { }
    void set_texcoord(HalfedgeHandle, const Vec3f&) override { }
    void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override { }
    void set_color(EdgeHandle, const Vec3uc&) override { }
    void set_color(EdgeHandle, const Vec4uc&) override { }
    void set_color(EdgeHandle, const Vec3f&) override { }
    void set_color(EdgeHandle, const Vec4f&) override { }
    void set_status(EdgeHandle, const Attributes::StatusInfo&) override { }
    void set_normal(FaceHandle, const Vec3f&) override { }
    void set_normal(FaceHandle, const Vec3d&) override { }
    void set_color(FaceHandle, const Vec3uc&) override { }
    void set_color(FaceHandle, const Vec4uc&) override { }
    void set_color(FaceHandle, const Vec3f&) override { }
    void set_color(FaceHandle, const Vec4f&) override { }
    void set_status(FaceHandle, const Attributes::StatusInfo&) override { }
    void add_texture_information(int, std::string) override { }

private:
    static std::size_t index(VertexHandle v) { return v.idx() < 0 ? ~std::size_t(0) : std::size_t(v.idx()); }

    RawMesh& m_raw;
    std::vector<Corner> m_polygon;
    int m_faces = 0;
    std::size_t m_badFaces = 0;
};

// OpenMesh's readers keep state and write to its error stream: one at a time, and silent.
class SilentOpenMesh {
public:
    SilentOpenMesh() { omerr().disable(); }
    ~SilentOpenMesh() { omerr().enable(); }
    SilentOpenMesh(const SilentOpenMesh&) = delete;
    SilentOpenMesh& operator=(const SilentOpenMesh&) = delete;

private:
    static std::mutex& door()
    {
        static std::mutex mutex;
        return mutex;
    }
    std::lock_guard<std::mutex> m_lock{door()};
};

// What the file claims to hold, checked against its text.
struct Claim {
    bool binary = false;
    std::size_t faces = 0;
};

Expected<Claim> checkedStl(const std::string& text, const std::string& where)
{
    std::uint32_t count = 0;
    const bool hasCount = text.size() >= 84;
    if (hasCount)
        std::memcpy(&count, text.data() + 80, 4);
    const bool fits = hasCount && text.size() >= 84 + std::size_t(count) * 50;
    const bool saysSolid = text.starts_with("solid") || text.starts_with(" solid");
    std::size_t ends = 0;
    for (std::size_t at = 0; (at = text.find("endfacet", at)) != text.npos; ++at)
        ++ends;
    if (saysSolid && ends > 0 && !(hasCount && text.size() == 84 + std::size_t(count) * 50))
        return Claim{false, ends};
    if (!fits)
        return failure(
            where, saysSolid ? "the file holds no facets" : "the file is shorter than its count of triangles says", "Export it again");
    return Claim{true, count};
}

Expected<void> runReader(const std::string& text, bool binary, Collector& collector, const std::string& where)
{
    const SilentOpenMesh silence;
    try {
        std::istringstream stream(text);
        IO::Options options;
        if (binary)
            options += IO::Options::Binary;
        const bool done = IO::STLReader().read(stream, collector, options);
        if (!done)
            return failure(where, "the file could not be understood", "Export it again");
    } catch (const std::exception& problem) {
        return failure(where, std::string("the file could not be read (") + problem.what() + ")", "Export it again");
    }
    return {};
}
} // namespace

Expected<RawMesh> readStl(const std::filesystem::path& file, const Progress& progress)
{
    const Expected<std::string> text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    if (text->empty())
        return failure(file.string(), "the file is empty", "Export it again");
    const Expected<Claim> claim = checkedStl(*text, file.string());
    if (!claim)
        return tl::unexpected(claim.error());
    if (progress.cancelled())
        return failure(file.string(), "cancelled");
    RawMesh raw;
    Collector collector(raw);
    if (Expected<void> done = runReader(*text, claim->binary, collector, file.string()); !done)
        return tl::unexpected(done.error());
    const std::size_t faces = collector.n_faces() - collector.badFaces();
    if (faces < claim->faces)
        raw.warn("triangles-dropped", std::to_string(claim->faces - faces) + " faces without area or with broken corners were left out.");
    raw.countsUnused = true;
    raw.sharesVertices = false;
    raw.parts = {{"", "", 0, std::uint32_t(raw.corners.size())}};
    return raw;
}

} // namespace relievo
