// A driver's messages with the names of our files in them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/program_text.h"
#include <algorithm>
#include <cctype>

namespace relievo {

namespace {

std::string_view digitsAt(std::string_view text, std::size_t at)
{
    std::size_t end = at;
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])))
        ++end;
    return text.substr(std::min(at, text.size()), end - at);
}

// A place in a driver's log, "2:17" or "2:17(5)": file, line and column.
struct LogPlace {
    std::string_view file, line;
    std::size_t length = 0; // 0: there is none
};
LogPlace placeAt(std::string_view log, std::size_t at)
{
    LogPlace place{digitsAt(log, at), {}, 0};
    std::size_t end = at + place.file.size();
    if (place.file.empty() || end >= log.size() || log[end] != ':')
        return place;
    place.line = digitsAt(log, end + 1);
    if (place.line.empty())
        return place;
    end += 1 + place.line.size();
    if (end < log.size() && log[end] == '(')
        if (const std::string_view column = digitsAt(log, end + 1); !column.empty() && log.substr(end + 1 + column.size()).starts_with(')'))
            end += column.size() + 2;
    place.length = end - at;
    return place;
}

} // namespace

std::string namedLog(const std::string& log, const ShaderText& text)
{
    std::string out;
    for (std::size_t at = 0; at < log.size();) {
        const LogPlace place = placeAt(log, at);
        if (place.length > 0) {
            const std::size_t index = std::stoul(std::string(place.file.substr(0, 6)));
            out += index < text.files.size() ? text.files[index] : std::string(place.file);
            out += ':' + std::string(place.line);
        }
        const std::size_t plain = place.length > 0 ? 0 : std::max<std::size_t>(place.file.size(), 1);
        out += log.substr(at, plain);
        at += std::max(place.length, plain);
    }
    return out;
}

} // namespace relievo
