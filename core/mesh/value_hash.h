// Keys of numbers for joining what is equal in value.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <cstring>

namespace relievo {

template <std::size_t N> using ValueKey = std::array<float, N>;

template <std::size_t N> struct ValueHash {
    std::size_t operator()(const ValueKey<N>& key) const
    {
        std::uint64_t h = 0xcbf29ce484222325u;
        for (const float value : key) {
            std::uint32_t bits;
            const float positive = value + 0.f; // -0 equals 0
            std::memcpy(&bits, &positive, sizeof bits);
            h = (h ^ bits) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        return std::size_t(h);
    }
};

} // namespace relievo
