// The table of image formats: how each is recognised, and what it can hold when written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace relievo::imageio {

struct FormatRow {
    std::string_view name; // OpenImageIO's
    std::string_view label; // in messages
    std::string_view suffixes; // lower case, space separated
    std::string_view magic; // first bytes; '?' matches any; "" when the format has none
    std::string_view channels; // counts that can be written, "" when it is only read
    int integerBits; // largest integer depth that can be written, 0 none
    bool floats; // float can be written
};

inline constexpr auto kFormats = std::to_array<FormatRow>({
    {"png", "PNG", "png", "\x89PNG\r\n\x1a\n", "1234", 16, false},
    {"jpeg", "JPEG", "jpg jpeg", "\xff\xd8\xff", "13", 8, false},
    {"tiff", "TIFF", "tif tiff tx", std::string_view("II*\0", 4), "1234", 16, true},
    {"tiff", "TIFF", "", std::string_view("MM\0*", 4), "", 0, false},
    {"tiff", "TIFF", "", std::string_view("II+\0", 4), "", 0, false},
    {"tiff", "TIFF", "", std::string_view("MM\0+", 4), "", 0, false},
    {"openexr", "EXR", "exr", "\x76\x2f\x31\x01", "1234", 0, true},
    {"hdr", "HDR", "hdr rgbe", "#?", "3", 0, true},
    {"dds", "DDS", "dds", "DDS ", "", 0, false},
    {"bmp", "BMP", "bmp", "BM", "134", 8, false},
    {"webp", "WebP", "webp", "RIFF????WEBP", "", 0, false},
    {"psd", "PSD", "psd", "8BPS", "", 0, false},
    {"pnm", "PNM", "pnm ppm pgm pbm", "P1", "", 0, false},
    {"pnm", "PNM", "", "P2", "", 0, false},
    {"pnm", "PNM", "", "P3", "", 0, false},
    {"pnm", "PNM", "", "P4", "", 0, false},
    {"pnm", "PNM", "", "P5", "", 0, false},
    {"pnm", "PNM", "", "P6", "", 0, false},
    {"targa", "TGA", "tga tpic", "", "134", 8, false},
});

// By the first bytes; a file without known magic is a TGA only when its suffix says so. nullptr: not an image we read.
const FormatRow* recognise(std::span<const std::byte> start, std::string_view suffix);
const FormatRow* formatToWrite(std::string_view suffix); // nullptr when it is not written
const FormatRow* formatOfSuffix(std::string_view suffix);

} // namespace relievo::imageio
