// Text in pictures, without a window system: FreeType and a font that is installed.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/image.h"
#include <glm/vec3.hpp>
#include <memory>
#include <string_view>

namespace relievo::cli {

class TextPainter {
public:
    // Errors: no font was found; says which package brings one.
    static Expected<TextPainter> create();
    TextPainter(TextPainter&&) noexcept;
    ~TextPainter();

    struct Style {
        int pixels = 14; // height of the em
        bool bold = false;
        glm::vec3 color{0.9f}; // display values
    };
    // UTF-8 text with its baseline's left end at (x, y), into an RGBA U8 picture; parts outside are cut off.
    void draw(Image& picture, int x, int y, const Style& style, std::string_view text) const;
    int width(const Style& style, std::string_view text) const; // pixels

private:
    struct Impl;
    explicit TextPainter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m;
};

} // namespace relievo::cli
