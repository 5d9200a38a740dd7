// TIFF and DDS files made byte by byte, as other programs write them and no library of ours does.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace relievo::test {

// The bytes of numbers, little-endian.
template <class T> std::string bytesOfAll(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

struct TiffTag {
    std::uint16_t id, type; // type 2 text, 3 short, 4 long, 12 double
    std::uint32_t count;
    std::string bytes;
};
inline TiffTag shortTag(std::uint16_t id, std::uint16_t value)
{
    return {id, 3, 1, bytesOfAll<std::uint16_t>({value, 0})};
}
inline TiffTag doublesTag(std::uint16_t id, const std::vector<double>& values)
{
    return {id, 12, std::uint32_t(values.size()), bytesOfAll(values)};
}
inline TiffTag shortsTag(std::uint16_t id, const std::vector<std::uint16_t>& values)
{
    return {id, 3, std::uint32_t(values.size()), bytesOfAll(values)};
}

// One strip of one channel. photometric: 0 white is the smallest number, 1 black. format: 1 whole, 2 signed, 3 float.
// `more`: further tags, ascending, with numbers over 339.
inline std::string tiff(
    int width, int height, int bits, int format, int photometric, const std::string& pixels, const std::vector<TiffTag>& more = {})
{
    std::vector<TiffTag> tags = {shortTag(256, std::uint16_t(width)), shortTag(257, std::uint16_t(height)),
        shortTag(258, std::uint16_t(bits)), shortTag(259, 1), shortTag(262, std::uint16_t(photometric)),
        {273, 4, 1, bytesOfAll<std::uint32_t>({8})}, shortTag(277, 1), shortTag(278, std::uint16_t(height)),
        {279, 4, 1, bytesOfAll<std::uint32_t>({std::uint32_t(pixels.size())})}, shortTag(339, std::uint16_t(format))};
    tags.insert(tags.end(), more.begin(), more.end());
    std::string data = pixels + std::string(pixels.size() % 2, '\0'), table = bytesOfAll<std::uint16_t>({std::uint16_t(tags.size())});
    for (const TiffTag& tag : tags) {
        table += bytesOfAll<std::uint16_t>({tag.id, tag.type}) + bytesOfAll<std::uint32_t>({tag.count});
        if (tag.bytes.size() <= 4) {
            table += (tag.bytes + std::string(4, '\0')).substr(0, 4);
        } else {
            table += bytesOfAll<std::uint32_t>({std::uint32_t(8 + data.size())});
            data += tag.bytes + std::string(tag.bytes.size() % 2, '\0');
        }
    }
    const std::uint32_t at = std::uint32_t(8 + data.size());
    return std::string("II*\0", 4) + bytesOfAll<std::uint32_t>({at}) + data + table + std::string(4, '\0');
}

// Under a header with a number of DXGI.
inline std::string dds(int width, int height, std::uint32_t dxgi, const std::string& pixels)
{
    std::vector<std::uint32_t> header(37, 0);
    std::memcpy(header.data(), "DDS ", 4);
    header[1] = 124, header[2] = 0x1007, header[3] = std::uint32_t(height), header[4] = std::uint32_t(width);
    header[19] = 32, header[20] = 0x4; // four characters follow
    std::memcpy(&header[21], "DX10", 4);
    header[27] = 0x1000, header[32] = dxgi, header[33] = 3, header[35] = 1;
    return bytesOfAll(header) + pixels;
}

// Under an old header: flags 0x4 four characters or a number of Direct3D, 0x40 masks of colours, 0x20000 one of luminance.
inline std::string oldDds(int width, int height, std::uint32_t flags, std::uint32_t name, std::uint32_t bits,
    const std::vector<std::uint32_t>& masks, const std::string& pixels)
{
    std::vector<std::uint32_t> header(32, 0);
    std::memcpy(header.data(), "DDS ", 4);
    header[1] = 124, header[2] = 0x1007, header[3] = std::uint32_t(height), header[4] = std::uint32_t(width);
    header[19] = 32, header[20] = flags, header[21] = name, header[22] = bits;
    for (std::size_t i = 0; i < masks.size(); ++i)
        header[23 + i] = masks[i];
    header[27] = 0x1000;
    return bytesOfAll(header) + pixels;
}

} // namespace relievo::test
