// What the editor and the helper process relievo-imageio say to each other: frames over the helper's stdin and stdout.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Every message is a Frame, then `size` bytes. Numbers are in the machine's byte order: both ends run on one machine.
//
// Requests, one at a time; the next one is sent after Done or Failed:
//   Info      packet: file, layer
//   Read      packet: file, layer ("" for the first one)
//   InfoBytes, ReadBytes  packet: name, byte count; then that many raw bytes of an encoded image
//   Write     packet: WriteRequest; then width * height * channels values, row 0 first, interleaved
//   Meshopt   packet: MeshoptRequest; then that many compressed bytes (EXT_meshopt_compression)
//   Draco     packet: DracoRequest; then that many compressed bytes (KHR_draco_mesh_compression)
// Replies:
//   Info...   Header, Done                     Header packet: HeaderReply, then the names of layers
//   Read...   Header, Data ..., Done           Data: whole rows in order, interleaved; Done packet: warnings (code, text) pairs
//   Write     Data ..., Done                   Data: the encoded file's bytes in order
//   Meshopt   Data ..., Done                   Data: count * stride bytes
//   Draco     Data ..., Done                   Data: 32 bits each: points, triangles, three points a triangle; then each attribute's values
//   by point any       Failed at any point              packet: what, hint
// The helper ends when its stdin is closed. A reply that stops without Done or Failed means that it died.
namespace relievo::imageio {

enum class Message : std::uint32_t { Info = 1, InfoBytes, Read, ReadBytes, Write, Meshopt, Draco, Header, Data, Done, Failed };

struct Frame {
    Message message;
    std::uint32_t size; // bytes that follow
};
inline constexpr std::uint32_t kMaxPacket = 1 << 20; // bytes of any frame but Data
inline constexpr std::uint32_t kMaxData = 1 << 30; // bytes of a Data frame
inline constexpr int kMaxSide = 16384; // texels a side that are kept; a larger image is box-reduced while it is read
inline constexpr std::size_t kMemoryLimitMiB = 3072; // address space of the helper
inline constexpr const char* kWithTwin = "--with-twin"; // its argument when a copy of it is to talk over these descriptors:
inline constexpr int kTwinIn = 3, kTwinOut = 4; // the first thing that this one says is its process id, as pid_t
inline constexpr int kOutOfTime = 75; // its exit code when decoding takes far longer than the promised pixels can need

// The bytes of a packet: fixed-size numbers, and strings with their length before them.
class PacketWriter {
public:
    void put(std::uint64_t number)
    {
        const std::size_t at = m_bytes.size();
        m_bytes.resize(at + sizeof number);
        std::memcpy(m_bytes.data() + at, &number, sizeof number);
    }
    void put(std::string_view text)
    {
        put(std::uint64_t(text.size()));
        const std::size_t at = m_bytes.size();
        m_bytes.resize(at + text.size());
        if (!text.empty())
            std::memcpy(m_bytes.data() + at, text.data(), text.size());
    }
    std::span<const std::byte> bytes() const { return m_bytes; }

private:
    std::vector<std::byte> m_bytes;
};

// Reads what PacketWriter wrote; past the end everything is 0 or empty and ok() is false.
class PacketReader {
public:
    explicit PacketReader(std::span<const std::byte> bytes) : m_rest(bytes) { }
    std::uint64_t number()
    {
        std::uint64_t value = 0;
        if (take(sizeof value))
            std::memcpy(&value, m_taken.data(), sizeof value);
        return value;
    }
    std::string text()
    {
        const std::uint64_t size = number();
        return take(size) ? std::string(reinterpret_cast<const char*>(m_taken.data()), m_taken.size()) : std::string();
    }
    bool ok() const { return m_ok; }
    bool atEnd() const { return m_rest.empty(); }

private:
    bool take(std::uint64_t size)
    {
        m_ok = m_ok && size <= m_rest.size();
        if (!m_ok)
            return false;
        m_taken = m_rest.first(std::size_t(size));
        m_rest = m_rest.subspan(std::size_t(size));
        return true;
    }
    std::span<const std::byte> m_rest, m_taken;
    bool m_ok = true;
};

// What an image's header says, and the size that its rows will have.
struct HeaderReply {
    std::uint64_t fileWidth = 0, fileHeight = 0, fileChannels = 0; // as stored
    std::uint64_t width = 0, height = 0, channels = 0; // as sent
    std::uint64_t type = 0; // a PixelType
    std::uint64_t storedBits = 8, storedFloat = 0;
    std::uint64_t storedMaximum = 0; // as Image has it
    std::uint64_t hasSurvey = 0, hasNoData = 0;
    std::uint64_t texelWidth = 0, metres = 0, noData = 0; // bits of the doubles of a Survey
};
// numbers(x) lists the members once, for writing and reading alike.
template <class Header> auto numbers(Header& h)
{
    return std::vector{&h.fileWidth, &h.fileHeight, &h.fileChannels, &h.width, &h.height, &h.channels, &h.type, &h.storedBits,
        &h.storedFloat, &h.storedMaximum, &h.hasSurvey, &h.hasNoData, &h.texelWidth, &h.metres, &h.noData};
}

enum class MeshoptMode : std::uint64_t { Attributes, Triangles, Indices };
enum class MeshoptFilter : std::uint64_t { None, Octahedral, Quaternion, Exponential };
struct MeshoptRequest {
    std::uint64_t size = 0; // compressed bytes
    std::uint64_t count = 0, stride = 0; // elements, and bytes of each
    std::uint64_t mode = 0, filter = 0; // MeshoptMode, MeshoptFilter
};

struct DracoAttribute {
    std::uint64_t id = 0, components = 0, componentType = 0; // the id in the compressed bytes; the type as glTF numbers it: 5126 is float
};
struct DracoRequest {
    std::uint64_t size = 0; // compressed bytes
    std::vector<DracoAttribute> attributes;
};

struct WriteRequest {
    std::string suffix; // lower case without dot: "png"
    std::uint64_t width = 0, height = 0, channels = 0, type = 0, srgb = 0;
    std::string channelNames; // comma separated, "" for the format's own
};

} // namespace relievo::imageio
