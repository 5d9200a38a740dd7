// Files in memory by memfd.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/memory_file.h"
#include <cerrno>
#include <sys/mman.h>
#include <unistd.h>

namespace relievo::imageio {

MemoryFile::MemoryFile() : m_handle(::memfd_create("relievo-image", MFD_CLOEXEC)), m_ok(m_handle >= 0) { }

MemoryFile::~MemoryFile()
{
    if (m_handle >= 0)
        ::close(m_handle);
}

std::string MemoryFile::path() const
{
    return "/proc/self/fd/" + std::to_string(m_handle);
}

void MemoryFile::append(std::span<const std::byte> bytes)
{
    while (m_ok && !bytes.empty()) {
        const ssize_t put = ::write(m_handle, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR)
            continue;
        m_ok = put > 0;
        bytes = bytes.subspan(m_ok ? std::size_t(put) : 0);
    }
}

std::size_t MemoryFile::readAt(std::size_t offset, std::span<std::byte> bytes) const
{
    const ssize_t got = ::pread(m_handle, bytes.data(), bytes.size(), off_t(offset));
    return got > 0 ? std::size_t(got) : 0;
}

} // namespace relievo::imageio
