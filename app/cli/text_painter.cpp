// Glyphs from FreeType, blended into the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/text_painter.h"
#include <cmath>
#include <filesystem>
#include <ft2build.h>
#include <string>
#include FT_FREETYPE_H

namespace relievo::cli {

namespace {
struct FontRow {
    const char *regular, *bold;
};
// Where distributions put fonts with tabular digits.
constexpr FontRow kFonts[] = {{"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
    {"/usr/share/fonts/noto/NotoSans-Regular.ttf", "/usr/share/fonts/noto/NotoSans-Bold.ttf"},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"}};

// The next code point of valid UTF-8; anything else reads byte by byte.
char32_t nextCharacter(std::string_view& text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(0);
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 1;
    char32_t character = length == 1 ? first : first & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i)
        character = character << 6 | (byte(i) & 0x3fu);
    text.remove_prefix(std::min(length, text.size()));
    return character;
}
} // namespace

struct TextPainter::Impl {
    FT_Library library = nullptr;
    FT_Face regular = nullptr, bold = nullptr;
    ~Impl()
    {
        if (library)
            FT_Done_FreeType(library); // the faces with it
    }

    // Calls paint(glyph, x) for each glyph, returns the width.
    template <class Paint> int layOut(const Style& style, std::string_view text, Paint paint) const
    {
        const FT_Face face = style.bold ? bold : regular;
        FT_Set_Pixel_Sizes(face, 0, FT_UInt(style.pixels));
        FT_Pos x = 0; // 1/64 pixel
        while (!text.empty()) {
            if (FT_Load_Char(face, nextCharacter(text), FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT))
                continue;
            paint(*face->glyph, int(x / 64));
            x += face->glyph->advance.x;
        }
        return int((x + 63) / 64);
    }
};

TextPainter::TextPainter(std::unique_ptr<Impl> impl) : m(std::move(impl)) { }
TextPainter::TextPainter(TextPainter&&) noexcept = default;
TextPainter::~TextPainter() = default;

Expected<TextPainter> TextPainter::create()
{
    auto impl = std::make_unique<Impl>();
    if (FT_Init_FreeType(&impl->library))
        return failure("FreeType", "it does not start", "Install libfreetype6 anew");
    for (const FontRow& font : kFonts) {
        std::error_code code;
        if (std::filesystem::exists(font.regular, code) && !FT_New_Face(impl->library, font.regular, 0, &impl->regular)) {
            if (FT_New_Face(impl->library, font.bold, 0, &impl->bold))
                impl->bold = impl->regular;
            return TextPainter(std::move(impl));
        }
    }
    return failure("fonts", "there is no font for the captions", "Install one (Debian: fonts-noto-core)");
}

void TextPainter::draw(Image& picture, int x, int y, const Style& style, std::string_view text) const
{
    const auto blend = [&](int column, int row, float coverage) {
        if (column < 0 || row < 0 || column >= picture.width || row >= picture.height)
            return;
        const std::size_t at = (std::size_t(row) * std::size_t(picture.width) + std::size_t(column)) * 4;
        for (std::size_t c = 0; c < 3; ++c) {
            const float old = float(std::to_integer<int>(picture.data[at + c]));
            picture.data[at + c] = std::byte(std::lround(old + coverage * (255.f * style.color[int(c)] - old)));
        }
        picture.data[at + 3] = std::byte(255);
    };
    m->layOut(style, text, [&](const FT_GlyphSlotRec& glyph, int advance) {
        for (int row = 0; row < int(glyph.bitmap.rows); ++row)
            for (int column = 0; column < int(glyph.bitmap.width); ++column)
                blend(x + advance + glyph.bitmap_left + column, y - glyph.bitmap_top + row,
                    float(glyph.bitmap.buffer[row * glyph.bitmap.pitch + column]) / 255.f);
    });
}

int TextPainter::width(const Style& style, std::string_view text) const
{
    return m->layOut(style, text, [](const FT_GlyphSlotRec&, int) {});
}

} // namespace relievo::cli
