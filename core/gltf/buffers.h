// The files that a .gltf keeps beside it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <vector>

namespace relievo {

// Those that hold its numbers, with their folder; none of other files, nor of one that cannot be read.
std::vector<std::filesystem::path> buffersBeside(const std::filesystem::path& file);

} // namespace relievo
