// Image files by way of the helper processes: what is asked, and what comes of the replies.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/image_file.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/foreign_file.h"
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include "core/image/files/helper_requests.h"
#include <algorithm>
#include <array>
#include <bit>
#include <fstream>

namespace relievo {
namespace fs = std::filesystem;
using namespace imageio;

namespace {
// The usual mistakes, told without a helper.
Expected<void> checkReadable(const fs::path& file)
{
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status))
        return failure(ErrorCode::NotFound, file.string(), "there is no such file", "Check the path");
    if (fs::is_directory(status))
        return failure(ErrorCode::Unreadable, file.string(), "this is a folder, not an image", "Name a file in it");
    if (!fs::is_regular_file(status))
        return failure(ErrorCode::Unreadable, file.string(), "this is not a regular file", "Name an image file");
    if (!std::ifstream(file, std::ios::binary))
        return failure(ErrorCode::Unreadable, file.string(), "the file cannot be read", "Check its permissions");
    if (std::optional<Error> foreign = foreignFile(file))
        return tl::unexpected(std::move(*foreign));
    return {};
}

ImageInfo infoOf(const Reply& reply)
{
    const HeaderReply& header = reply.header;
    return {int(header.fileWidth), int(header.fileHeight), int(header.fileChannels), int(header.storedBits), header.storedFloat != 0,
        reply.layers};
}

Expected<ImageRead> imageOf(Expected<Reply> reply, const std::string& where)
{
    if (!reply)
        return tl::unexpected(reply.error());
    const HeaderReply& header = reply->header;
    ImageRead read;
    read.image = {int(header.width), int(header.height), int(header.channels), PixelType(header.type), int(header.storedBits),
        header.storedFloat != 0, std::move(reply->data)};
    read.image.storedMaximum = double(header.storedMaximum);
    if (header.hasSurvey != 0)
        read.image.survey = Survey{std::bit_cast<double>(header.texelWidth) * double(header.fileWidth) / double(header.width),
            std::bit_cast<double>(header.metres),
            header.hasNoData != 0 ? std::optional(std::bit_cast<double>(header.noData)) : std::nullopt};
    read.warnings = std::move(reply->warnings);
    if (read.image.data.empty()
        || read.image.data.size() != read.image.texelCount() * std::size_t(read.image.channels) * bytesOf(read.image.type))
        return failure(
            ErrorCode::Unreadable, where, "the image library returned too few pixels", "The file is probably damaged: export it again");
    for (Warning& warning : read.warnings)
        warning.text = fs::path(where).filename().string() + ": " + warning.text;
    return read;
}

// The packet holds the absolute path: the helper keeps the folder it was started in.
PacketWriter pathPacket(const NamedLayer& layer)
{
    std::error_code code;
    PacketWriter packet;
    packet.put(fs::absolute(layer.file, code).string());
    packet.put(layer.layer);
    return packet;
}

NamedLayer fileAndLayer(const fs::path& file)
{
    NamedLayer named = layerOf(file).value_or(NamedLayer{file, ""});
    named.file = thatLooksLike(named.file).value_or(named.file);
    return named;
}

PacketWriter bytesPacket(Payload bytes, const std::string& name)
{
    PacketWriter packet;
    packet.put(name);
    packet.put(std::uint64_t(bytes.size()));
    return packet;
}

Expected<std::vector<std::byte>> encode(const WriteRequest& request, Payload pixels, const std::string& where)
{
    PacketWriter packet;
    packet.put(request.suffix);
    for (const std::uint64_t number : {request.width, request.height, request.channels, request.type, request.srgb})
        packet.put(number);
    packet.put(request.channelNames);
    Expected<Reply> reply = ask(Message::Write, packet, pixels, where, {});
    if (!reply)
        return tl::unexpected(reply.error());
    return std::move(reply->data);
}

Expected<std::vector<std::byte>> encode(const Image& image, bool srgb, const std::string& suffix, const std::string& where)
{
    const std::size_t bytes = image.texelCount() * std::size_t(image.channels) * bytesOf(image.type);
    if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4 || image.data.size() != bytes)
        return failure(ErrorCode::Unreadable, where, "there are no pixels to write");
    WriteRequest request{suffix, std::uint64_t(image.width), std::uint64_t(image.height), std::uint64_t(image.channels),
        std::uint64_t(image.type), srgb, ""};
    return encode(request, image.data, where);
}

// "B.R,B.G" of a layer "B"; the first layer has no prefix.
std::string channelNames(const ImageLayer& layer, bool first)
{
    static constexpr std::array<std::string_view, 4> kSets = {"Y", "Y,A", "R,G,B", "R,G,B,A"};
    std::string names;
    const std::string prefix = first ? "" : layer.name + ".";
    std::string_view rest = kSets[std::size_t(layer.image.channels - 1)];
    for (; !rest.empty(); rest.remove_prefix(std::min<std::size_t>(2, rest.size())))
        names += (names.empty() ? "" : ",") + prefix + rest[0];
    return names;
}

// Copies one layer's channels to their place in the interleaved rows of all layers.
void interleave(const Image& image, std::vector<std::byte>& all, std::size_t texelBytes, std::size_t offset)
{
    const std::size_t bytes = std::size_t(image.channels) * 4;
    for (std::size_t i = 0; i < image.texelCount(); ++i)
        std::memcpy(all.data() + i * texelBytes + offset, image.data.data() + i * bytes, bytes);
}

bool fits(const ImageLayer& layer, const Image& first)
{
    const Image& image = layer.image;
    return image.type == PixelType::F32 && image.width == first.width && image.height == first.height && image.width > 0
        && image.channels >= 1 && image.channels <= 4 && image.data.size() == image.texelCount() * std::size_t(image.channels) * 4;
}
} // namespace

Expected<ImageInfo> readImageInfo(const fs::path& file)
{
    if (namesEmbeddedPicture(file)) {
        const Expected<std::vector<std::byte>> bytes = readEmbeddedPicture(file);
        if (!bytes)
            return tl::unexpected(bytes.error());
        return ask(Message::InfoBytes, bytesPacket(*bytes, file.string()), *bytes, file.string(), {}).map(infoOf);
    }
    const NamedLayer layer = fileAndLayer(file);
    if (const auto readable = checkReadable(layer.file); !readable)
        return tl::unexpected(readable.error());
    return ask(Message::Info, pathPacket(layer), {}, file.string(), {}).map(infoOf);
}

Expected<ImageRead> readImage(const fs::path& file, const Progress& progress)
{
    if (namesEmbeddedPicture(file)) {
        const Expected<std::vector<std::byte>> bytes = readEmbeddedPicture(file);
        return bytes ? readImageBytes(*bytes, file.string()) : tl::unexpected(bytes.error());
    }
    const NamedLayer layer = fileAndLayer(file);
    if (const auto readable = checkReadable(layer.file); !readable)
        return tl::unexpected(readable.error());
    return imageOf(ask(Message::Read, pathPacket(layer), {}, file.string(), progress), file.string());
}

Expected<ImageRead> readImageBytes(std::span<const std::byte> bytes, const std::string& name)
{
    return imageOf(ask(Message::ReadBytes, bytesPacket(bytes, name), bytes, name, {}), name);
}

Expected<void> writeImage(const fs::path& file, const Image& image, bool srgb)
{
    const Expected<std::vector<std::byte>> bytes = encode(image, srgb, lowerSuffix(file).erase(0, 1), file.string());
    if (!bytes)
        return tl::unexpected(bytes.error());
    return writeAtomically(file, *bytes);
}

Expected<void> writeLayers(const fs::path& exrFile, std::span<const ImageLayer> layers)
{
    if (layers.empty() || !std::ranges::all_of(layers, [&](const ImageLayer& layer) { return fits(layer, layers[0].image); }))
        return failure(ErrorCode::Unreadable, exrFile.string(), "the layers are not float pictures of one size");
    WriteRequest request{
        "exr", std::uint64_t(layers[0].image.width), std::uint64_t(layers[0].image.height), 0, std::uint64_t(PixelType::F32), 0, ""};
    for (const ImageLayer& layer : layers) {
        request.channelNames += (request.channelNames.empty() ? "" : ",") + channelNames(layer, &layer == &layers[0]);
        request.channels += std::uint64_t(layer.image.channels);
    }
    const std::size_t texelBytes = std::size_t(request.channels) * 4;
    std::vector<std::byte> all(layers[0].image.texelCount() * texelBytes);
    std::size_t offset = 0;
    for (const ImageLayer& layer : layers) {
        interleave(layer.image, all, texelBytes, offset);
        offset += std::size_t(layer.image.channels) * 4;
    }
    const Expected<std::vector<std::byte>> bytes = encode(request, all, exrFile.string());
    if (!bytes)
        return tl::unexpected(bytes.error());
    return writeAtomically(exrFile, *bytes);
}

Expected<std::vector<std::byte>> encodePng(const Image& image, bool srgb)
{
    return encode(image, srgb, "png", "PNG");
}

} // namespace relievo
