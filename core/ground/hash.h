// A hash of bytes, as text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace relievo {

// 128 bits (xxHash) as 32 hexadecimal digits: equal for equal bytes, on every machine.
std::string hexHash(std::span<const std::byte> bytes);
inline std::string hexHash(std::string_view text)
{
    return hexHash(std::as_bytes(std::span(text)));
}

} // namespace relievo
