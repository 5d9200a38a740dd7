// Running out of memory as an error, for whatever makes maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <new>
#include <string>
#include <string_view>

namespace relievo {

// What `work` returns, an Expected; an error when its memory does not suffice. `map`: key of the row it makes.
template <class Work> auto withinMemory(std::string_view map, Work work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return failure(ErrorCode::NoMemory, std::string(map), "there is not enough memory to bake this map", "Use a smaller height map");
    }
}

} // namespace relievo
