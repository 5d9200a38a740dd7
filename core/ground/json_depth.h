// How deep the values of a JSON text are nested, asked before it is read.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace relievo {

// Whether lists and objects lie in each other deeper than any honest file's: libraries copy and read values by recursion, and a
// text of 100 kB could use up the stack. Every JSON text from a file is asked before it is parsed. Takes any text.
bool isNestedTooDeep(std::string_view json);

} // namespace relievo
