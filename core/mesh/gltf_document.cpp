// Loading a glTF file with its buffers through tinygltf, after looking at what tinygltf would stumble over.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/gltf_document.h"
#include "core/file.h"
#include <algorithm>
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
        return failure(where, "the file ends within its header", "Copy or export it again");
    std::memcpy(header, bytes.data(), sizeof header);
    if (header[1] != 2)
        return failure(
            where, "this is a binary glTF of version " + std::to_string(header[1]) + ", only 2 is read", "Convert it to glTF 2.0");
    if (header[2] > bytes.size() || header[3] > bytes.size() - sizeof header)
        return failure(where, "the file is shorter than its header says", "Copy or export it again");
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

// What can be told about a file in better words before its buffers are read.
Expected<Warnings> checkDocument(std::string_view text, const std::string& where)
{
    if (isTooDeep(text))
        return failure(where, "its JSON is nested too deeply", kDamaged);
    const Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded() || !document.is_object())
        return failure(where, text.empty() ? "the file is empty" : "the file is not valid JSON", kDamaged);
    const auto asset = document.find("asset");
    const bool hasVersion = asset != document.end() && asset->is_object() && asset->contains("version") && (*asset)["version"].is_string();
    const std::string version = hasVersion ? (*asset)["version"].get<std::string>() : "";
    if (!version.starts_with("2."))
        return failure(where,
            version.empty() ? "the file does not say which version of glTF it is"
                            : "this is glTF " + version.substr(0, 16) + ", only 2.0 is read",
            "Convert it to glTF 2.0");
    if (const auto required = document.find("extensionsRequired"); required != document.end() && required->is_array())
        for (const Json& name : *required)
            if (name.is_string() && !canIgnore(name.get_ref<const std::string&>()))
                return failure(where, "the file needs the extension " + name.get<std::string>() + ", which is not read",
                    "Export it without compression or extensions");
    return warningsOf(document);
}

tinygltf::FsCallbacks fileCallbacks()
{
    // Pictures of the file are not wanted: they count as missing, which tinygltf takes lightly.
    const auto isPicture = [](const std::string& name) {
        const std::string suffix = std::filesystem::path(name).extension().string();
        return suffix == ".png" || suffix == ".jpg" || suffix == ".jpeg" || suffix == ".ktx2" || suffix == ".webp" || suffix == ".dds";
    };
    static const auto picture = isPicture;
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = [](const std::string& name, void*) {
        std::error_code code;
        return !picture(name) && std::filesystem::is_regular_file(name, code);
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
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    return text.empty() ? "the file is damaged" : "the file is damaged (" + text + ')';
}

// A picture that is written into the JSON text, kept while the model is read.
struct KeptPicture {
    int number = -1;
    std::vector<std::byte> bytes;
};

bool keepPicture(tinygltf::Image* image, int number, std::string*, std::string*, int, int, const unsigned char* data, int size, void* user)
{
    KeptPicture* kept = static_cast<KeptPicture*>(user);
    // Data that lie in a buffer were not checked to lie within it: they are taken from there later.
    if (kept && kept->number == number && image->bufferView < 0 && data && size > 0) {
        kept->bytes.resize(std::size_t(size));
        std::memcpy(kept->bytes.data(), data, std::size_t(size));
    }
    return true;
}

Expected<tinygltf::Model> loadModel(const std::string& bytes, const std::filesystem::path& file, KeptPicture* kept = nullptr)
{
    try {
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader(keepPicture, kept);
        loader.SetFsCallbacks(fileCallbacks());
        tinygltf::Model model;
        std::string errors, warnings;
        const std::string folder = file.parent_path().string();
        const bool done = bytes.starts_with("glTF")
            ? loader.LoadBinaryFromMemory(
                &model, &errors, &warnings, reinterpret_cast<const unsigned char*>(bytes.data()), unsigned(bytes.size()), folder)
            : loader.LoadASCIIFromString(&model, &errors, &warnings, bytes.data(), unsigned(bytes.size()), folder);
        if (!done)
            return failure(file.string(), clauseOf(errors),
                errors.find("File not found") != errors.npos || errors.find("read external") != errors.npos
                    ? "Put its buffer file beside it"
                    : kDamaged);
        return model;
    } catch (const std::exception& problem) {
        return failure(file.string(), clauseOf(problem.what()), kDamaged);
    }
}

struct CheckedFile {
    std::string bytes;
    Warnings warnings;
};
Expected<CheckedFile> checkedFile(const std::filesystem::path& file)
{
    Expected<std::string> bytes = readText(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Expected<std::string_view> text = jsonTextOf(*bytes, file.string());
    if (!text)
        return tl::unexpected(text.error());
    Expected<Warnings> warnings = checkDocument(*text, file.string());
    if (!warnings)
        return tl::unexpected(warnings.error());
    return CheckedFile{std::move(*bytes), std::move(*warnings)};
}
} // namespace

Expected<GltfDocument> loadGltf(const std::filesystem::path& file)
{
    Expected<CheckedFile> checked = checkedFile(file);
    if (!checked)
        return tl::unexpected(checked.error());
    Expected<tinygltf::Model> model = loadModel(checked->bytes, file);
    if (!model) {
        for (const char* compression : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
            if (checked->bytes.find(compression) != std::string::npos)
                return failure(file.string(), std::string("its triangles are compressed by ") + compression + ", which is not read",
                    "Export it without compression");
        return tl::unexpected(model.error());
    }
    return GltfDocument{std::move(*model), std::move(checked->warnings)};
}

Expected<std::vector<std::byte>> loadGltfPicture(const std::filesystem::path& file, int picture)
{
    const Expected<CheckedFile> checked = checkedFile(file);
    if (!checked)
        return tl::unexpected(checked.error());
    KeptPicture kept{picture, {}};
    const Expected<tinygltf::Model> model = loadModel(checked->bytes, file, &kept);
    if (!model)
        return tl::unexpected(model.error());
    const std::string name = "the picture " + std::to_string(picture);
    if (picture < 0 || std::size_t(picture) >= model->images.size())
        return failure(file.string(), name + " is not in the file", "Open the mesh again");
    if (!kept.bytes.empty())
        return std::move(kept.bytes);
    const int view = model->images[std::size_t(picture)].bufferView;
    if (view < 0 || std::size_t(view) >= model->bufferViews.size())
        return failure(file.string(), name + " is not inside the file", "Open the picture itself");
    const tinygltf::BufferView& span = model->bufferViews[std::size_t(view)];
    const bool hasBuffer = span.buffer >= 0 && std::size_t(span.buffer) < model->buffers.size();
    if (!hasBuffer || span.byteOffset > model->buffers[std::size_t(span.buffer)].data.size()
        || span.byteLength > model->buffers[std::size_t(span.buffer)].data.size() - span.byteOffset)
        return failure(file.string(), name + " reaches beyond its buffer", kDamaged);
    const auto* from = reinterpret_cast<const std::byte*>(model->buffers[std::size_t(span.buffer)].data.data()) + span.byteOffset;
    return std::vector<std::byte>(from, from + span.byteLength);
}

} // namespace relievo
