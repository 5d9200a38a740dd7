// Stanford PLY, text and binary of either byte order: vertices, faces and triangle strips.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read here and not by OpenMesh: its reader loses faces of binary files with Windows line ends in the header, and spins for
// minutes on damaged counts. Every count is checked against the bytes that are left before anything is allocated.
#include "core/ground/file.h"
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/ply_values.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;

float narrowed(double value)
{
    return std::abs(value) < 3e38 ? float(value) : std::numeric_limits<float>::quiet_NaN();
}

// What a vertex property means: an index into the eight numbers of a vertex, or none of them.
std::optional<std::size_t> slotOf(std::string_view name)
{
    constexpr std::string_view kNames[8]
        = {"x", "y", "z", "nx", "ny", "nz", "u s texture_u texture_s s0 u0", "v t texture_v texture_t t0 v0"};
    for (std::size_t i = 0; i < 8; ++i) {
        TextCursor names(kNames[i]);
        for (std::string_view word = names.word(); !word.empty(); word = names.word())
            if (word == name)
                return i;
    }
    return std::nullopt;
}

class PlyParser {
public:
    PlyParser(std::string where, std::string_view data, const PlyHeader& header, const Progress& progress)
        : m_where(std::move(where))
        , m_values(data, header.format)
        , m_progress(progress)
    {
    }

    Expected<RawMesh> parse(const PlyHeader& header)
    {
        for (const PlyElement& element : header.elements) {
            if (element.count > m_values.left() && !element.properties.empty())
                return damaged(
                    "the header promises " + std::to_string(element.count) + " of \"" + element.name + "\", more than the file can hold");
            Expected<void> done = element.name == "vertex" ? readVertices(element) : readFaces(element);
            if (!done)
                return tl::unexpected(done.error());
        }
        if (m_raw.corners.empty())
            return failure(ErrorCode::Unreadable, m_where, "the file holds points, but no faces", "Make a surface of the points first");
        if (m_raw.corners.size() > 0xffffffffu)
            return failure(ErrorCode::Unreadable, m_where, "the mesh has more corners than can be counted in 32 bits", "Split it");
        m_raw.cutNumbers = m_values.cutNumbers();
        m_raw.countsUnused = true;
        m_raw.parts = {{"", "", 0, std::uint32_t(m_raw.corners.size())}};
        return std::move(m_raw);
    }

private:
    tl::unexpected<Error> damaged(std::string what) const
    {
        return failure(ErrorCode::Unreadable, m_where, std::move(what), "Export the file again");
    }

    Expected<void> checkpoint(const PlyElement& element, std::size_t i)
    {
        if (m_values.failed())
            return damaged("the data end in \"" + element.name + "\" " + std::to_string(i) + " of " + std::to_string(element.count));
        if ((i & 0xffff) == 0 && m_progress.cancelled())
            return cancelled(m_where);
        return {};
    }

    // The numbers of one list; nothing when its count cannot be true.
    std::optional<std::vector<double>> list(const PlyProperty& property)
    {
        const double count = m_values.next(*property.countType);
        if (!(count >= 0) || count > double(m_values.left()))
            return std::nullopt;
        std::vector<double> numbers(static_cast<std::size_t>(count));
        for (double& number : numbers)
            number = m_values.next(property.type);
        return numbers;
    }

    tl::unexpected<Error> longList(const PlyElement& element, std::size_t i) const
    {
        return damaged("a list of \"" + element.name + "\" " + std::to_string(i) + " claims more numbers than the file can hold");
    }

    Expected<void> readVertices(const PlyElement& element)
    {
        if (m_hasVertices)
            return damaged("the header declares the vertices twice");
        m_hasVertices = true;
        std::array<bool, 8> present{};
        std::vector<std::optional<std::size_t>> slots;
        for (const PlyProperty& property : element.properties) {
            slots.push_back(property.countType ? std::nullopt : slotOf(property.name));
            if (slots.back())
                present[*slots.back()] = true;
        }
        if (!present[0] || !present[1] || !present[2])
            return damaged("the vertices have no x, y and z");
        m_hasNormals = present[3] && present[4] && present[5];
        m_hasUVs = present[6] && present[7];
        for (std::size_t i = 0; i < element.count; ++i) {
            std::array<double, 8> vertex{};
            for (std::size_t k = 0; k < slots.size(); ++k) {
                if (element.properties[k].countType && !list(element.properties[k]))
                    return longList(element, i);
                if (element.properties[k].countType)
                    continue;
                if (const double value = m_values.next(element.properties[k].type); slots[k])
                    vertex[*slots[k]] = value;
            }
            m_values.endElement();
            if (Expected<void> sound = checkpoint(element, i); !sound)
                return sound;
            m_raw.addPosition({vertex[0], vertex[1], vertex[2]});
            if (m_hasNormals)
                m_raw.normals.emplace_back(narrowed(vertex[3]), narrowed(vertex[4]), narrowed(vertex[5]));
            if (m_hasUVs)
                m_raw.uvs.emplace_back(narrowed(vertex[6]), 1.f - narrowed(vertex[7]));
        }
        return {};
    }

    // Faces, strips, and whatever else, whose numbers are passed over.
    Expected<void> readFaces(const PlyElement& element)
    {
        const bool strips = element.name == "tristrips", faces = element.name == "face" || strips;
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            std::vector<double> indices, uvs;
            for (const PlyProperty& property : element.properties) {
                if (!property.countType) {
                    m_values.next(property.type);
                    continue;
                }
                std::optional<std::vector<double>> numbers = list(property);
                if (!numbers)
                    return longList(element, i);
                if (property.name == "vertex_indices" || property.name == "vertex_index")
                    indices = std::move(*numbers);
                else if (property.name == "texcoord")
                    uvs = std::move(*numbers);
            }
            m_values.endElement();
            if (Expected<void> sound = checkpoint(element, i); !sound)
                return sound;
            if (Expected<void> added = faces ? addFace(indices, uvs, strips, i) : Expected<void>(); !added)
                return added;
        }
        return {};
    }

    Expected<void> addFace(const std::vector<double>& indices, const std::vector<double>& uvs, bool strip, std::size_t number)
    {
        m_polygon.clear();
        for (std::size_t k = 0; k < indices.size(); ++k) {
            if (strip && indices[k] < 0) { // -1 ends a strip
                addStrip();
                m_polygon.clear();
                continue;
            }
            if (!(indices[k] >= 0) || indices[k] >= double(m_raw.positions.size()))
                return damaged("face " + std::to_string(number) + " names a vertex that the file does not hold");
            const auto at = std::uint32_t(indices[k]);
            m_polygon.push_back({at, m_hasNormals ? at : RawMesh::kNone, m_hasUVs ? at : RawMesh::kNone, RawMesh::kNone});
            if (uvs.size() == 2 * indices.size()) {
                m_polygon.back().uv = std::uint32_t(m_raw.uvs.size());
                m_raw.uvs.emplace_back(narrowed(uvs[2 * k]), 1.f - narrowed(uvs[2 * k + 1]));
            }
        }
        if (strip)
            addStrip();
        else
            addPolygon(m_raw, m_polygon);
        return {};
    }

    void addStrip()
    {
        for (std::size_t k = 2; k < m_polygon.size(); ++k) {
            const bool odd = k % 2 == 1;
            const Corner a = m_polygon[k - 2], b = m_polygon[k - 1], c = m_polygon[k];
            if (a.position != b.position && b.position != c.position && c.position != a.position)
                m_raw.corners.insert(m_raw.corners.end(), {odd ? b : a, odd ? a : b, c});
        }
    }

    std::string m_where;
    PlyValues m_values;
    const Progress& m_progress;
    RawMesh m_raw;
    std::vector<Corner> m_polygon;
    bool m_hasVertices = false, m_hasNormals = false, m_hasUVs = false;
};
} // namespace

Expected<RawMesh> readPly(const std::filesystem::path& file, const Progress& progress)
{
    const Expected<std::string> text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    const Expected<PlyHeader> header = parsePlyHeader(*text, file.string());
    if (!header)
        return tl::unexpected(header.error());
    return PlyParser(file.string(), std::string_view(*text).substr(header->bytes), *header, progress).parse(*header);
}

} // namespace relievo
