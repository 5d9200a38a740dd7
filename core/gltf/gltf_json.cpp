// What tinygltf does not check or does not read in the JSON of a glTF file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/gltf_json.h"
#include "core/gltf/gltf_extensions.h"
#include "core/gltf/gltf_uri.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/foreign_file.h"
#include "core/ground/json_depth.h"
#include "core/ground/shown_text.h"
#include "core/ground/text.h"
#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

namespace relievo {

namespace {
using Json = nlohmann::json;

// Extensions that a file may require: they are read, or say nothing about its triangles.
bool canIgnore(std::string_view name)
{
    constexpr std::string_view kHarmless[]
        = {"KHR_texture_transform", "KHR_mesh_quantization", "KHR_lights_punctual", "KHR_texture_basisu", "EXT_texture_webp",
            "EXT_texture_avif", kDracoExtension, kMeshoptExtension, "MSFT_texture_dds", "KHR_animation_pointer", "KHR_xmp_json_ld"};
    return name.starts_with("KHR_materials_") || std::ranges::find(kHarmless, name) != std::end(kHarmless);
}

// The JSON text of a .gltf or .glb, whichever the bytes are.
Expected<std::string_view> jsonTextOf(const std::string& bytes, const std::string& where)
{
    if (!bytes.starts_with("glTF"))
        return std::string_view(bytes);
    std::uint32_t header[5] = {};
    if (bytes.size() < sizeof header)
        return failure(ErrorCode::Unreadable, where, "the file ends within its header", "Copy or export it again");
    std::memcpy(header, bytes.data(), sizeof header);
    if (header[1] != 2)
        return failure(ErrorCode::Unreadable, where, "this is a binary glTF of version " + std::to_string(header[1]) + ", only 2 is read",
            "Convert it to glTF 2.0");
    const std::uint64_t jsonEnd = sizeof header + std::uint64_t(header[3]);
    std::uint32_t second[2] = {}; // length and kind of what follows the JSON
    const bool hasSecond = jsonEnd + sizeof second <= bytes.size() && jsonEnd < header[2];
    if (hasSecond)
        std::memcpy(second, bytes.data() + jsonEnd, sizeof second);
    if (header[2] > bytes.size() || (jsonEnd != header[2] && jsonEnd + sizeof second + second[0] > header[2]))
        return failure(ErrorCode::Unreadable, where, "the file is shorter than its header says", "Copy or export it again");
    return std::string_view(bytes).substr(sizeof header, header[3]);
}

// Members whose type tinygltf does not check.
enum class Kind { String, Number, Unsigned, Object };
struct MemberRow {
    std::string_view key;
    Kind kind;
};
constexpr MemberRow kMembers[] = {
    {"name", Kind::String},
    {"index", Kind::Unsigned},
    {"texCoord", Kind::Unsigned},
    {"scale", Kind::Number}, // of a normal texture; a node's is a list
    {"strength", Kind::Number},
    {"extensions", Kind::Object},
    {"pbrMetallicRoughness", Kind::Object},
    {"baseColorTexture", Kind::Object},
    {"metallicRoughnessTexture", Kind::Object},
    {"normalTexture", Kind::Object},
    {"occlusionTexture", Kind::Object},
    {"emissiveTexture", Kind::Object},
};

bool isOf(const Json& value, Kind kind)
{
    switch (kind) {
    case Kind::String:
        return value.is_string();
    case Kind::Number:
        return value.is_number() || value.is_array();
    case Kind::Unsigned:
        return value.is_number_unsigned();
    case Kind::Object:
        break;
    }
    return value.is_object();
}

// Adds the keys of the wrong type under `value`; the text was checked not to be deep.
void findWrongTypes(const Json& value, std::vector<std::string>& found)
{
    if (value.is_array())
        for (const Json& item : value)
            findWrongTypes(item, found);
    if (!value.is_object())
        return;
    for (const auto& [key, member] : value.items()) {
        const auto* row = std::ranges::find(kMembers, key, &MemberRow::key);
        bool sound = row == std::end(kMembers) || isOf(member, row->kind);
        if (sound && key == "extensions")
            sound = std::ranges::all_of(member, [](const Json& extension) { return extension.is_object(); });
        if (!sound)
            found.push_back(key);
        if (key != "extras")
            findWrongTypes(member, found);
    }
}

Warnings warningsOf(const Json& document)
{
    std::vector<std::string> wrong;
    findWrongTypes(document, wrong);
    if (wrong.empty())
        return {};
    return {{"gltf-types",
        "The file breaks the glTF rules: \"" + wrong.front() + "\" is of the wrong type"
            + (wrong.size() > 1 ? " (and " + std::to_string(wrong.size() - 1) + " more)" : std::string()) + "; it was ignored."}};
}

// The JSON of a file, with what can be told about it in better words than tinygltf's.
Expected<Json> checkedJson(std::string_view text, const std::string& where)
{
    if (isNestedTooDeep(text))
        return failure(ErrorCode::Unreadable, where, "its JSON is nested too deeply", kDamagedGltf);
    Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded() || !document.is_object())
        return failure(ErrorCode::Unreadable, where, text.empty() ? "the file is empty" : "the file is not valid JSON", kDamagedGltf);
    const auto asset = document.find("asset");
    const bool hasVersion = asset != document.end() && asset->is_object() && asset->contains("version") && (*asset)["version"].is_string();
    const std::string version = hasVersion ? (*asset)["version"].get<std::string>() : "";
    if (!version.starts_with("2."))
        return failure(ErrorCode::Unreadable, where,
            version.empty() ? "the file does not say which version of glTF it is"
                            : "this is glTF " + version.substr(0, 16) + ", only 2.0 is read",
            "Convert it to glTF 2.0");
    if (const auto required = document.find("extensionsRequired"); required != document.end() && required->is_array())
        for (const Json& name : *required)
            if (name.is_string() && !canIgnore(name.get_ref<const std::string&>()))
                return failure(ErrorCode::Unreadable, where,
                    "the file needs the extension " + shownName(name.get_ref<const std::string&>()) + ", which is not read",
                    "Export it without compression or extensions");
    return document;
}

// Takes the "images" out of a document: for one bad entry of them tinygltf would refuse the mesh.
std::vector<tinygltf::Image> takeImages(Json& document)
{
    std::vector<tinygltf::Image> images;
    const auto list = document.find("images");
    for (std::size_t i = 0; list != document.end() && list->is_array() && i < list->size(); ++i) {
        const Json& entry = (*list)[i];
        tinygltf::Image& image = images.emplace_back();
        const auto member = [&entry](const char* key) { return entry.is_object() && entry.contains(key) ? entry[key] : Json(); };
        if (const Json uri = member("uri"); uri.is_string())
            image.uri = uri.get<std::string>();
        if (const Json view = member("bufferView"); view.is_number_unsigned() && view.get<std::uint64_t>() < 0x7fffffffu)
            image.bufferView = view.get<int>();
    }
    document.erase("images");
    return images;
}

// The items of a list in a document; none where it is missing or something else.
std::vector<Json*> itemsOf(Json& object, const char* key)
{
    std::vector<Json*> items;
    if (object.is_object() && object.contains(key) && object[key].is_array())
        for (Json& item : object[key])
            items.push_back(&item);
    return items;
}

bool hasExtension(const Json& object, const char* name)
{
    const auto extensions = object.is_object() ? object.find("extensions") : object.end();
    return object.is_object() && extensions != object.end() && extensions->is_object() && extensions->contains(name);
}

// Triangles that Draco holds need no indices, and tinygltf refuses accessors of indices without bytes.
void dropDracoIndices(Json& document)
{
    for (Json* mesh : itemsOf(document, "meshes"))
        for (Json* primitive : itemsOf(*mesh, "primitives"))
            if (hasExtension(*primitive, kDracoExtension))
                primitive->erase("indices");
}

// What is compressed by meshoptimizer names a buffer that is not there, for programs that do not read it.
bool isFallback(const Json& buffer)
{
    return hasExtension(buffer, kMeshoptExtension) && !buffer.contains("uri");
}

// Gives the buffers URIs that tinygltf reads: files by the rules of pictures, data whatever their media type.
Expected<void> mendBuffers(Json& document, const std::filesystem::path& file)
{
    const auto buffers = document.find("buffers");
    for (std::size_t i = 0; buffers != document.end() && buffers->is_array() && i < buffers->size(); ++i) {
        Json& buffer = (*buffers)[i];
        if (isFallback(buffer)) {
            buffer["uri"] = "data:application/octet-stream;base64,AAAA";
            buffer["byteLength"] = 3;
        }
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string())
            continue;
        std::string& uri = buffer["uri"].get_ref<std::string&>();
        if (const std::optional<std::string> octets = octetsOf(uri))
            uri = *octets;
        else if (const auto found = findPicture({absolutePath(file).parent_path()}, percentDecoded(uri))) {
            if (std::optional<Error> foreign = foreignFile(*found); foreign && foreign->code == ErrorCode::NotFound)
                return tl::unexpected(std::move(*foreign)); // a pointer to a file that was not fetched
            uri = percentEncoded(found->string());
        } else if (uri.starts_with("data:"))
            return failure(ErrorCode::Unreadable, file.string(), "the data of a buffer are not written in base64", "Export it again");
        else if (!uri.empty())
            return failure(
                ErrorCode::NotFound, file.string(), "its buffer file " + shownName(uri) + " is not there", "Put its buffer file beside it");
    }
    return {};
}

// Puts another JSON text into the bytes of a .gltf or .glb in place of the one of `length` bytes.
void replaceJson(std::string& bytes, std::size_t length, std::string json)
{
    if (!bytes.starts_with("glTF")) {
        bytes = std::move(json);
        return;
    }
    std::uint32_t lengths[2] = {}; // of the file and of its JSON, after magic and version
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::memcpy(lengths, bytes.data() + 8, sizeof lengths);
    lengths[0] = std::uint32_t(lengths[0] + json.size() - length);
    lengths[1] = std::uint32_t(json.size());
    std::memcpy(bytes.data() + 8, lengths, sizeof lengths);
    bytes.replace(20, length, json);
}
} // namespace

Expected<PreparedGltf> preparedGltf(const std::filesystem::path& file)
{
    Expected<std::string> bytes = readText(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Expected<std::string_view> text = jsonTextOf(*bytes, file.string());
    if (!text)
        return tl::unexpected(text.error());
    Expected<Json> document = checkedJson(*text, file.string());
    if (!document)
        return tl::unexpected(document.error());
    Warnings warnings = warningsOf(*document);
    std::vector<tinygltf::Image> images = takeImages(*document);
    dropDracoIndices(*document);
    if (Expected<void> mended = mendBuffers(*document, file); !mended)
        return tl::unexpected(mended.error());
    replaceJson(*bytes, text->size(), document->dump(-1, ' ', false, Json::error_handler_t::replace));
    return PreparedGltf{std::move(*bytes), std::move(images), std::move(warnings)};
}

} // namespace relievo
