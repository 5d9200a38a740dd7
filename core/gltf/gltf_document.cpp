// Loading a glTF file with its buffers through tinygltf, after looking at what tinygltf would stumble over.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/gltf_document.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/text.h"
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

namespace relievo {

namespace {
using Json = nlohmann::json;
const char* const kDamaged = "Check the file with a glTF validator and export it again";

// Extensions that a file may require although they say nothing about its triangles.
bool canIgnore(std::string_view name)
{
    constexpr std::string_view kHarmless[] = {"KHR_texture_transform", "KHR_mesh_quantization", "KHR_lights_punctual", "KHR_texture_basisu",
        "EXT_texture_webp", "EXT_texture_avif", "MSFT_texture_dds", "KHR_animation_pointer", "KHR_xmp_json_ld"};
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

// tinygltf reads nested values by recursion: no honest file is deep.
bool isTooDeep(std::string_view json)
{
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (inString) {
            if (json[i] == '\\')
                ++i; // whatever follows is part of the string
            else if (json[i] == '"')
                inString = false;
        } else if (json[i] == '"') {
            inString = true;
        } else if (json[i] == '{' || json[i] == '[') {
            if (++depth > 256)
                return true;
        } else if (json[i] == '}' || json[i] == ']') {
            --depth;
        }
    }
    return false;
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
    if (isTooDeep(text))
        return failure(ErrorCode::Unreadable, where, "its JSON is nested too deeply", kDamaged);
    Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded() || !document.is_object())
        return failure(ErrorCode::Unreadable, where, text.empty() ? "the file is empty" : "the file is not valid JSON", kDamaged);
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
                    "the file needs the extension " + name.get<std::string>() + ", which is not read",
                    "Export it without compression or extensions");
    return document;
}

// Base64 data under the one media type that tinygltf knows for everything; nothing for any other URI.
std::optional<std::string> octetsOf(const std::string& uri)
{
    const std::size_t comma = std::min(uri.find(','), uri.size());
    const std::string head = lowered(std::string_view(uri).substr(0, comma));
    if (!head.starts_with("data:") || !head.ends_with(";base64"))
        return std::nullopt;
    return "data:application/octet-stream;base64" + uri.substr(comma);
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

// So that tinygltf finds a file of any name: it decodes this again.
std::string percentEncoded(const std::string& name)
{
    std::string uri;
    for (const char c : name) {
        char digits[4];
        std::snprintf(digits, sizeof digits, "%%%02X", unsigned(static_cast<unsigned char>(c)));
        uri += digits;
    }
    return uri;
}

// Gives the buffers URIs that tinygltf reads: files by the rules of pictures, data whatever their media type.
Expected<void> mendBuffers(Json& document, const std::filesystem::path& file)
{
    const auto buffers = document.find("buffers");
    for (std::size_t i = 0; buffers != document.end() && buffers->is_array() && i < buffers->size(); ++i) {
        Json& buffer = (*buffers)[i];
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string())
            continue;
        std::string& uri = buffer["uri"].get_ref<std::string&>();
        if (const std::optional<std::string> octets = octetsOf(uri))
            uri = *octets;
        else if (const auto found = findPicture({absolutePath(file).parent_path()}, percentDecoded(uri)))
            uri = percentEncoded(found->string());
        else if (uri.starts_with("data:"))
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

tinygltf::FsCallbacks fileCallbacks()
{
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = [](const std::string& name, void*) {
        std::error_code code;
        return std::filesystem::is_regular_file(name, code);
    };
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name, void*) {
        const Expected<std::vector<std::byte>> bytes = readBytes(name, std::size_t(2) << 30);
        if (!bytes)
            return false;
        out->resize(bytes->size());
        if (!bytes->empty())
            std::memcpy(out->data(), bytes->data(), bytes->size());
        return true;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
    return callbacks;
}

// The first line of what tinygltf says, as a clause.
std::string clauseOf(std::string text)
{
    text = text.substr(0, text.find('\n')).substr(0, 200);
    if (const std::size_t data = text.find("data:"); data != text.npos)
        text.resize(std::min(text.size(), data + 80)); // the rest is a buffer's contents
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    return text.empty() ? "the file is damaged" : "the file is damaged (" + text + ')';
}

Expected<tinygltf::Model> loadModel(const std::string& bytes, const std::filesystem::path& file)
{
    try {
        tinygltf::TinyGLTF loader;
        loader.SetFsCallbacks(fileCallbacks());
        tinygltf::Model model;
        std::string errors, warnings;
        const bool done = bytes.starts_with("glTF")
            ? loader.LoadBinaryFromMemory(
                &model, &errors, &warnings, reinterpret_cast<const unsigned char*>(bytes.data()), unsigned(bytes.size()), "")
            : loader.LoadASCIIFromString(&model, &errors, &warnings, bytes.data(), unsigned(bytes.size()), "");
        if (!done)
            return failure(ErrorCode::Unreadable, file.string(), clauseOf(errors), kDamaged);
        return model;
    } catch (const std::exception& problem) {
        return failure(ErrorCode::Unreadable, file.string(), clauseOf(problem.what()), kDamaged);
    }
}

struct PreparedFile {
    std::string bytes; // for tinygltf
    std::vector<tinygltf::Image> images;
    Warnings warnings;
};
Expected<PreparedFile> preparedFile(const std::filesystem::path& file)
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
    if (Expected<void> mended = mendBuffers(*document, file); !mended)
        return tl::unexpected(mended.error());
    replaceJson(*bytes, text->size(), document->dump(-1, ' ', false, Json::error_handler_t::replace));
    return PreparedFile{std::move(*bytes), std::move(images), std::move(warnings)};
}

// The bytes of a buffer view, when it lies within its buffer.
std::optional<std::vector<std::byte>> bytesOf(const tinygltf::Model& model, const tinygltf::BufferView& view)
{
    if (view.buffer < 0 || std::size_t(view.buffer) >= model.buffers.size())
        return std::nullopt;
    const std::vector<unsigned char>& buffer = model.buffers[std::size_t(view.buffer)].data;
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
        return std::nullopt;
    const auto* from = reinterpret_cast<const std::byte*>(buffer.data()) + view.byteOffset;
    return std::vector<std::byte>(from, from + view.byteLength);
}
} // namespace

std::string percentDecoded(const std::string& uri)
{
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        int byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += char(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

bool holdsPicture(const tinygltf::Model& model, const tinygltf::Image& image)
{
    return (image.bufferView >= 0 && std::size_t(image.bufferView) < model.bufferViews.size()) || octetsOf(image.uri);
}

Expected<GltfDocument> loadGltf(const std::filesystem::path& file)
{
    Expected<PreparedFile> prepared = preparedFile(file);
    if (!prepared)
        return tl::unexpected(prepared.error());
    Expected<tinygltf::Model> model = loadModel(prepared->bytes, file);
    if (!model) {
        for (const char* compression : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
            if (prepared->bytes.find(compression) != std::string::npos)
                return failure(ErrorCode::Unreadable, file.string(),
                    std::string("its triangles are compressed by ") + compression + ", which is not read", "Export it without compression");
        return tl::unexpected(model.error());
    }
    model->images = std::move(prepared->images);
    return GltfDocument{std::move(*model), std::move(prepared->warnings)};
}

Expected<std::vector<std::byte>> loadGltfPicture(const std::filesystem::path& file, int picture)
{
    const Expected<GltfDocument> document = loadGltf(file);
    if (!document)
        return tl::unexpected(document.error());
    const tinygltf::Model& model = document->model;
    const std::string name = "the picture " + std::to_string(picture);
    if (picture < 0 || std::size_t(picture) >= model.images.size())
        return failure(ErrorCode::NotFound, file.string(), name + " is not in the file", "Open the mesh again");
    const tinygltf::Image& image = model.images[std::size_t(picture)];
    if (!holdsPicture(model, image))
        return failure(ErrorCode::Unreadable, file.string(), name + " is not inside the file", "Open the picture itself");
    if (image.bufferView >= 0 && std::size_t(image.bufferView) < model.bufferViews.size()) {
        std::optional<std::vector<std::byte>> bytes = bytesOf(model, model.bufferViews[std::size_t(image.bufferView)]);
        if (!bytes)
            return failure(ErrorCode::Unreadable, file.string(), name + " reaches beyond its buffer", kDamaged);
        return std::move(*bytes);
    }
    std::vector<unsigned char> decoded;
    std::string type;
    if (!tinygltf::DecodeDataURI(&decoded, type, *octetsOf(image.uri), 0, false))
        return failure(ErrorCode::Unreadable, file.string(), name + " is empty", kDamaged);
    const auto* from = reinterpret_cast<const std::byte*>(decoded.data());
    return std::vector<std::byte>(from, from + decoded.size());
}

} // namespace relievo
