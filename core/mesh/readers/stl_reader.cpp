// STL: triangles without neighbours, binary through the reader of OpenMesh, text by our own.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later

// OpenMesh fills our own importer instead of a half-edge mesh, which would drop every face at an edge that more than two share. It trusts
// the count of a file and takes NaN for equal to any number: both are seen to first. Of text it takes numbers that it cannot read for
// whatever its memory held, and knows neither SOLID in capitals nor line ends of old Macs.
#include "core/ground/file.h"
#include "core/ground/text.h"
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/raw_mesh.h"
#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <sstream>

namespace relievo {

namespace {
using namespace OpenMesh;
using Corner = RawMesh::Corner;
constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50;

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

Expected<void> runReader(const std::string& bytes, Collector& collector, const std::string& where)
{
    const SilentOpenMesh silence;
    try {
        std::istringstream stream(bytes);
        IO::Options options = IO::Options::Binary;
        if (!IO::STLReader().read(stream, collector, options))
            return failure(ErrorCode::Unreadable, where, "the file could not be understood", "Export it again");
    } catch (const std::exception& problem) {
        return failure(ErrorCode::Unreadable, where, std::string("the file could not be read (") + problem.what() + ")", "Export it again");
    }
    return {};
}

class StlParser {
public:
    StlParser(const std::string& bytes, const std::string& where, const Progress& progress)
        : m_bytes(bytes)
        , m_where(where)
        , m_progress(progress)
    {
    }

    Expected<RawMesh> parse()
    {
        if (m_bytes.size() >= kHeaderBytes)
            std::memcpy(&m_count, m_bytes.data() + 80, 4);
        const std::size_t expected = kHeaderBytes + std::size_t(m_count) * kFacetBytes;
        const bool saysSolid = lowered(TextCursor(std::string_view(m_bytes).substr(0, kHeaderBytes)).word()) == "solid";
        if (saysSolid && m_bytes.size() != expected)
            readText();
        if (m_facets == 0) {
            if (m_bytes.size() < kHeaderBytes || m_bytes.size() < expected)
                return failure(ErrorCode::Unreadable, m_where,
                    saysSolid ? "the file holds no facets" : "the file is shorter than its count of triangles says", "Export it again");
            if (Expected<void> done = readBinary(); !done)
                return tl::unexpected(done.error());
        }
        if (m_progress.cancelled())
            return cancelled(m_where);
        return finished();
    }

private:
    void readText()
    {
        TextCursor words(m_bytes);
        for (std::string word = lowered(words.word()); !word.empty(); word = lowered(words.word())) {
            if (word == "solid" || word == "endsolid") {
                words.line(); // a name of any words
            } else if (word == "facet") {
                ++m_facets;
            } else if (word == "vertex") {
                const auto number = [&] { return doubleOf(words.word(), m_raw.cutNumbers); };
                const double x = number(), y = number(), z = number();
                addCorner({x, y, z});
            } else if (word == "endfacet") {
                endFacet();
            }
            if ((m_facets & 0xffff) == 0xffff && m_progress.cancelled())
                return;
        }
        m_polygon.clear(); // of a facet that does not end
    }

    Expected<void> readBinary()
    {
        std::string sound = m_bytes.substr(0, kHeaderBytes); // without the facets that have a corner nowhere
        std::uint32_t count = 0;
        for (m_facets = 0; m_facets < m_count; ++m_facets) {
            const std::size_t at = kHeaderBytes + m_facets * kFacetBytes;
            float numbers[12]; // a normal and three corners
            std::memcpy(numbers, m_bytes.data() + at, sizeof numbers);
            if (std::all_of(numbers + 3, numbers + 12, [](float number) { return std::isfinite(number); })) {
                sound.append(m_bytes, at, kFacetBytes);
                ++count;
            }
        }
        std::memcpy(sound.data() + 80, &count, 4);
        Collector collector(m_raw);
        const Expected<void> done = runReader(sound, collector, m_where);
        m_whole = collector.n_faces() - collector.badFaces();
        return done;
    }

    void addCorner(glm::dvec3 position)
    {
        m_polygon.push_back({std::uint32_t(m_raw.positions.size()), RawMesh::kNone, RawMesh::kNone, RawMesh::kNone});
        m_raw.addPosition(position);
    }

    void endFacet()
    {
        const auto at = [&](std::size_t k) { return m_raw.positions[m_polygon[k].position]; };
        const bool isLine = m_polygon.size() == 3 && (at(0) == at(1) || at(1) == at(2) || at(2) == at(0));
        if (m_polygon.size() >= 3 && !isLine) {
            addPolygon(m_raw, m_polygon);
            ++m_whole;
        }
        m_polygon.clear();
    }

    Expected<RawMesh> finished()
    {
        if (m_raw.corners.empty())
            return failure(ErrorCode::Unreadable, m_where, "none of its facets has three different corners", "Export it again");
        if (m_whole < m_facets)
            m_raw.warn(
                "triangles-dropped", std::to_string(m_facets - m_whole) + " faces without area or with broken corners were left out.");
        m_raw.countsUnused = true;
        m_raw.sharesVertices = false;
        m_raw.parts = {{"", "", 0, std::uint32_t(m_raw.corners.size())}};
        return std::move(m_raw);
    }

    const std::string& m_bytes;
    const std::string& m_where;
    const Progress& m_progress;
    RawMesh m_raw;
    std::vector<Corner> m_polygon;
    std::uint32_t m_count = 0; // of triangles, as a binary file has it
    std::size_t m_facets = 0, m_whole = 0;
};
} // namespace

Expected<RawMesh> readStl(const std::filesystem::path& file, const Progress& progress)
{
    const Expected<std::string> bytes = readText(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (bytes->empty())
        return failure(ErrorCode::Unreadable, file.string(), "the file is empty", "Export it again");
    return StlParser(*bytes, file.string(), progress).parse();
}

} // namespace relievo
