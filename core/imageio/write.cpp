// Writing every format through a file in memory: the editor then puts it in place atomically.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/write.h"
#include "core/image/image.h"
#include "core/imageio/formats.h"
#include "core/imageio/memory_file.h"
#include "core/imageio/picture.h"
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <optional>

namespace relievo::imageio {
namespace {
constexpr std::size_t kBlockBytes = std::size_t(1) << 20;

OIIO::TypeDesc typeOf(PixelType type)
{
    return type == PixelType::U8 ? OIIO::TypeDesc::UINT8 : type == PixelType::U16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

// The most precise type that the format holds and the pixels need.
OIIO::TypeDesc fileType(const FormatRow& format, PixelType type)
{
    if (format.integerBits == 0 || (type == PixelType::F32 && format.floats))
        return OIIO::TypeDesc::FLOAT;
    return type == PixelType::U8 || format.integerBits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
}

int fileChannels(const FormatRow& format, int channels)
{
    const auto holds = [&](int count) { return format.channels.find(char('0' + count)) != std::string_view::npos; };
    if (channels > 4 || holds(channels))
        return channels;
    return channels == 2 && holds(1) && !holds(4) ? 1 : channels == 2 && holds(4) ? 4 : 3;
}

// Which channel of the pixels goes to channel `to` of the file; greys are repeated, alpha comes last.
int sourceChannel(int to, int from, int count)
{
    if (from == count || (from >= 3 && count == 3))
        return to;
    return from == 2 && count == 4 && to == 3 ? 1 : 0;
}

class Encoder {
public:
    Encoder(const FormatRow& format, const WriteRequest& request)
        : m_format(format)
        , m_request(request)
        , m_from(int(request.channels))
        , m_to(fileChannels(format, m_from))
        , m_texel(bytesOf(PixelType(request.type)))
    {
    }

    bool open(const std::string& path)
    {
        m_output = OIIO::ImageOutput::create(m_format.name);
        if (!m_output)
            return fails("this build writes no such images");
        OIIO::ImageSpec spec(int(m_request.width), int(m_request.height), m_to, fileType(m_format, PixelType(m_request.type)));
        spec.attribute("oiio:UnassociatedAlpha", 1); // stored as given, never divided
        if (m_request.srgb && m_format.integerBits > 0)
            spec.attribute("oiio:ColorSpace", "sRGB");
        if (m_format.name == "jpeg")
            spec.attribute("Compression", "jpeg:95");
        if (!m_request.channelNames.empty())
            nameChannels(spec);
        return m_output->open(path, spec) || fails(m_output->geterror());
    }

    bool write(int y, int end, std::span<const std::byte> rows)
    {
        const std::byte* pixels = rows.data();
        if (m_from != m_to)
            pixels = rearranged(rows);
        return m_output->write_scanlines(y, end, 0, typeOf(PixelType(m_request.type)), pixels) || fails(m_output->geterror());
    }

    bool close() { return m_output->close() || fails(m_output->geterror()); }
    const std::string& failure() const { return m_failure; }

private:
    bool fails(std::string text)
    {
        m_failure = text.empty() ? "the image library gives no reason" : std::move(text);
        return false;
    }

    void nameChannels(OIIO::ImageSpec& spec) const
    {
        spec.channelnames.clear();
        std::string_view rest = m_request.channelNames;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(','), rest.size());
            spec.channelnames.emplace_back(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        spec.alpha_channel = -1;
    }

    const std::byte* rearranged(std::span<const std::byte> rows)
    {
        const std::size_t from = std::size_t(m_from) * m_texel, to = std::size_t(m_to) * m_texel;
        const std::size_t count = rows.size() / from;
        m_rows.resize(count * to);
        for (std::size_t i = 0; i < count; ++i)
            for (int c = 0; c < m_to; ++c)
                std::memcpy(m_rows.data() + i * to + std::size_t(c) * m_texel,
                    rows.data() + i * from + std::size_t(sourceChannel(c, m_from, m_to)) * m_texel, m_texel);
        return m_rows.data();
    }

    const FormatRow& m_format;
    const WriteRequest& m_request;
    int m_from, m_to;
    std::size_t m_texel;
    std::unique_ptr<OIIO::ImageOutput> m_output;
    std::vector<std::byte> m_rows;
    std::string m_failure;
};

void sendFile(Channel& channel, const MemoryFile& file)
{
    std::vector<std::byte> block(kBlockBytes);
    std::size_t offset = 0;
    while (const std::size_t got = file.readAt(offset, block)) {
        channel.send(Message::Data, std::span(block).first(got));
        offset += got;
    }
}

Refusal cannotEncode(const std::string& suffix, const std::string& why)
{
    Refusal refusal = refusalFrom(kFormats[0], why, "");
    refusal.what = "the image cannot be written as " + suffix + " (" + why.substr(0, why.find('\n')) + ")";
    refusal.hint = "Choose another format";
    return refusal;
}
} // namespace

// Pixels are always taken in full, so that the conversation stays in step when encoding fails early.
void answerWrite(Channel& channel, const WriteRequest& request)
{
    const FormatRow* format = formatToWrite(request.suffix);
    MemoryFile file;
    std::optional<Encoder> encoder;
    bool good = format && file.ok();
    if (good) {
        encoder.emplace(*format, request);
        good = encoder->open(file.path());
    }
    const std::size_t rowBytes = std::size_t(request.width * request.channels) * bytesOf(PixelType(request.type));
    const int step = int(std::clamp<std::size_t>(kBlockBytes / std::max<std::size_t>(rowBytes, 1), 1, 1024));
    std::vector<std::byte> rows(rowBytes * std::size_t(step));
    for (int y = 0; y < int(request.height); y += step) {
        const int end = std::min(y + step, int(request.height));
        const std::span part(rows.data(), rowBytes * std::size_t(end - y));
        if (!channel.receive(part))
            return;
        good = good && encoder->write(y, end, part);
    }
    good = good && encoder->close();
    if (!format)
        return channel.fail({"images cannot be written as ." + request.suffix, "Use .png, .tif, .exr, .hdr, .tga, .jpg or .bmp"});
    if (!good)
        return channel.fail(cannotEncode(request.suffix, encoder ? encoder->failure() : "no memory"));
    sendFile(channel, file);
    channel.done({});
}

} // namespace relievo::imageio
