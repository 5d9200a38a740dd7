// Small words: names and suffixes in any case.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace relievo {

// ASCII letters in lower case, all other bytes (UTF-8) as they are, in any locale.
inline std::string lowered(std::string_view text)
{
    std::string low(text);
    for (char& c : low)
        c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return low;
}

// ".png" of "A.PNG".
inline std::string lowerSuffix(const std::filesystem::path& file)
{
    return lowered(file.extension().string());
}

} // namespace relievo
