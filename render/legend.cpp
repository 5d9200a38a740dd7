// A small legend with its own few glyphs: the command line links no font.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/legend.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>

namespace relievo {

namespace {

// Rows of 5 pixels from the top, 7 rows, one character a pixel row ('#' set). Only what legends write.
struct Glyph {
    char character;
    std::array<const char*, 7> rows;
};
constexpr Glyph kGlyphs[] = {
    {'0', {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "  ## ", " #   ", "#    ", "#####"}},
    {'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {" ### ", "#    ", "#### ", "#   #", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "    #", " ### "}},
    {'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    {'c', {"     ", "     ", " ### ", "#    ", "#    ", "#    ", " ### "}},
    {'d', {"    #", "    #", " ####", "#   #", "#   #", "#   #", " ####"}},
    {'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### "}},
    {'f', {"  ## ", " #   ", "###  ", " #   ", " #   ", " #   ", " #   "}},
    {'h', {"#    ", "#    ", "#### ", "#   #", "#   #", "#   #", "#   #"}},
    {'i', {"  #  ", "     ", " ##  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'l', {" ##  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'p', {"     ", "#### ", "#   #", "#   #", "#### ", "#    ", "#    "}},
    {'s', {"     ", "     ", " ####", "#    ", " ### ", "    #", "#### "}},
    {'t', {" #   ", " #   ", "###  ", " #   ", " #   ", " #   ", "  ## "}},
    {'x', {"     ", "     ", "#   #", " # # ", "  #  ", " # # ", "#   #"}},
};
constexpr int kAdvance = 6, kGlyphHeight = 7;

void put(Image& picture, int x, int y, glm::vec3 color)
{
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height)
        return;
    const std::size_t at = (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 4;
    for (std::size_t c = 0; c < 3; ++c)
        picture.data[at + c] = std::byte(std::lround(255.f * color[int(c)]));
    picture.data[at + 3] = std::byte(255);
}

int textWidth(std::string_view text, int scale)
{
    return int(text.size()) * kAdvance * scale;
}

void write(Image& picture, int x, int y, int scale, std::string_view text)
{
    for (const char character : text) {
        const auto glyph = std::ranges::find(kGlyphs, character, &Glyph::character);
        for (int row = 0; glyph != std::end(kGlyphs) && row < kGlyphHeight * scale; ++row)
            for (int column = 0; column < 5 * scale; ++column)
                if (glyph->rows[std::size_t(row / scale)][column / scale] == '#')
                    put(picture, x + column, y + row, glm::vec3(0.92f));
        x += kAdvance * scale;
    }
}

std::string numberText(float value)
{
    char buffer[32];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 3).ptr);
}

} // namespace

void drawLegend(Image& picture, float range, std::string_view unit)
{
    if (picture.width < 160 || picture.height < 60 || picture.channels != 4 || picture.type != PixelType::U8)
        return;
    const int scale = picture.height >= 600 ? 2 : 1, margin = 8 * scale;
    const int width = std::min(picture.width / 3, 240 * scale), barHeight = 8 * scale;
    const int top = picture.height - margin - barHeight - (kGlyphHeight + 4) * scale;
    const std::string last = numberText(range) + ' ' + std::string(unit);
    for (int y = top - margin / 2; y < picture.height - margin / 2; ++y) // a quiet plate under bar and numbers
        for (int x = margin / 2; x < margin + width + textWidth(last, scale); ++x)
            put(picture, x, y, glm::vec3(0.11f));
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < barHeight; ++y)
            put(picture, margin + x, top + y, heatColor((float(x) + 0.5f) / float(width)));
    const int baseline = top + barHeight + 4 * scale;
    write(picture, margin, baseline, scale, "0");
    const std::string half = numberText(0.5f * range);
    write(picture, margin + width / 2 - textWidth(half, scale) / 2, baseline, scale, half);
    write(picture, margin + width - textWidth(numberText(range), scale) / 2, baseline, scale, last);
}

} // namespace relievo
