// Image files by way of the helper process: requests in turn, replies checked, crashes told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/image_file.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/foreign_file.h"
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include "core/image/files/helper_requests.h"
#include "core/image/files/process_client.h"
#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <mutex>

namespace relievo {
namespace fs = std::filesystem;
using namespace imageio;

namespace {
struct Helper {
    std::mutex mutex;
    HelperProcess process;
    HangGuard hangs;
};
Helper& helper()
{
    static Helper one;
    return one;
}

// A conversation that broke: either an answer in words, or the helper is in trouble.
struct Broken {
    std::string what, hint;
    HelperTrouble trouble = HelperTrouble::None;
};

Error inWords(const Broken& broken, bool writes, const std::string& where)
{
    const char* const cure = writes ? "Free memory, or write a smaller picture" : "The file is probably damaged: export it again";
    const ErrorCode code = writes ? ErrorCode::NotWritable : ErrorCode::Unreadable;
    switch (broken.trouble) {
    case HelperTrouble::None:
        return {broken.what, where, broken.hint, code};
    case HelperTrouble::NotFound:
        return {"the program relievo-imageio, which reads and writes images, could not be started", where,
            "Install it beside relievo, or set RELIEVO_IMAGEIO to its path"};
    case HelperTrouble::OutOfTime:
        return {"decoding it takes far longer than an image of its size can need", where, cure, code};
    case HelperTrouble::TimedOut:
        return {"the image library made no progress for 20 seconds", where, cure, code};
    case HelperTrouble::Cancelled:
        return cancelled(where).value();
    case HelperTrouble::Died:
        break;
    }
    return {"the image library crashed or ran out of memory on this file", where, cure, code};
}

class Conversation {
public:
    Conversation(HelperProcess& process, const Progress& progress) : m_process(process), m_progress(progress) { }

    tl::expected<Reply, Broken> run(Message message, const PacketWriter& packet, Payload payload)
    {
        const Frame frame{message, std::uint32_t(packet.bytes().size())};
        if (!m_process.send(std::as_bytes(std::span(&frame, 1)), m_progress) || !m_process.send(packet.bytes(), m_progress)
            || !m_process.send(payload, m_progress))
            return trouble();
        for (;;) {
            Frame reply{};
            if (!m_process.receive(std::as_writable_bytes(std::span(&reply, 1)), m_progress))
                return trouble();
            if (reply.message == Message::Done || reply.message == Message::Failed)
                return finish(reply);
            if (!(reply.message == Message::Header ? takeHeader(reply) : reply.message == Message::Data && takeData(reply)))
                return trouble();
        }
    }

private:
    // A reply out of protocol is as good as a crash: nothing that follows can be trusted.
    tl::unexpected<Broken> trouble()
    {
        m_process.kill();
        const HelperTrouble known = m_process.trouble();
        return tl::unexpected(Broken{"", "", known == HelperTrouble::None ? HelperTrouble::Died : known});
    }

    bool takePacket(const Frame& frame, std::vector<std::byte>& bytes)
    {
        bytes.resize(std::min(frame.size, kMaxPacket));
        return frame.size <= kMaxPacket && m_process.receive(bytes, m_progress);
    }

    tl::expected<Reply, Broken> finish(const Frame& frame)
    {
        std::vector<std::byte> bytes;
        if (!takePacket(frame, bytes))
            return trouble();
        PacketReader packet(bytes);
        if (frame.message == Message::Failed) {
            Broken broken;
            broken.what = packet.text();
            broken.hint = packet.text();
            return tl::unexpected(broken);
        }
        while (packet.ok() && !packet.atEnd()) {
            Warning warning;
            warning.code = packet.text();
            warning.text = packet.text();
            m_reply.warnings.push_back(std::move(warning));
        }
        return std::move(m_reply);
    }

    bool takeHeader(const Frame& frame)
    {
        std::vector<std::byte> bytes;
        if (!takePacket(frame, bytes))
            return false;
        PacketReader packet(bytes);
        HeaderReply& header = m_reply.header;
        for (std::uint64_t* number : numbers(header))
            *number = packet.number();
        if (!packet.ok() || header.channels < 1 || header.channels > 4 || header.type > 2 || header.width * header.height > kMaxTexels)
            return false;
        while (packet.ok() && !packet.atEnd())
            m_reply.layers.push_back(packet.text());
        m_expected = std::size_t(header.width * header.height * header.channels) * bytesOf(PixelType(header.type));
        return true;
    }

    // Pixels go straight to where they stay; memory is touched only as they come.
    bool takeData(const Frame& frame)
    {
        const std::size_t at = m_reply.data.size();
        if (frame.size > kMaxData || (m_expected > 0 && at + frame.size > m_expected))
            return false;
        if (m_expected > 0)
            m_reply.data.reserve(m_expected);
        m_reply.data.resize(at + frame.size);
        if (!m_process.receive(std::span(m_reply.data).subspan(at), m_progress))
            return false;
        if (m_expected > 0)
            m_progress.at(float(m_reply.data.size()) / float(m_expected));
        return true;
    }

    HelperProcess& m_process;
    const Progress& m_progress;
    Reply m_reply;
    std::size_t m_expected = 0; // bytes of pixels; 0 while unknown
};

} // namespace

// A helper that has worked before may have been hurt by an earlier file: only a fresh one's death is this file's fault.
Expected<Reply> imageio::ask(
    Message message, const PacketWriter& packet, Payload payload, const std::string& where, const Progress& progress)
{
    Helper& one = helper();
    const std::scoped_lock lock(one.mutex);
    if (one.hangs.refuses(HangGuard::Clock::now()))
        return failure(ErrorCode::Unreadable, where, "the program relievo-imageio, which reads and writes images, hangs",
            "Install it again, or set RELIEVO_IMAGEIO to another one; it is tried again after a minute");
    for (;;) {
        bool fresh = false;
        if (!one.process.ensureRunning(fresh))
            return tl::unexpected(inWords({"", "", HelperTrouble::NotFound}, message == Message::Write, where));
        tl::expected<Reply, Broken> reply = Conversation(one.process, progress).run(message, packet, payload);
        one.hangs.note(reply ? HelperTrouble::None : reply.error().trouble, fresh, HangGuard::Clock::now());
        if (reply)
            return std::move(*reply);
        if (fresh || reply.error().trouble != HelperTrouble::Died)
            return tl::unexpected(inWords(reply.error(), message == Message::Write, where));
    }
}

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

int imageHelperId()
{
    Helper& one = helper();
    const std::scoped_lock lock(one.mutex);
    return one.process.id();
}

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
