// Counting brackets outside of strings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/json_depth.h"
#include <cstddef>

namespace relievo {

bool isNestedTooDeep(std::string_view json)
{
    constexpr int kMostDepth = 256;
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (inString) {
            if (json[i] == '\\')
                ++i; // whatever follows is part of the string
            else if (json[i] == '"')
                inString = false;
        } else if (json[i] == '"') {
            inString = true;
        } else if (json[i] == '{' || json[i] == '[') {
            if (++depth > kMostDepth)
                return true;
        } else if (json[i] == '}' || json[i] == ']') {
            --depth;
        }
    }
    return false;
}

} // namespace relievo
