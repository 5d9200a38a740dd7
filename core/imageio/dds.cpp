// DDS headers, uncompressed pixels, and signed blocks made unsigned.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/dds.h"
#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

namespace relievo::imageio {
namespace {
using OIIO::TypeDesc;
constexpr std::size_t kHeaderBytes = 128, kLongHeaderBytes = 148; // the long one follows the four characters DX10
constexpr std::uint32_t kHasFourCC = 0x4, kRgb = 0x40, kLuminance = 0x20000, kSigned = 0x80000, kCubeOrVolume = 0x200200;

constexpr std::uint32_t fourCC(const char (&name)[5])
{
    return std::uint32_t(std::uint8_t(name[0])) | std::uint32_t(std::uint8_t(name[1])) << 8 | std::uint32_t(std::uint8_t(name[2])) << 16
        | std::uint32_t(std::uint8_t(name[3])) << 24;
}
constexpr std::uint32_t kDx10 = fourCC("DX10");

// Uncompressed formats by their number in DXGI and, where there is one, in Direct3D 9 (stored in place of the four characters).
struct PlainRow {
    std::uint32_t dxgi, d3d9;
    int channels;
    TypeDesc::BASETYPE type;
    bool blueFirst = false;
    int spare = 0; // channels at the end that say nothing
    bool tenBits = false; // three of ten bits and one of two in each 32, widened to 16
};
constexpr std::uint32_t kBlueFirstTenBits = 0xffff; // DXGI has no number for it
constexpr auto kPlain = std::to_array<PlainRow>({
    {2, 116, 4, TypeDesc::FLOAT},
    {6, 0, 3, TypeDesc::FLOAT},
    {10, 113, 4, TypeDesc::HALF},
    {11, 36, 4, TypeDesc::UINT16},
    {13, 110, 4, TypeDesc::INT16},
    {16, 115, 2, TypeDesc::FLOAT},
    {24, 31, 4, TypeDesc::UINT16, false, 0, true},
    {kBlueFirstTenBits, 35, 4, TypeDesc::UINT16, true, 0, true},
    {28, 0, 4, TypeDesc::UINT8},
    {29, 0, 4, TypeDesc::UINT8},
    {31, 63, 4, TypeDesc::INT8},
    {34, 112, 2, TypeDesc::HALF},
    {35, 0, 2, TypeDesc::UINT16},
    {37, 64, 2, TypeDesc::INT16},
    {41, 114, 1, TypeDesc::FLOAT},
    {42, 0, 1, TypeDesc::UINT32},
    {43, 0, 1, TypeDesc::INT32},
    {49, 0, 2, TypeDesc::UINT8},
    {51, 60, 2, TypeDesc::INT8},
    {54, 111, 1, TypeDesc::HALF},
    {56, 0, 1, TypeDesc::UINT16},
    {57, 0, 1, TypeDesc::UINT16},
    {58, 0, 1, TypeDesc::INT16},
    {59, 0, 1, TypeDesc::INT16},
    {61, 0, 1, TypeDesc::UINT8},
    {63, 0, 1, TypeDesc::INT8},
    {65, 0, 1, TypeDesc::UINT8},
    {87, 0, 4, TypeDesc::UINT8, true},
    {88, 0, 3, TypeDesc::UINT8, true, 1},
    {91, 0, 4, TypeDesc::UINT8, true},
    {93, 0, 3, TypeDesc::UINT8, true, 1},
});

// Compressed formats, and what the library calls them; 0: it knows them only by the number `known`.
struct BlockRow {
    std::uint32_t dxgi, name;
    std::uint32_t known = 0;
    bool isSigned = false;
};
constexpr auto kBlocks = std::to_array<BlockRow>({
    {70, fourCC("DXT1")},
    {71, fourCC("DXT1")},
    {72, fourCC("DXT1")},
    {73, fourCC("DXT3")},
    {74, fourCC("DXT3")},
    {75, fourCC("DXT3")},
    {76, fourCC("DXT5")},
    {77, fourCC("DXT5")},
    {78, fourCC("DXT5")},
    {79, fourCC("ATI1")},
    {80, fourCC("ATI1")},
    {81, fourCC("ATI1"), 0, true},
    {82, fourCC("ATI2")},
    {83, fourCC("ATI2")},
    {84, fourCC("ATI2"), 0, true},
    {95, 0, 95},
    {96, 0, 96},
    {97, 0, 98},
    {98, 0, 98},
    {99, 0, 98},
});
// Names of the same by four characters.
struct NameRow {
    std::uint32_t name, dxgi;
};
constexpr auto kNames = std::to_array<NameRow>({
    {fourCC("DXT2"), 74}, // multiplied by alpha, as DXT4 is
    {fourCC("DXT4"), 77},
    {fourCC("BC4U"), 80},
    {fourCC("BC4S"), 81},
    {fourCC("BC5U"), 83},
    {fourCC("BC5S"), 84},
});

// What old headers describe by bits a texel and masks, and the library cuts to 8 bits or does not read.
struct MaskRow {
    std::uint32_t flags, bits, red, green, dxgi;
};
constexpr auto kMasks = std::to_array<MaskRow>({
    {kLuminance | kRgb, 16, 0xffff, 0, 56},
    {kRgb, 32, 0xffff, 0xffff0000, 35},
    {kRgb, 32, 0x3ff, 0xffc00, 24},
    {kRgb, 32, 0x3ff00000, 0xffc00, kBlueFirstTenBits},
    {kSigned, 16, 0xff, 0xff00, 51},
    {kSigned, 32, 0xff, 0xff00, 31},
    {kSigned, 32, 0xffff, 0xffff0000, 37},
});

class Header {
public:
    explicit Header(const std::string& file)
    {
        std::ifstream in(file, std::ios::binary);
        in.read(reinterpret_cast<char*>(m_bytes.data()), std::streamsize(m_bytes.size()));
        m_size = std::size_t(std::max<std::streamsize>(in.gcount(), 0));
    }
    bool whole() const { return m_size >= (isLong() ? kLongHeaderBytes : kHeaderBytes); }
    bool isLong() const { return hasName() && name() == kDx10; }
    bool isPremultiplied() const { return hasName() && (name() == fourCC("DXT2") || name() == fourCC("DXT4")); }
    bool isSigned() const { return (number(80) & kSigned) != 0; }
    bool hasName() const { return (number(80) & kHasFourCC) != 0; }
    std::uint32_t name() const { return number(84); }
    std::size_t size() const { return isLong() ? kLongHeaderBytes : kHeaderBytes; }
    int width() const { return int(std::min<std::uint32_t>(number(16), 1 << 30)); }
    int height() const { return int(std::min<std::uint32_t>(number(12), 1 << 30)); }
    bool isFlat() const { return (number(112) & kCubeOrVolume) == 0 && (!isLong() || (number(132) == 3 && number(140) <= 1)); }

    // The format's number in DXGI; 0 where only the library can say what it is.
    std::uint32_t dxgi() const
    {
        if (isLong())
            return number(128) == kBlueFirstTenBits ? 0 : number(128);
        if (hasName()) {
            const auto named = std::ranges::find(kNames, name(), &NameRow::name);
            const auto plain = std::ranges::find(kPlain, name(), &PlainRow::d3d9);
            return named != kNames.end() ? named->dxgi : name() != 0 && plain != kPlain.end() ? plain->dxgi : 0;
        }
        for (const MaskRow& row : kMasks)
            if ((number(80) & row.flags) != 0 && number(88) == row.bits && number(92) == row.red && number(96) == row.green)
                return row.dxgi;
        return 0;
    }

    std::string kind() const
    {
        if (isLong())
            return "DXGI format " + std::to_string(dxgi());
        if (!hasName())
            return std::to_string(number(88)) + " bits a texel";
        std::string text(reinterpret_cast<const char*>(m_bytes.data()) + 84, 4);
        const bool isWord = std::ranges::all_of(text, [](char c) { return c >= '0' && c <= 'z'; });
        return isWord ? text : "Direct3D format " + std::to_string(name());
    }

    // 128 bytes, or 148 with a number of DXGI.
    std::vector<std::byte> renamed(const BlockRow& row) const
    {
        std::vector<std::byte> bytes(m_bytes.begin(), m_bytes.begin() + std::ptrdiff_t(row.name != 0 ? kHeaderBytes : kLongHeaderBytes));
        const auto put = [&](std::size_t at, std::uint32_t value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
        put(84, row.name != 0 ? row.name : kDx10);
        if (row.name == 0)
            put(128, row.known);
        return bytes;
    }

private:
    std::uint32_t number(std::size_t at) const
    {
        std::uint32_t value;
        std::memcpy(&value, m_bytes.data() + at, sizeof value); // little-endian, as the machine
        return value;
    }
    std::array<std::byte, kLongHeaderBytes> m_bytes = {};
    std::size_t m_size = 0;
};

class PlainPixels final : public OIIO::ImageInput {
public:
    PlainPixels(const PlainRow& row, const Header& header) : m_row(row), m_start(header.size())
    {
        m_spec = OIIO::ImageSpec(header.width(), header.height(), row.channels, row.type);
    }
    const char* format_name() const override { return "dds"; }
    bool open(const std::string& name, OIIO::ImageSpec& spec) override
    {
        m_file.open(name, std::ios::binary);
        spec = m_spec;
        return bool(m_file);
    }
    bool open(const std::string& name, OIIO::ImageSpec& spec, const OIIO::ImageSpec&) override { return open(name, spec); }
    bool close() override { return true; }
    bool read_native_scanline(int, int, int y, int, void* data) override
    {
        const std::size_t size = TypeDesc(m_row.type).size();
        const std::size_t texel = m_row.tenBits ? 4 : size * std::size_t(m_row.channels + m_row.spare);
        std::vector<char> row(std::size_t(m_spec.width) * texel);
        m_file.seekg(std::streamoff(m_start + std::size_t(y) * row.size()));
        if (!m_file.read(row.data(), std::streamsize(row.size()))) {
            errorfmt("the file ends too early");
            return false;
        }
        char* out = static_cast<char*>(data);
        for (std::size_t x = 0; x < std::size_t(m_spec.width); ++x)
            for (std::size_t c = 0; c < std::size_t(m_row.channels); ++c, out += size) {
                const std::size_t from = m_row.blueFirst && c < 3 ? 2 - c : c;
                if (m_row.tenBits)
                    putTenBits(row.data() + x * texel, from, out);
                else
                    std::memcpy(out, row.data() + x * texel + from * size, size);
            }
        return true;
    }

private:
    static void putTenBits(const char* texel, std::size_t channel, char* out)
    {
        std::uint32_t packed;
        std::memcpy(&packed, texel, sizeof packed);
        const std::uint32_t most = channel < 3 ? 1023 : 3, value = packed >> (10 * channel) & most;
        const auto wide = std::uint16_t((value * 65535 + most / 2) / most);
        std::memcpy(out, &wide, sizeof wide);
    }

    PlainRow m_row;
    std::size_t m_start;
    std::ifstream m_file;
};

// Endpoints of signed blocks count from -127 to 127: shifted by 128 they are those of unsigned ones, in the same order.
void shiftSigned(std::span<std::byte> blocks)
{
    for (std::size_t at = 0; at + 1 < blocks.size(); at += 8) {
        blocks[at] ^= std::byte(0x80);
        blocks[at + 1] ^= std::byte(0x80);
    }
}

std::shared_ptr<MemoryFile> rewritten(const std::string& file, const Header& header, const BlockRow& row)
{
    auto copy = std::make_shared<MemoryFile>();
    copy->append(header.renamed(row));
    std::ifstream in(file, std::ios::binary);
    in.seekg(std::streamoff(header.size()));
    std::vector<std::byte> block(std::size_t(1) << 20);
    while (in.read(reinterpret_cast<char*>(block.data()), std::streamsize(block.size())), in.gcount() > 0) {
        const std::span part(block.data(), std::size_t(in.gcount()));
        if (row.isSigned)
            shiftSigned(part);
        copy->append(part);
    }
    return copy;
}
} // namespace

Refusal unknownDds(const std::string& kind)
{
    return {"this kind of DDS (" + kind + ") is not read", "Convert it to PNG or EXR"};
}

tl::expected<DdsPlan, Refusal> planDds(const std::string& file)
{
    const Header header(file);
    DdsPlan plan{nullptr, nullptr, header.isPremultiplied(), header.kind()};
    const std::uint32_t dxgi = header.whole() ? header.dxgi() : 0;
    if (dxgi == 0 && header.whole() && header.isLong())
        return tl::unexpected(unknownDds(header.kind()));
    if (dxgi == 0 && header.isSigned())
        return tl::unexpected(unknownDds(header.kind()));
    if (dxgi == 0)
        return plan;
    if (!header.isFlat())
        return tl::unexpected(Refusal{"this DDS holds a cube, a volume or several pictures", "Export one picture of it as PNG or EXR"});
    if (const auto row = std::ranges::find(kPlain, dxgi, &PlainRow::dxgi); row != kPlain.end())
        plan.input = std::make_unique<PlainPixels>(*row, header);
    else if (const auto block = std::ranges::find(kBlocks, dxgi, &BlockRow::dxgi); block != kBlocks.end())
        plan.rewritten = rewritten(file, header, *block);
    else
        return tl::unexpected(unknownDds(header.kind()));
    return plan;
}

} // namespace relievo::imageio
