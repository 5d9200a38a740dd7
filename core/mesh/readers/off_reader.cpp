// Object File Format as text: OFF with its prefixes for normals (N), colours (C) and texture coordinates (ST).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read here and not by OpenMesh: its reader takes most of a minute for a small file with a comment and finds no face in it, and
// never ends on damaged counts.
#include "core/ground/file.h"
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/raw_mesh.h"

namespace relievo {

namespace {
using Corner = RawMesh::Corner;

// Lines that are neither empty nor a comment.
std::optional<std::string_view> contentLine(TextCursor& lines)
{
    while (std::optional<std::string_view> line = lines.line()) {
        const std::string_view content = line->substr(0, line->find('#'));
        if (!TextCursor(content).word().empty())
            return content;
    }
    return std::nullopt;
}

class OffParser {
public:
    explicit OffParser(std::string where) : m_where(std::move(where)) { }

    Expected<RawMesh> parse(const std::string& text, const Progress& progress)
    {
        TextCursor lines(text);
        TextCursor words(contentLine(lines).value_or(""));
        const std::string_view magic = words.word();
        if (magic != "OFF" && magic != "COFF" && magic != "NOFF" && magic != "CNOFF" && magic != "STOFF" && magic != "STCOFF"
            && magic != "STNOFF" && magic != "STCNOFF")
            return damaged("this is no OFF file of three dimensions: it begins with \"" + std::string(magic.substr(0, 12)) + '"');
        m_hasUVs = magic.starts_with("ST");
        m_hasNormals = magic.ends_with("NOFF");
        std::string_view first = words.word();
        if (first == "BINARY")
            return failure(ErrorCode::Unreadable, m_where, "binary OFF files are not read", "Save it as text, or as PLY");
        if (first.empty()) {
            words = TextCursor(contentLine(lines).value_or(""));
            first = words.word();
        }
        const std::optional<long long> vertices = integerOf(first), faces = integerOf(words.word());
        if (!vertices || !faces || *vertices < 0 || *faces < 0)
            return damaged("the file does not say how many vertices and faces it holds");
        // Each takes a line of at least two characters.
        if (std::size_t(*vertices) > text.size() || std::size_t(*faces) > text.size())
            return damaged("the file claims more vertices or faces than it can hold");
        for (long long i = 0; i < *vertices; ++i)
            if (!addVertex(contentLine(lines)))
                return damaged("the file ends in vertex " + std::to_string(i) + " of " + std::to_string(*vertices));
        for (long long i = 0; i < *faces; ++i) {
            if (!addFace(contentLine(lines)))
                return damaged("face " + std::to_string(i) + " of " + std::to_string(*faces)
                    + " is missing or names a vertex that the file does not hold");
            if ((i & 0xffff) == 0 && progress.cancelled())
                return cancelled(m_where);
        }
        m_raw.countsUnused = true;
        m_raw.parts = {{"", "", 0, std::uint32_t(m_raw.corners.size())}};
        return std::move(m_raw);
    }

private:
    tl::unexpected<Error> damaged(std::string what) const
    {
        return failure(ErrorCode::Unreadable, m_where, std::move(what), "Export the file again");
    }

    bool addVertex(std::optional<std::string_view> line)
    {
        if (!line)
            return false;
        TextCursor words(*line);
        const auto number = [&] { return doubleOf(words.word(), m_raw.cutNumbers); };
        const double x = number(), y = number(), z = number();
        m_raw.addPosition({x, y, z});
        if (m_hasNormals) {
            const float nx = float(number()), ny = float(number()), nz = float(number());
            m_raw.normals.emplace_back(nx, ny, nz);
        }
        if (m_hasUVs) { // the last two, after a colour of any length
            std::string_view u, v;
            for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
                u = v;
                v = word;
            }
            m_raw.uvs.emplace_back(floatOf(u), 1.f - floatOf(v));
        }
        return true;
    }

    bool addFace(std::optional<std::string_view> line)
    {
        if (!line)
            return false;
        TextCursor words(*line);
        const std::optional<long long> corners = integerOf(words.word());
        if (!corners || *corners < 0 || std::size_t(*corners) > line->size())
            return false;
        m_polygon.clear();
        for (long long k = 0; k < *corners; ++k) {
            const std::optional<long long> index = integerOf(words.word());
            if (!index || *index < 0 || std::size_t(*index) >= m_raw.positions.size())
                return false;
            const auto at = std::uint32_t(*index);
            m_polygon.push_back({at, m_hasNormals ? at : RawMesh::kNone, m_hasUVs ? at : RawMesh::kNone, RawMesh::kNone});
        }
        addPolygon(m_raw, m_polygon);
        return true;
    }

    std::string m_where;
    RawMesh m_raw;
    std::vector<Corner> m_polygon;
    bool m_hasNormals = false, m_hasUVs = false;
};
} // namespace

Expected<RawMesh> readOff(const std::filesystem::path& file, const Progress& progress)
{
    const Expected<std::string> text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    if (text->empty())
        return failure(ErrorCode::Unreadable, file.string(), "the file is empty", "Export it again");
    return OffParser(file.string()).parse(*text, progress);
}

} // namespace relievo
