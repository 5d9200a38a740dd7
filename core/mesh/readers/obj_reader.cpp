// Wavefront OBJ: positions, UVs, normals and polygons, with parts by object and material.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read here and not by OpenMesh: its reader keeps one normal a vertex, drops faces that visit a vertex twice, and a half-edge
// mesh refuses faces where more than two meet. An artist's file must come in whole.
#include "core/ground/file.h"
#include "core/ground/name_forms.h"
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <map>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kSpaces = " \t\r";
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    return text.substr(0, text.find_last_not_of(kSpaces) + 1);
}
} // namespace

std::string plainText(std::string text)
{
    const bool bigEndian = text.starts_with("\xFE\xFF"), littleEndian = text.starts_with("\xFF\xFE");
    if (!bigEndian && !littleEndian)
        return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
    const std::string_view body = std::string_view(text).substr(2);
    if (std::optional<std::string> whole = fromCodePage(bigEndian ? "UTF-16BE" : "UTF-16LE", body.substr(0, body.size() / 2 * 2)))
        return std::move(*whole);
    std::string plain; // it is damaged: the ASCII part of it
    for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
        const char high = text[bigEndian ? i : i + 1], low = text[bigEndian ? i + 1 : i];
        plain += high == 0 ? low : '?';
    }
    return plain;
}

namespace {
class ObjParser {
public:
    ObjParser(std::string where, const Progress& progress) : m_where(std::move(where)), m_progress(progress) { }

    Expected<RawMesh> parse(const std::string& text)
    {
        TextCursor lines(text);
        while (std::optional<std::string_view> line = lines.line()) {
            ++m_line;
            if ((m_line & 0x3fff) == 0) {
                m_progress.at(0.5f * (1.f - float(lines.rest().size()) / float(text.size())));
                if (m_progress.cancelled())
                    return cancelled(m_where);
            }
            std::string joined; // a backslash continues on the next line
            while (goesOn(*line)) {
                joined += line->substr(0, line->size() - 1);
                joined += ' ';
                ++m_line;
                line = lines.line().value_or("");
            }
            if (!joined.empty())
                line = joined += *line;
            if (Expected<void> done = statement(*line); !done)
                return tl::unexpected(done.error());
        }
        return finished();
    }

private:
    // Whether the statement continues on the next line; comments end with their own.
    static bool goesOn(std::string_view line)
    {
        const std::size_t comment = line.find('#');
        return line.ends_with('\\') && (comment == line.npos || (comment > 0 && line[comment - 1] != ' ' && line[comment - 1] != '\t'));
    }

    Expected<void> statement(std::string_view line)
    {
        TextCursor words(line);
        const std::string_view keyword = words.word();
        if (keyword == "v") {
            m_raw.addPosition(triple(words));
        } else if (keyword == "vn") {
            m_raw.normals.emplace_back(triple(words));
        } else if (keyword == "vt") {
            const float u = floatOf(words.word(), m_raw.cutNumbers);
            const std::string_view v = words.word(); // may be missing: a texture along a line
            m_raw.uvs.emplace_back(u, v.empty() ? 0.f : 1.f - floatOf(v, m_raw.cutNumbers));
        } else if (keyword == "f" || keyword == "fo") {
            return face(words);
        } else if (keyword == "o" || keyword == "g") {
            m_object = trimmed(words.rest());
        } else if (keyword == "usemtl") {
            m_material = trimmed(words.rest());
        } else if (keyword == "mtllib") {
            m_libraries.emplace_back(trimmed(words.rest()));
        } else if (keyword == "l" || keyword == "p") {
            ++m_skipped;
        } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
            ++m_freeForm;
        }
        return {};
    }

    glm::dvec3 triple(TextCursor& words)
    {
        const auto number = [&] { return doubleOf(words.word(), m_raw.cutNumbers); };
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }

    // Index as written (1 the first, -1 the last so far) to an index of a list; nothing when it lies outside.
    static std::optional<std::uint32_t> resolve(std::string_view word, std::size_t count)
    {
        const std::optional<long long> index = integerOf(word);
        if (!index || *index == 0)
            return std::nullopt;
        const long long at = *index > 0 ? *index - 1 : (long long)(count) + *index;
        return at >= 0 && at < (long long)(count) ? std::optional(std::uint32_t(at)) : std::nullopt;
    }

    std::uint32_t optionalIndex(std::string_view word, std::size_t count)
    {
        if (word.empty())
            return RawMesh::kNone;
        const std::optional<std::uint32_t> index = resolve(word, count);
        m_badAttributes += !index;
        return index.value_or(RawMesh::kNone);
    }

    tl::unexpected<Error> brokenFace(std::string_view vertex) const
    {
        std::string what = "line ";
        what += std::to_string(m_line);
        what += " names the vertex \"";
        what += vertex;
        what += "\", but ";
        what += std::to_string(m_raw.positions.size());
        what += " are defined above it";
        return failure(ErrorCode::Unreadable, m_where, what, "Export the file again; its faces are damaged");
    }

    Expected<void> face(TextCursor& words)
    {
        m_polygon.clear();
        for (std::string_view word = words.word(); !word.empty() && word.front() != '#'; word = words.word()) {
            const std::size_t first = std::min(word.find('/'), word.size());
            const std::size_t second = std::min(word.find('/', std::min(first + 1, word.size())), word.size());
            const std::string_view uv = first < word.size() ? word.substr(first + 1, second - first - 1) : "";
            const std::string_view normal = second < word.size() ? word.substr(second + 1) : "";
            const std::optional<std::uint32_t> position = resolve(word.substr(0, first), m_raw.positions.size());
            if (!position)
                return brokenFace(word.substr(0, std::min(first, std::size_t(20))));
            m_polygon.push_back(
                {*position, optionalIndex(normal, m_raw.normals.size()), optionalIndex(uv, m_raw.uvs.size()), RawMesh::kNone});
        }
        if (m_polygon.size() < 3) {
            ++m_raw.shortFaces;
            return {};
        }
        // Faces of a part may be scattered over the file: they are sorted at the end.
        const auto part = m_partNumbers.try_emplace({m_object, m_material}, m_partNumbers.size()).first->second;
        const std::size_t before = m_raw.corners.size();
        addPolygon(m_raw, m_polygon);
        if (m_runs.empty() || m_runs.back().part != part)
            m_runs.push_back({part, before, before});
        m_runs.back().end = m_raw.corners.size();
        return {};
    }

    struct Run { // corners that follow each other in the file and belong to one part
        std::size_t part, begin, end;
    };

    Expected<RawMesh> finished()
    {
        if (m_raw.corners.size() > 0xffffffffu)
            return failure(ErrorCode::Unreadable, m_where, "the mesh has more corners than can be counted in 32 bits", "Split it");
        if (m_raw.corners.empty() && m_freeForm > 0)
            return failure(ErrorCode::Unreadable, m_where, "the file holds curved surfaces, not polygons", "Export it as polygons");
        if (m_raw.corners.empty())
            return failure(ErrorCode::Unreadable, m_where,
                m_skipped > 0 ? "the file holds points and lines, but no faces" : "the file holds no faces",
                "Export a surface of triangles or polygons");
        std::stable_sort(m_runs.begin(), m_runs.end(), [](const Run& a, const Run& b) { return a.part < b.part; });
        m_raw.parts.resize(m_partNumbers.size());
        for (const auto& [key, number] : m_partNumbers) {
            m_raw.parts[number].name = key.first;
            m_raw.parts[number].material = key.second;
        }
        std::size_t end = 0;
        for (const Run& run : m_runs) {
            MeshPart& part = m_raw.parts[run.part];
            if (part.indexCount == 0)
                part.firstIndex = std::uint32_t(end);
            end += run.end - run.begin;
            part.indexCount = std::uint32_t(end) - part.firstIndex;
        }
        if (!std::ranges::is_sorted(m_runs, {}, &Run::begin))
            m_raw.corners = inOrderOfRuns();
        m_raw.materials = readMtl(m_where, m_libraries, m_raw.warnings);
        warnOfLosses();
        return std::move(m_raw);
    }

    std::vector<Corner> inOrderOfRuns() const
    {
        std::vector<Corner> sorted;
        sorted.reserve(m_raw.corners.size());
        for (const Run& run : m_runs)
            sorted.insert(sorted.end(), m_raw.corners.begin() + std::ptrdiff_t(run.begin), m_raw.corners.begin() + std::ptrdiff_t(run.end));
        return sorted;
    }

    void warnOfLosses()
    {
        if (m_skipped > 0)
            m_raw.warn("lines-skipped", std::to_string(m_skipped) + " points or lines were left out; only faces are drawn.");
        if (m_freeForm > 0)
            m_raw.warn("curves-skipped", std::to_string(m_freeForm) + " curved surfaces were left out; export them as polygons.");
        if (m_badAttributes > 0)
            m_raw.warn(
                "attributes-repaired", std::to_string(m_badAttributes) + " corners name a UV or a normal that the file does not hold.");
    }

    std::string m_where;
    const Progress& m_progress;
    RawMesh m_raw;
    std::string m_object, m_material;
    std::vector<std::string> m_libraries;
    std::map<std::pair<std::string, std::string>, std::size_t> m_partNumbers;
    std::vector<Run> m_runs;
    std::vector<Corner> m_polygon;
    std::size_t m_line = 0, m_skipped = 0, m_freeForm = 0, m_badAttributes = 0;
};
} // namespace

Expected<RawMesh> readObj(const std::filesystem::path& file, const Progress& progress)
{
    Expected<std::string> text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    if (text->empty())
        return failure(ErrorCode::Unreadable, file.string(), "the file is empty", "Export it again");
    return ObjParser(file.string(), progress).parse(plainText(std::move(*text)));
}

} // namespace relievo
