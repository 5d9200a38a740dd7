// Recognising image formats.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/formats.h"
#include <algorithm>

namespace relievo::imageio {
namespace {
bool listHas(std::string_view list, std::string_view word)
{
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(' ', at), list.size());
        if (list.substr(at, end - at) == word)
            return true;
        at = end + 1;
    }
    return false;
}

bool startsWith(std::span<const std::byte> start, std::string_view magic)
{
    return !magic.empty() && start.size() >= magic.size()
        && std::equal(magic.begin(), magic.end(), start.begin(),
            [](char wanted, std::byte found) { return wanted == '?' || std::byte(static_cast<unsigned char>(wanted)) == found; });
}
} // namespace

const FormatRow* recognise(std::span<const std::byte> start, std::string_view suffix)
{
    for (const FormatRow& row : kFormats)
        if (startsWith(start, row.magic))
            return &row;
    const FormatRow* named = formatOfSuffix(suffix);
    return named && named->magic.empty() ? named : nullptr;
}

const FormatRow* formatOfSuffix(std::string_view suffix)
{
    const auto found = std::ranges::find_if(kFormats, [&](const FormatRow& row) { return listHas(row.suffixes, suffix); });
    return found == kFormats.end() ? nullptr : &*found;
}

const FormatRow* formatToWrite(std::string_view suffix)
{
    const FormatRow* row = formatOfSuffix(suffix);
    return row && !row->channels.empty() ? row : nullptr;
}

} // namespace relievo::imageio
