// Unity's materials (.mat) and the .meta files that tell which picture a GUID is.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/ground/text.h"
#include "core/scene/materials/material_fields.h"
#include <set>
#include <utility>
#include <yaml.h>

namespace relievo {
namespace fs = std::filesystem;

namespace {
constexpr std::size_t kLargestMeta = 1 << 20; // bytes
constexpr int kMostMetas = 50000; // files that are looked into

// One document of a YAML text, freed with it.
class Yaml {
public:
    explicit Yaml(std::string_view text)
    {
        yaml_parser_initialize(&m_parser);
        yaml_parser_set_input_string(&m_parser, reinterpret_cast<const unsigned char*>(text.data()), text.size());
    }
    ~Yaml()
    {
        if (m_loaded)
            yaml_document_delete(&m_document);
        yaml_parser_delete(&m_parser);
    }
    Yaml(const Yaml&) = delete;
    // The next document's root; nothing at the end, or where the text is no YAML.
    yaml_node_t* next()
    {
        if (std::exchange(m_loaded, false))
            yaml_document_delete(&m_document);
        m_loaded = yaml_parser_load(&m_parser, &m_document) == 1;
        return m_loaded ? yaml_document_get_root_node(&m_document) : nullptr;
    }
    yaml_document_t* document() { return &m_document; }

private:
    yaml_parser_t m_parser;
    yaml_document_t m_document;
    bool m_loaded = false;
};

// A node that may be missing or of another kind than asked for.
struct Node {
    yaml_document_t* document;
    yaml_node_t* node;

    bool isMap() const { return node && node->type == YAML_MAPPING_NODE; }
    std::string text() const
    {
        return node && node->type == YAML_SCALAR_NODE
            ? std::string(reinterpret_cast<const char*>(node->data.scalar.value), node->data.scalar.length)
            : std::string();
    }
    template <class Take> void eachMember(Take&& take) const // take(key, value)
    {
        if (isMap())
            for (const yaml_node_pair_t* pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; ++pair)
                take(Node{document, yaml_document_get_node(document, pair->key)}.text(),
                    Node{document, yaml_document_get_node(document, pair->value)});
    }
    template <class Take> void eachItem(Take&& take) const
    {
        if (node && node->type == YAML_SEQUENCE_NODE)
            for (const yaml_node_item_t* item = node->data.sequence.items.start; item < node->data.sequence.items.top; ++item)
                take(Node{document, yaml_document_get_node(document, *item)});
    }
    Node operator[](std::string_view key) const
    {
        Node found{document, nullptr};
        eachMember([&](const std::string& name, Node value) { found = name == key ? value : found; });
        return found;
    }
};

// "guid: 0123..." of a .meta file.
std::string guidIn(const fs::path& meta)
{
    const Expected<std::string> text = readText(meta, kLargestMeta);
    const std::size_t at = text ? text->find("guid:") : std::string::npos;
    if (at == std::string::npos)
        return {};
    const std::size_t from = text->find_first_not_of(' ', at + 5);
    return from == std::string::npos ? "" : text->substr(from, text->find_first_of(" \r\n", from) - from);
}

// The files of these GUIDs: in the material's folder, then in all of the project's Assets.
std::map<std::string, std::string> filesOf(std::set<std::string> guids, const fs::path& material)
{
    std::map<std::string, std::string> files;
    int looked = 0;
    const auto look = [&](const fs::path& meta) {
        if (lowerSuffix(meta) != ".meta" || ++looked > kMostMetas)
            return;
        if (const auto found = guids.find(guidIn(meta)); found != guids.end()) {
            files[*found] = fs::path(meta).replace_extension().string();
            guids.erase(found);
        }
    };
    std::error_code code;
    for (fs::directory_iterator entry(material.parent_path(), code), end; !code && entry != end && !guids.empty(); entry.increment(code))
        look(entry->path());
    fs::path root = material.parent_path();
    while (root.filename() != "Assets" && root.has_relative_path())
        root = root.parent_path();
    if (!root.has_relative_path())
        return files;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(root, options, code), end; !code && entry != end && !guids.empty() && looked <= kMostMetas;
         entry.increment(code))
        look(entry->path());
    return files;
}

// Properties are lists of maps with one member each, or in old files of {first: {name: KEY}, second: VALUE}.
template <class Take> void eachProperty(Node list, Take&& take)
{
    list.eachItem([&](Node entry) {
        const Node first = entry["first"];
        if (first.node)
            take(first.isMap() ? first["name"].text() : first.text(), entry["second"]);
        else
            entry.eachMember(take);
    });
}

void takeTextures(MaterialFields& fields, Node saved, const fs::path& file)
{
    std::map<std::string, std::string> guids; // by property
    eachProperty(saved["m_TexEnvs"], [&](const std::string& key, Node value) {
        if (const std::string guid = value["m_Texture"]["guid"].text(); !guid.empty())
            guids[key] = guid;
        for (const char* member : {"m_Scale", "m_Offset"})
            for (const char* axis : {"x", "y"})
                fields[key + '.' + member + '.' + axis] = value[member][axis].text();
    });
    std::set<std::string> wanted;
    for (const auto& [key, guid] : guids)
        wanted.insert(guid);
    const auto files = filesOf(wanted, file);
    for (const auto& [key, guid] : guids) {
        const auto found = files.find(guid);
        fields[key] = found == files.end() ? "GUID " + guid : found->second;
    }
}

MaterialFields fieldsOf(Node material, const fs::path& file)
{
    MaterialFields fields;
    fields["$name"] = material["m_Name"].text();
    const Node shader = material["m_Shader"];
    const std::string id = shader["fileID"].text();
    fields["$type"] = id == "4800000" ? shader["guid"].text() : id; // that number: the shader is a file
    const Node saved = material["m_SavedProperties"];
    takeTextures(fields, saved, file);
    for (const char* list : {"m_Floats", "m_Ints"})
        eachProperty(saved[list], [&](const std::string& key, Node value) { fields[key] = value.text(); });
    eachProperty(saved["m_Colors"], [&](const std::string& key, Node value) {
        for (const char* channel : {"r", "g", "b"})
            fields[key + '.' + channel] = value[channel].text();
    });
    return fields;
}
} // namespace

Expected<MaterialFields> readUnityMaterial(std::string_view text, const fs::path& file)
{
    Yaml yaml(text);
    while (yaml_node_t* root = yaml.next())
        if (const Node material = Node{yaml.document(), root}["Material"]; material.isMap())
            return fieldsOf(material, file);
    return failure(ErrorCode::Unreadable, file.string(), "this is no material of Unity in text form",
        "In Unity: Project Settings, Editor, Asset Serialization, Force Text");
}

} // namespace relievo
