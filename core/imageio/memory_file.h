// A file that lives in memory and has a path, for libraries that want one.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace relievo::imageio {

class MemoryFile {
public:
    MemoryFile(); // ok() is false when the system refuses
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    bool ok() const { return m_ok; } // nothing failed so far
    std::string path() const; // valid as long as this lives, in this process
    void append(std::span<const std::byte> bytes);
    std::size_t readAt(std::size_t offset, std::span<std::byte> bytes) const; // bytes read, 0 at the end

private:
    int m_handle = -1;
    bool m_ok = false;
};

} // namespace relievo::imageio
