// Hashing with xxHash.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/hash.h"
#include <xxhash.h>

namespace relievo {

std::string hexHash(std::span<const std::byte> bytes)
{
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
    std::string text;
    for (const unsigned char digit : canonical.digest) {
        text += "0123456789abcdef"[digit >> 4];
        text += "0123456789abcdef"[digit & 15];
    }
    return text;
}

} // namespace relievo
