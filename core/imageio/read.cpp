// Reading pixels in strips of rows, so that the helper's memory stays small whatever the image's size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/read.h"
#include "core/imageio/memory_file.h"
#include "core/imageio/picture.h"
#include <algorithm>

namespace relievo::imageio {
namespace {
constexpr std::size_t kStripBytes = std::size_t(1) << 20; // of pixels sent at once
constexpr std::size_t kMaxStripBytes = std::size_t(1) << 30; // a strip of tiles cannot be cut

OIIO::TypeDesc libraryType(PixelType type)
{
    return type == PixelType::U8 ? OIIO::TypeDesc::UINT8 : type == PixelType::U16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

// Averages boxes of factorX x factorY texels of rows as they come.
template <class Texel> class BoxReducer {
public:
    BoxReducer(Channel& channel, const Picture& picture)
        : m_channel(channel)
        , m_picture(picture)
        , m_sums(std::size_t(picture.header.width) * std::size_t(picture.channels))
        , m_row(m_sums.size())
    {
    }
    void push(const std::byte* rows, int count)
    {
        const std::size_t values = std::size_t(m_picture.shown.width) * std::size_t(m_picture.channels);
        for (int y = 0; y < count; ++y)
            addRow(reinterpret_cast<const Texel*>(rows) + std::size_t(y) * values);
    }

private:
    void addRow(const Texel* row)
    {
        const std::size_t channels = std::size_t(m_picture.channels), box = std::size_t(m_picture.factorX) * channels;
        const Texel* const end = row + std::size_t(m_picture.shown.width) * channels;
        for (double* sums = m_sums.data(); row < end; sums += channels)
            for (const Texel* const boxEnd = std::min(row + box, end); row < boxEnd; row += channels)
                for (std::size_t c = 0; c < channels; ++c)
                    sums[c] += double(row[c]);
        ++m_summed;
        ++m_seen;
        if (m_summed == m_picture.factorY || m_seen == m_picture.shown.height)
            flush();
    }
    void flush()
    {
        const std::size_t channels = std::size_t(m_picture.channels);
        for (std::size_t i = 0; i < m_sums.size(); ++i) {
            const int first = int(i / channels) * m_picture.factorX;
            const int across = std::min(m_picture.factorX, m_picture.shown.width - first);
            const double mean = m_sums[i] / (double(across) * m_summed);
            m_row[i] = std::is_integral_v<Texel> ? Texel(mean + 0.5) : Texel(mean);
        }
        m_channel.send(Message::Data, std::as_bytes(std::span(m_row)));
        std::ranges::fill(m_sums, 0.0);
        m_summed = 0;
    }
    Channel& m_channel;
    const Picture& m_picture;
    std::vector<double> m_sums;
    std::vector<Texel> m_row;
    int m_summed = 0, m_seen = 0; // rows
};

class PixelStream {
public:
    PixelStream(Channel& channel, Picture& picture)
        : m_channel(channel)
        , m_picture(picture)
        , m_texel(std::size_t(picture.channels) * bytesOf(picture.type))
        , m_rowBytes(m_texel * std::size_t(picture.data.width))
        , m_shownRowBytes(m_texel * std::size_t(picture.shown.width))
    {
    }

    // Sends all rows; a text of the library on failure.
    tl::expected<void, Refusal> run(const std::string& file)
    {
        const int step = stripRows();
        if (std::size_t(step) * std::max(m_rowBytes, m_shownRowBytes) > kMaxStripBytes)
            return tl::unexpected(Refusal{"its tiles are too large to be read", "Export it as scanlines or with smaller tiles"});
        m_strip.resize(std::size_t(step) * m_rowBytes);
        const Window &data = m_picture.data, &shown = m_picture.shown;
        sendEmpty(shown.y, std::min(data.y, shown.y + shown.height));
        for (int y = data.y; y < data.y + data.height; y += step) {
            const int end = std::min(y + step, data.y + data.height);
            if (end <= shown.y || y >= shown.y + shown.height)
                continue;
            if (!readRows(y, end))
                return tl::unexpected(refusalFrom(*m_picture.format, m_picture.input->geterror(), file));
            const std::size_t values = std::size_t(end - y) * std::size_t(m_picture.data.width) * std::size_t(m_picture.channels);
            if (m_picture.threeBytes)
                orderBytes(values);
            if (m_picture.inverted)
                invert(values);
            place(y, end);
        }
        sendEmpty(std::max(data.y + data.height, shown.y), shown.y + shown.height);
        return checkComplaints(file);
    }

private:
    // Some decoders fill up what is missing and only complain. Stray bytes between a JPEG's parts harm nothing.
    tl::expected<void, Refusal> checkComplaints(const std::string& file)
    {
        if (!m_picture.input->has_error())
            return {};
        const std::string text = m_picture.input->geterror();
        if (text.find("extraneous bytes") == std::string::npos || text.find('\n') != std::string::npos)
            return tl::unexpected(refusalFrom(*m_picture.format, text, file));
        m_picture.warnings.emplace_back("stray-bytes", "the JPEG data holds stray bytes, which were skipped");
        return {};
    }

    // Whole tiles; else about a megabyte, in multiples of the 64 rows that no compressor's block exceeds.
    int stripRows() const
    {
        if (m_picture.spec.tile_width > 0)
            return std::max(m_picture.spec.tile_height, 1);
        const std::size_t rows = kStripBytes / std::max<std::size_t>(m_rowBytes, 1);
        return int(std::clamp<std::size_t>(rows / 64 * 64, 64, 1 << 14));
    }

    bool readRows(int y, int end)
    {
        const OIIO::ImageSpec& spec = m_picture.spec;
        const OIIO::TypeDesc type = m_picture.threeBytes ? OIIO::TypeDesc(OIIO::TypeDesc::UINT32) : libraryType(m_picture.type);
        const int part = m_picture.part, first = m_picture.firstChannel, last = first + m_picture.channels;
        if (spec.tile_width > 0)
            return m_picture.input->read_tiles(
                part, 0, spec.x, spec.x + spec.width, y, end, spec.z, spec.z + 1, first, last, type, m_strip.data());
        return m_picture.input->read_scanlines(part, 0, y, end, spec.z, first, last, type, m_strip.data());
    }

    // 32 bits whose upper three bytes are the number's, the lowest first, become shares of the largest number.
    void orderBytes(std::size_t values)
    {
        for (std::byte* at = m_strip.data(); values > 0; --values, at += 4) {
            std::uint32_t stored;
            std::memcpy(&stored, at, sizeof stored);
            const std::uint32_t number = stored >> 24 | (stored >> 8 & 0xff00) | (stored << 8 & 0xff0000);
            const float share = float(double(number) / 0xffffff);
            std::memcpy(at, &share, sizeof share);
        }
    }

    // Turns white, the smallest number of the file, into the largest. Alpha has no such turn.
    void invert(std::size_t values)
    {
        const auto turn = [&](auto* value, auto most) {
            const std::size_t channels = std::size_t(m_picture.channels);
            for (std::size_t i = 0; i < values; ++i)
                if (channels % 2 == 1 || i % channels != channels - 1)
                    value[i] = decltype(most)(most - value[i]);
        };
        if (m_picture.type == PixelType::U16)
            turn(reinterpret_cast<std::uint16_t*>(m_strip.data()), std::uint16_t(65535));
        else if (m_picture.type == PixelType::U8)
            turn(reinterpret_cast<std::uint8_t*>(m_strip.data()), std::uint8_t(255));
        else
            turn(reinterpret_cast<float*>(m_strip.data()), 1.f);
    }

    // Cuts the strip to the shown window and hands it on.
    void place(int y, int end)
    {
        const Window &data = m_picture.data, &shown = m_picture.shown;
        const int first = std::max(y, shown.y), last = std::min(end, shown.y + shown.height);
        const std::byte* rows = m_strip.data() + std::size_t(first - y) * m_rowBytes;
        if (data.x == shown.x && data.width == shown.width)
            return emit(rows, last - first);
        m_placed.assign(m_shownRowBytes, std::byte(0));
        const int left = std::max(data.x, shown.x), right = std::min(data.x + data.width, shown.x + shown.width);
        for (int row = first; row < last; ++row, rows += m_rowBytes) {
            std::memcpy(m_placed.data() + std::size_t(left - shown.x) * m_texel, rows + std::size_t(left - data.x) * m_texel,
                std::size_t(right - left) * m_texel);
            emit(m_placed.data(), 1);
        }
    }

    void sendEmpty(int from, int to)
    {
        const std::vector<std::byte> zeros(from < to ? m_shownRowBytes : 0);
        for (int y = from; y < to; ++y)
            emit(zeros.data(), 1);
    }

    void emit(const std::byte* rows, int count)
    {
        if (m_picture.factorX == 1 && m_picture.factorY == 1)
            m_channel.send(Message::Data, std::span(rows, std::size_t(count) * m_shownRowBytes));
        else if (m_picture.type == PixelType::U8)
            m_bytes.push(rows, count);
        else if (m_picture.type == PixelType::U16)
            m_words.push(rows, count);
        else
            m_floats.push(rows, count);
    }

    Channel& m_channel;
    Picture& m_picture;
    std::size_t m_texel, m_rowBytes, m_shownRowBytes;
    std::vector<std::byte> m_strip, m_placed;
    BoxReducer<std::uint8_t> m_bytes{m_channel, m_picture};
    BoxReducer<std::uint16_t> m_words{m_channel, m_picture};
    BoxReducer<float> m_floats{m_channel, m_picture};
};

// Pages after the first are thumbnails or other materials; only TIFF does not say in its header how many there are.
void tellPages(Picture& picture)
{
    if (picture.format->name == "tiff" && picture.input->seek_subimage(1, 0))
        picture.warnings.emplace_back("parts", "only the first of its pages is used");
}

void sendHeader(Channel& channel, Picture& picture)
{
    PacketWriter packet;
    for (const std::uint64_t* number : numbers(picture.header))
        packet.put(*number);
    for (const std::string& layer : picture.layers)
        packet.put(layer);
    channel.send(Message::Header, packet.bytes());
}
} // namespace

void answerRead(Channel& channel, const ReadRequest& request, bool headerOnly)
{
    tl::expected<Picture, Refusal> picture = openPicture(request.file, request.suffix, request.layer);
    if (!picture)
        return channel.fail(picture.error());
    sendHeader(channel, *picture);
    if (!headerOnly) {
        if (const auto sent = PixelStream(channel, *picture).run(request.file); !sent)
            return channel.fail(sent.error());
        tellPages(*picture);
    }
    channel.done(picture->warnings);
}

void answerReadBytes(Channel& channel, std::uint64_t size, bool headerOnly)
{
    MemoryFile file;
    std::vector<std::byte> block(std::min<std::uint64_t>(size, kStripBytes));
    while (size > 0) {
        const std::span part(block.data(), std::size_t(std::min<std::uint64_t>(size, block.size())));
        if (!channel.receive(part))
            return;
        file.append(part);
        size -= part.size();
    }
    answerRead(channel, {file.path(), "", ""}, headerOnly);
}

} // namespace relievo::imageio
