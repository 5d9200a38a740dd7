// Escaping and cutting foreign text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/shown_text.h"
#include <cstdint>
#include <cstdio>

namespace relievo {

namespace {
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0; // 0: what stands there is no UTF-8
};

Character characterAt(std::string_view text, std::size_t at)
{
    const auto byteAt = [text](std::size_t i) { return std::uint32_t(static_cast<unsigned char>(text[i])); };
    const std::uint32_t lead = byteAt(at);
    const std::size_t bytes = lead < 0x80 ? 1 : lead >= 0xF0 && lead < 0xF8 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 0;
    if (bytes == 0 || lead >= 0xF8 || at + bytes > text.size())
        return {};
    std::uint32_t code = bytes == 1 ? lead : lead & (0x7Fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        const std::uint32_t next = byteAt(at + i);
        if ((next & 0xC0) != 0x80)
            return {};
        code = code << 6 | (next & 0x3F);
    }
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000}; // shorter ones must be written shorter
    const bool isNone = code < kLeast[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000);
    return isNone ? Character{} : Character{code, bytes};
}

bool isObeyed(std::uint32_t code)
{
    const auto within = [code](std::uint32_t first, std::uint32_t last) { return code >= first && code <= last; };
    return code < 0x20 || within(0x7F, 0x9F) || within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069);
}

std::string escapeOf(std::uint32_t code)
{
    if (code == '\n' || code == '\r' || code == '\t')
        return code == '\n' ? "\\n" : code == '\r' ? "\\r" : "\\t";
    char text[16];
    std::snprintf(text, sizeof text, code < 0x80 ? "\\x%02X" : "\\u{%X}", unsigned(code));
    return text;
}

// The first position at or after `at` where a character may begin.
std::size_t startAfter(std::string_view text, std::size_t at)
{
    for (std::size_t i = 0; i < 3 && at < text.size() && (text[at] & 0xC0) == 0x80; ++i)
        ++at;
    return at;
}
std::size_t startBefore(std::string_view text, std::size_t at)
{
    for (std::size_t i = 0; i < 3 && at > 0 && at < text.size() && (text[at] & 0xC0) == 0x80; ++i)
        --at;
    return at;
}
} // namespace

std::string escaped(std::string_view text)
{
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = characterAt(text, at);
        if (character.bytes == 0) {
            char byte[8];
            std::snprintf(byte, sizeof byte, "\\x%02X", unsigned(static_cast<unsigned char>(text[at])));
            out += byte;
        } else if (isObeyed(character.code)) {
            out += escapeOf(character.code);
        } else {
            out += text.substr(at, character.bytes);
        }
        at += character.bytes == 0 ? 1 : character.bytes;
    }
    return out;
}

std::string shownName(std::string_view name)
{
    constexpr std::size_t kMost = 80;
    return name.size() > kMost ? escaped(name.substr(0, startBefore(name, kMost - 3))) + "..." : escaped(name);
}

std::string shownText(std::string_view text, std::size_t most)
{
    if (text.size() <= most)
        return escaped(text);
    return escaped(text.substr(0, startBefore(text, most / 2))) + " ... " + escaped(text.substr(startAfter(text, text.size() - most / 2)));
}

} // namespace relievo
