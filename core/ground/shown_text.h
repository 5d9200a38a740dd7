// Foreign text as messages show it: names and values from files never reach a terminal as they are.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace relievo {

// What a terminal would obey or hide (control characters, line breaks, marks that turn the direction of writing, bytes that are no
// UTF-8) as \n, \x1B or \u{9B}; all else as it is.
std::string escaped(std::string_view text);

// A name, key or URI as messages show it: at most 80 bytes of it, escaped.
std::string shownName(std::string_view name);

// A clause or a whole message, escaped; of more than `most` bytes beginning and end, where the cure stands.
std::string shownText(std::string_view text, std::size_t most = 1200);

} // namespace relievo
