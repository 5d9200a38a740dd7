// Unicode forms by utf8proc, code pages by iconv.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include <algorithm>
#include <cstdlib>
#include <iconv.h>
#include <memory>
#include <utf8proc.h>
#include <vector>

namespace relievo {
namespace fs = std::filesystem;

std::optional<std::string> fromCodePage(const char* page, std::string_view bytes)
{
    const iconv_t converter = ::iconv_open("UTF-8", page);
    if (converter == iconv_t(-1))
        return std::nullopt;
    std::string in(bytes), out(bytes.size() * 4, '\0');
    char *from = in.data(), *to = out.data();
    std::size_t left = in.size(), room = out.size();
    const bool done = ::iconv(converter, &from, &left, &to, &room) != std::size_t(-1);
    ::iconv_close(converter);
    out.resize(out.size() - room);
    return done ? std::optional(out) : std::nullopt;
}

namespace {
// What Windows and old archives wrote names in, by how often artists meet them.
constexpr const char* kCodePages[] = {"CP1252", "CP932", "GB18030", "BIG5", "CP949", "CP1251", "CP1250", "CP437", "CP850"};

bool isAscii(std::string_view text)
{
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

// Nothing for bytes that are no UTF-8.
std::optional<std::string> mapped(std::string_view text, int options)
{
    utf8proc_uint8_t* out = nullptr;
    const utf8proc_ssize_t size = utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()), utf8proc_ssize_t(text.size()), &out,
        utf8proc_option_t(options | UTF8PROC_STABLE | UTF8PROC_COMPOSE));
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(out, &std::free);
    if (size < 0)
        return std::nullopt;
    return std::string(reinterpret_cast<const char*>(out), std::size_t(size));
}

// Exporters write _ for spaces.
std::string withoutSpaces(std::string text)
{
    std::ranges::replace(text, ' ', '_');
    return text;
}

// How the bytes may be meant, folded.
std::vector<std::string> readingsOf(std::string_view bytes)
{
    std::vector<std::string> readings = {withoutSpaces(folded(bytes))};
    if (isAscii(bytes) || mapped(bytes, 0))
        return readings;
    for (const char* page : kCodePages)
        if (const std::optional<std::string> text = fromCodePage(page, bytes))
            readings.push_back(withoutSpaces(folded(*text)));
    return readings;
}
} // namespace

std::string composed(std::string_view text)
{
    return isAscii(text) ? std::string(text) : mapped(text, 0).value_or(std::string(text));
}

std::string folded(std::string_view text)
{
    if (isAscii(text))
        return lowered(text);
    return mapped(text, UTF8PROC_CASEFOLD | UTF8PROC_COMPAT | UTF8PROC_IGNORE | UTF8PROC_LUMP).value_or(lowered(text));
}

bool looksAlike(std::string_view a, std::string_view b)
{
    if (a == b)
        return true;
    const std::vector<std::string> left = readingsOf(a), right = readingsOf(b);
    return std::ranges::any_of(left, [&](const std::string& one) { return std::ranges::find(right, one) != right.end(); });
}

std::optional<fs::path> thatLooksLike(const fs::path& file)
{
    std::error_code code;
    if (fs::exists(file, code))
        return file;
    const std::string name = file.filename().string();
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (name.empty())
        return std::nullopt;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
        if (looksAlike(entry->path().filename().string(), name))
            return file.has_parent_path() ? entry->path() : entry->path().filename();
    return std::nullopt;
}

} // namespace relievo
