// Elements and properties of a PLY file, line by line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/ply_header.h"
#include "core/ground/text_cursor.h"

namespace relievo {

namespace {
struct TypeRow {
    std::string_view name;
    PlyType type;
};
constexpr TypeRow kTypes[] = {{"char", PlyType::I8}, {"int8", PlyType::I8}, {"uchar", PlyType::U8}, {"uint8", PlyType::U8},
    {"short", PlyType::I16}, {"int16", PlyType::I16}, {"ushort", PlyType::U16}, {"uint16", PlyType::U16}, {"int", PlyType::I32},
    {"int32", PlyType::I32}, {"uint", PlyType::U32}, {"uint32", PlyType::U32}, {"float", PlyType::F32}, {"float32", PlyType::F32},
    {"double", PlyType::F64}, {"float64", PlyType::F64}};

std::optional<PlyType> typeNamed(std::string_view name)
{
    for (const TypeRow& row : kTypes)
        if (row.name == name)
            return row.type;
    return std::nullopt;
}
} // namespace

Expected<PlyHeader> parsePlyHeader(std::string_view text, const std::string& where)
{
    const auto damaged
        = [&where](std::string what) { return failure(ErrorCode::Unreadable, where, std::move(what), "Export the file again"); };
    TextCursor lines(text);
    PlyHeader header;
    bool hasFormat = false;
    if (TextCursor(lines.line().value_or("")).word() != "ply")
        return damaged("this is no PLY file: its first line is not \"ply\"");
    while (const std::optional<std::string_view> line = lines.line()) {
        TextCursor words(*line);
        const std::string_view keyword = words.word();
        if (keyword == "end_header") {
            header.bytes = text.size() - lines.rest().size();
            return hasFormat ? Expected<PlyHeader>(header) : damaged("the header does not name the format");
        }
        if (keyword == "format") {
            const std::string_view name = words.word();
            hasFormat = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
            if (!hasFormat)
                return damaged("the header names an unknown format");
            header.format = name == "ascii"       ? PlyHeader::Format::Text
                : name.ends_with("little_endian") ? PlyHeader::Format::Little
                                                  : PlyHeader::Format::Big;
        } else if (keyword == "element") {
            const std::string name(words.word());
            const std::optional<long long> count = integerOf(words.word());
            if (!count || *count < 0)
                return damaged("the header does not count the element \"" + name + '"');
            header.elements.push_back({name, std::size_t(*count), {}});
        } else if (keyword == "property") {
            std::string_view type = words.word();
            PlyProperty property;
            if (type == "list") {
                property.countType = typeNamed(words.word());
                type = words.word();
                if (!property.countType || *property.countType >= PlyType::F32)
                    return damaged("a list in the header has no type of count that is known");
            }
            const std::optional<PlyType> known = typeNamed(type);
            if (!known || header.elements.empty())
                return damaged("the header holds a property of unknown type");
            property.type = *known;
            property.name = words.word();
            header.elements.back().properties.push_back(std::move(property));
        }
    }
    return damaged("the header does not end");
}

} // namespace relievo
