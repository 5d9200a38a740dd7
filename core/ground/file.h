// Whole files in and out: writes are atomic (beside, flushed, renamed).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

// `file` from the root on, without "." and ".." (which is the parent of where a link leads); as it was given when there is no
// working folder.
std::filesystem::path absolutePath(const std::filesystem::path& file);

// Errors say whether the file is missing, a folder, a pipe or device, unreadable or over `limit` bytes.
Expected<std::string> readText(const std::filesystem::path& file, std::size_t limit = std::size_t(1) << 30);
Expected<std::vector<std::byte>> readBytes(const std::filesystem::path& file, std::size_t limit = std::size_t(2) << 30);

// The old file stays whole until the new one is: disk full, no permission and a missing folder leave it as it was and no litter.
// The new file has the rights of the old one. A symbolic link stays one: its target is replaced, or made. Devices and pipes (/dev/stdout,
// /dev/null) are written to, never replaced.
// What a crash leaves behind lies beside the file and bears kTemporaryName, its X replaced by letters and digits.
inline constexpr std::string_view kTemporaryName = ".relievo-XXXXXX";
Expected<void> writeAtomically(const std::filesystem::path& file, std::span<const std::byte> bytes);
Expected<void> writeAtomically(const std::filesystem::path& file, std::string_view text);

} // namespace relievo
