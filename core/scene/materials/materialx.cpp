// MaterialX documents: the pictures that a surface shader and a displacement read, and what is done to them on the way.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/materials/material_fields.h"
#include <cstdlib>
#include <cstring>
#include <pugixml.hpp>

namespace relievo {
namespace {
using pugi::xml_node;
constexpr int kLongestPath = 64; // nodes between a shader's input and a picture

xml_node child(xml_node parent, const char* attribute, const char* value)
{
    return *value ? parent.find_child_by_attribute(attribute, value) : xml_node();
}
xml_node input(xml_node node, const char* name)
{
    return node.find_child(
        [name](xml_node c) { return !std::strcmp(c.name(), "input") && !std::strcmp(c.attribute("name").value(), name); });
}

// The node that an input is connected to: beside it, or behind an output of a node graph.
xml_node source(xml_node document, xml_node from)
{
    xml_node graph = from.parent().parent();
    if (const char* name = from.attribute("nodegraph").value(); *name) {
        graph = child(document, "name", name);
        const char* output = from.attribute("output").value();
        const xml_node out = graph.find_child([output](xml_node c) {
            return !std::strcmp(c.name(), "output") && (!*output || !std::strcmp(c.attribute("name").value(), output));
        });
        return child(graph, "name", out.attribute("nodename").value());
    }
    return child(graph, "name", from.attribute("nodename").value());
}

std::string prefixOf(xml_node node)
{
    std::string prefix;
    for (; node; node = node.parent())
        prefix = node.attribute("fileprefix").value() + prefix;
    return prefix;
}

// "0.5, 1" as KEY.0 and KEY.1
void takeList(MaterialFields& fields, const std::string& key, const char* text)
{
    char* end = nullptr;
    for (int i = 0; i < 4; ++i) {
        text += std::strspn(text, " ");
        std::strtod(text, &end);
        if (end == text)
            return;
        fields[key + '.' + std::to_string(i)] = std::string_view(text, std::size_t(end - text));
        text = end + std::strspn(end, ", ");
    }
}

// How a picture lies on the mesh: uv x tiling, turned, moved; or what tiledimage and place2d hold themselves.
void takePlace(MaterialFields& fields, xml_node document, xml_node image)
{
    if (const xml_node tiling = input(image, "uvtiling"))
        takeList(fields, "place.tiling", tiling.attribute("value").value());
    if (const xml_node wrap = input(image, "uaddressmode"))
        fields["place.wrap"] = wrap.attribute("value").value();
    xml_node from = input(image, "texcoord");
    for (int i = 0; i < kLongestPath && from; ++i) {
        const xml_node node = source(document, from);
        const std::string kind = node.name();
        if (kind == "multiply")
            takeList(fields, "place.tiling", input(node, "in2").attribute("value").value());
        else if (kind == "rotate2d")
            fields["place.turn"] = input(node, "amount").attribute("value").value();
        else if (kind == "add")
            takeList(fields, "place.offset", input(node, "in2").attribute("value").value());
        else if (kind == "place2d")
            takeList(fields, "place.scale", input(node, "scale").attribute("value").value());
        from = input(node, kind == "multiply" || kind == "add" ? "in1" : kind == "place2d" ? "texcoord" : "in");
    }
}

// Follows an input to its picture; numbers on the way are kept.
void follow(MaterialFields& fields, xml_node document, const std::string& key, xml_node from)
{
    if (const char* value = from.attribute("value").value(); *value) {
        takeList(fields, key + ".times", value); // of nothing
        return;
    }
    for (int i = 0; i < kLongestPath && from; ++i) {
        const xml_node node = source(document, from);
        const std::string kind = node.name();
        if (const xml_node picture = input(node, "file")) {
            fields[key] = prefixOf(picture) + picture.attribute("value").value();
            takePlace(fields, document, node);
            return;
        }
        const char* constant = input(node, "in2").attribute("value").value();
        if (kind == "multiply")
            takeList(fields, key + ".times", constant);
        else if (kind == "subtract")
            fields[key + ".minus"] = constant;
        else if (kind == "normalmap")
            fields[key + ".scale"] = input(node, "scale").attribute("value").value();
        from = input(node, kind == "multiply" || kind == "subtract" || kind == "add" || kind == "divide" ? "in1" : "in");
    }
}

xml_node shader(xml_node document, const char* type)
{
    if (const xml_node material = document.child("surfacematerial")) {
        const std::string wanted = type;
        for (const xml_node in : material.children("input"))
            if (wanted == in.attribute("type").value())
                if (const xml_node found = child(document, "name", in.attribute("nodename").value()))
                    return found;
    }
    return child(document, "type", type);
}
} // namespace

Expected<MaterialFields> readMaterialX(std::string_view text, const std::filesystem::path& file)
{
    pugi::xml_document xml;
    const bool parsed = bool(xml.load_buffer(text.data(), text.size()));
    const xml_node document = xml.child("materialx"), surface = shader(document, "surfaceshader");
    if (!parsed || !document)
        return failure(ErrorCode::Unreadable, file.string(), "this is no MaterialX document that can be read", "Export it again");
    MaterialFields fields;
    fields["$type"] = "materialx";
    for (const xml_node in : surface.children("input"))
        follow(fields, document, in.attribute("name").value(), in);
    const xml_node displacement = shader(document, "displacementshader");
    for (const xml_node in : displacement.children("input"))
        follow(
            fields, document, std::strcmp(in.attribute("name").value(), "scale") ? in.attribute("name").value() : "displacement.scale", in);
    return fields;
}

} // namespace relievo
