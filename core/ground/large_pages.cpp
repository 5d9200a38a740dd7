// Memory for maps comes in large pages where the system has them: touching it first by small ones takes longer than decoding it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sys/mman.h>

#ifndef __SANITIZE_ADDRESS__ // which has an operator of its own

namespace {
constexpr std::size_t kPage = std::size_t(2) << 20; // bytes
constexpr std::size_t kLarge = 2 * kPage; // from here on

void* allocated(std::size_t size)
{
    if (size < kLarge || size > SIZE_MAX - kPage)
        return std::malloc(size > 0 ? size : 1);
    void* memory = std::aligned_alloc(kPage, (size + kPage - 1) / kPage * kPage);
    if (memory)
        ::madvise(memory, size, MADV_HUGEPAGE); // a wish
    return memory;
}
} // namespace

// In the place of the standard library's for the whole program.
void* operator new(std::size_t size)
{
    for (;;) {
        if (void* memory = allocated(size))
            return memory;
        const std::new_handler handler = std::get_new_handler();
        if (!handler)
            throw std::bad_alloc();
        handler();
    }
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

#endif
