// Godot's text resources (.tres, formats 2 and 3).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/materials/material_fields.h"
#include <cctype>

namespace relievo {
namespace {

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

// "\"a \\\"b\\\"\"" without its quotes; other texts as they are.
std::string unquoted(std::string_view text)
{
    text = trimmed(text);
    if (text.size() < 2 || text.front() != '"' || text.back() != '"')
        return std::string(text);
    std::string plain;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] == '\\' && i + 2 < text.size())
            ++i;
        plain += text[i];
    }
    return plain;
}

// The length of the text up to `end` outside of quotes, all of it where there is none.
std::size_t lengthUntil(std::string_view text, std::string_view ends)
{
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quoted && text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            quoted = !quoted;
        else if (!quoted && ends.find(text[i]) != std::string_view::npos)
            return i;
    }
    return text.size();
}

// One "[tag key=value key="value"]" and the assignments below it.
struct Section {
    std::string_view tag;
    MaterialFields attributes;
};

Section sectionOf(std::string_view line)
{
    line = line.substr(1, line.rfind(']') - 1);
    Section section{line.substr(0, lengthUntil(line, " ")), {}};
    line.remove_prefix(section.tag.size());
    while (!(line = trimmed(line)).empty()) {
        const std::size_t equals = lengthUntil(line, "=");
        if (equals == line.size())
            break;
        const std::string_view rest = line.substr(equals + 1), value = rest.substr(0, lengthUntil(rest, " "));
        section.attributes[std::string(trimmed(line.substr(0, equals)))] = unquoted(value);
        line = rest.substr(value.size());
    }
    return section;
}

// The arguments of "Vector3( 1, 2, 3 )".
std::vector<std::string> argumentsOf(std::string_view value)
{
    std::vector<std::string> arguments;
    const std::size_t open = value.find('(');
    std::string_view rest = open == std::string_view::npos ? "" : value.substr(open + 1, value.rfind(')') - open - 1);
    while (!rest.empty()) {
        const std::size_t length = lengthUntil(rest, ",");
        arguments.push_back(unquoted(rest.substr(0, length)));
        rest.remove_prefix(std::min(length + 1, rest.size()));
    }
    return arguments;
}

void take(MaterialFields& fields, const MaterialFields& pictures, std::string_view key, std::string_view value)
{
    const std::vector<std::string> arguments = argumentsOf(value);
    if (value.starts_with("ExtResource")) {
        if (const auto found = arguments.empty() ? pictures.end() : pictures.find(arguments.front()); found != pictures.end())
            fields[std::string(key)] = found->second;
    } else if (value.starts_with("Vector") || value.starts_with("Color")) {
        for (std::size_t i = 0; i < arguments.size(); ++i)
            fields[std::string(key) + '.' + std::to_string(i)] = arguments[i];
    } else {
        fields[std::string(key)] = unquoted(value);
    }
}
} // namespace

Expected<MaterialFields> readGodotMaterial(std::string_view text, const std::filesystem::path& file)
{
    MaterialFields fields, pictures; // the latter by id
    bool isMaterial = false;
    while (!text.empty()) {
        const std::size_t length = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, length));
        text.remove_prefix(length == std::string_view::npos ? text.size() : length + 1);
        if (line.starts_with('[') && line.ends_with(']')) {
            Section section = sectionOf(line);
            isMaterial = section.tag == "resource";
            if (section.tag == "gd_resource")
                fields["$type"] = section.attributes["type"];
            if (section.tag == "ext_resource")
                pictures[section.attributes["id"]] = section.attributes["path"];
        } else if (const std::size_t equals = line.find('='); isMaterial && equals != std::string_view::npos) {
            take(fields, pictures, trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
        }
    }
    if (!fields.contains("$type"))
        return failure(ErrorCode::Unreadable, file.string(), "this is no text resource of Godot", "Save the material as .tres in Godot");
    fields["$name"] = fields["resource_name"];
    return fields;
}

} // namespace relievo
