// Stanford PLY, text and binary of either byte order: vertices, faces and triangle strips.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read here and not by OpenMesh: its reader loses faces of binary files with Windows line ends in the header, and spins for
// minutes on damaged counts. Every count is checked against the bytes that are left before anything is allocated.
#include "core/ground/file.h"
#include "core/ground/text_cursor.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;

enum class Type { I8, U8, I16, U16, I32, U32, F32, F64 };
struct TypeRow {
    std::string_view name;
    Type type;
};
constexpr TypeRow kTypes[] = {{"char", Type::I8}, {"int8", Type::I8}, {"uchar", Type::U8}, {"uint8", Type::U8}, {"short", Type::I16},
    {"int16", Type::I16}, {"ushort", Type::U16}, {"uint16", Type::U16}, {"int", Type::I32}, {"int32", Type::I32}, {"uint", Type::U32},
    {"uint32", Type::U32}, {"float", Type::F32}, {"float32", Type::F32}, {"double", Type::F64}, {"float64", Type::F64}};
constexpr std::size_t kTypeBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};

std::optional<Type> typeNamed(std::string_view name)
{
    for (const TypeRow& row : kTypes)
        if (row.name == name)
            return row.type;
    return std::nullopt;
}

struct Property {
    std::string name;
    Type type = Type::F32;
    std::optional<Type> countType; // of a list
};
struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};
struct Header {
    enum class Format { Text, Little, Big } format = Format::Text;
    std::vector<Element> elements;
    std::size_t bytes = 0; // where the data begin
};

Expected<Header> parseHeader(std::string_view text, const std::string& where)
{
    const auto damaged
        = [&where](std::string what) { return failure(ErrorCode::Unreadable, where, std::move(what), "Export the file again"); };
    TextCursor lines(text);
    Header header;
    bool hasFormat = false;
    if (TextCursor(lines.line().value_or("")).word() != "ply")
        return damaged("this is no PLY file: its first line is not \"ply\"");
    while (const std::optional<std::string_view> line = lines.line()) {
        TextCursor words(*line);
        const std::string_view keyword = words.word();
        if (keyword == "end_header") {
            header.bytes = text.size() - lines.rest().size();
            return hasFormat ? Expected<Header>(header) : damaged("the header does not name the format");
        }
        if (keyword == "format") {
            const std::string_view name = words.word();
            hasFormat = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
            if (!hasFormat)
                return damaged("the header names an unknown format");
            header.format = name == "ascii"       ? Header::Format::Text
                : name.ends_with("little_endian") ? Header::Format::Little
                                                  : Header::Format::Big;
        } else if (keyword == "element") {
            const std::string name(words.word());
            const std::optional<long long> count = integerOf(words.word());
            if (!count || *count < 0)
                return damaged("the header does not count the element \"" + name + '"');
            header.elements.push_back({name, std::size_t(*count), {}});
        } else if (keyword == "property") {
            std::string_view type = words.word();
            Property property;
            if (type == "list") {
                property.countType = typeNamed(words.word());
                type = words.word();
                if (!property.countType || *property.countType >= Type::F32)
                    return damaged("a list in the header has no type of count that is known");
            }
            const std::optional<Type> known = typeNamed(type);
            if (!known || header.elements.empty())
                return damaged("the header holds a property of unknown type");
            property.type = *known;
            property.name = words.word();
            header.elements.back().properties.push_back(std::move(property));
        }
    }
    return damaged("the header does not end");
}

// The numbers of the file one after the other, never beyond its end.
class Values {
public:
    Values(std::string_view data, Header::Format format)
        : m_text(format == Header::Format::Text ? data : std::string_view())
        , m_bytes(data)
        , m_format(format)
    {
    }

    bool failed() const { return m_failed; }
    std::size_t cutNumbers() const { return m_cut; }
    // No number takes less than a byte.
    std::size_t left() const { return m_format == Header::Format::Text ? m_text.rest().size() : m_bytes.size(); }

    // Text: one element a line. What a writer adds at its end (there are some that do) is passed over.
    void endElement() { m_text.line(); }

    double next(Type type)
    {
        if (m_format == Header::Format::Text) {
            const std::string_view word = m_text.word();
            m_failed |= word.empty();
            if (type >= Type::F32)
                return doubleOf(word, m_cut);
            const std::optional<long long> whole = integerOf(word);
            return whole ? double(*whole) : double(floatOf(word)); // some writers print counts as 3.0
        }
        const std::size_t size = kTypeBytes[std::size_t(type)];
        if (m_bytes.size() < size) {
            m_failed = true;
            m_bytes = {};
            return 0;
        }
        char raw[8] = {};
        std::copy_n(m_bytes.data(), size, raw);
        m_bytes.remove_prefix(size);
        if ((m_format == Header::Format::Big) != (std::endian::native == std::endian::big))
            std::reverse(raw, raw + size);
        return decoded(raw, type);
    }

private:
    template <class T> static double as(const char* raw)
    {
        T value;
        std::memcpy(&value, raw, sizeof value);
        return double(value);
    }
    static double decoded(const char* raw, Type type)
    {
        switch (type) {
        case Type::I8:
            return as<std::int8_t>(raw);
        case Type::U8:
            return as<std::uint8_t>(raw);
        case Type::I16:
            return as<std::int16_t>(raw);
        case Type::U16:
            return as<std::uint16_t>(raw);
        case Type::I32:
            return as<std::int32_t>(raw);
        case Type::U32:
            return as<std::uint32_t>(raw);
        case Type::F32:
            return as<float>(raw);
        case Type::F64:
            break;
        }
        return as<double>(raw);
    }

    TextCursor m_text;
    std::string_view m_bytes;
    Header::Format m_format;
    bool m_failed = false;
    std::size_t m_cut = 0; // numbers of the text with something behind them
};

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
    PlyParser(std::string where, std::string_view data, const Header& header, const Progress& progress)
        : m_where(std::move(where))
        , m_values(data, header.format)
        , m_progress(progress)
    {
    }

    Expected<RawMesh> parse(const Header& header)
    {
        for (const Element& element : header.elements) {
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

    Expected<void> checkpoint(const Element& element, std::size_t i)
    {
        if (m_values.failed())
            return damaged("the data end in \"" + element.name + "\" " + std::to_string(i) + " of " + std::to_string(element.count));
        if ((i & 0xffff) == 0 && m_progress.cancelled())
            return cancelled(m_where);
        return {};
    }

    // The numbers of one list; nothing when its count cannot be true.
    std::optional<std::vector<double>> list(const Property& property)
    {
        const double count = m_values.next(*property.countType);
        if (!(count >= 0) || count > double(m_values.left()))
            return std::nullopt;
        std::vector<double> numbers(static_cast<std::size_t>(count));
        for (double& number : numbers)
            number = m_values.next(property.type);
        return numbers;
    }

    tl::unexpected<Error> longList(const Element& element, std::size_t i) const
    {
        return damaged("a list of \"" + element.name + "\" " + std::to_string(i) + " claims more numbers than the file can hold");
    }

    Expected<void> readVertices(const Element& element)
    {
        if (m_hasVertices)
            return damaged("the header declares the vertices twice");
        m_hasVertices = true;
        std::array<bool, 8> present{};
        std::vector<std::optional<std::size_t>> slots;
        for (const Property& property : element.properties) {
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
    Expected<void> readFaces(const Element& element)
    {
        const bool strips = element.name == "tristrips", faces = element.name == "face" || strips;
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            std::vector<double> indices, uvs;
            for (const Property& property : element.properties) {
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
    Values m_values;
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
    const Expected<Header> header = parseHeader(*text, file.string());
    if (!header)
        return tl::unexpected(header.error());
    return PlyParser(file.string(), std::string_view(*text).substr(header->bytes), *header, progress).parse(*header);
}

} // namespace relievo
