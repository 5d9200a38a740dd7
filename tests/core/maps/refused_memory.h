// Memory that is refused while a test looks, by the size of the block. Its operator new stands in map_cache_test.cpp.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <cstddef>

namespace relievo::test {

// The sanitizers bring their own operator new: nothing is refused there.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kMemoryCanBeRefused = false;
#else
inline constexpr bool kMemoryCanBeRefused = true;
#endif

inline std::atomic<std::size_t> refusedFrom = 0, refusedTo = 0; // sizes in bytes; none at first

// No memory for blocks of [from, to) bytes while it lives.
struct RefusedMemory {
    RefusedMemory(std::size_t from, std::size_t to) { refusedFrom = from, refusedTo = to; }
    ~RefusedMemory() { refusedFrom = refusedTo = 0; }
};

} // namespace relievo::test
