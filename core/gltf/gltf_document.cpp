// Loading a glTF file with its buffers through tinygltf.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/gltf_document.h"
#include "core/gltf/gltf_json.h"
#include "core/gltf/gltf_uri.h"
#include "core/ground/file.h"
#include <algorithm>
#include <cstring>

namespace relievo {

namespace {

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
            return failure(ErrorCode::Unreadable, file.string(), clauseOf(errors), kDamagedGltf);
        return model;
    } catch (const std::exception& problem) {
        return failure(ErrorCode::Unreadable, file.string(), clauseOf(problem.what()), kDamagedGltf);
    }
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

bool holdsPicture(const tinygltf::Model& model, const tinygltf::Image& image)
{
    return (image.bufferView >= 0 && std::size_t(image.bufferView) < model.bufferViews.size()) || octetsOf(image.uri);
}

Expected<GltfDocument> loadGltf(const std::filesystem::path& file)
{
    Expected<PreparedGltf> prepared = preparedGltf(file);
    if (!prepared)
        return tl::unexpected(prepared.error());
    Expected<tinygltf::Model> model = loadModel(prepared->bytes, file);
    if (!model)
        return tl::unexpected(model.error());
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
            return failure(ErrorCode::Unreadable, file.string(), name + " reaches beyond its buffer", kDamagedGltf);
        return std::move(*bytes);
    }
    std::vector<unsigned char> decoded;
    std::string type;
    if (!tinygltf::DecodeDataURI(&decoded, type, *octetsOf(image.uri), 0, false))
        return failure(ErrorCode::Unreadable, file.string(), name + " is empty", kDamagedGltf);
    const auto* from = reinterpret_cast<const std::byte*>(decoded.data());
    return std::vector<std::byte>(from, from + decoded.size());
}

} // namespace relievo
