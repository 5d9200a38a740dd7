// Files of kinds that are known but not read: what they are, and what to do about it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <filesystem>
#include <optional>

namespace relievo {

// By its first bytes and its suffix. Nothing for a file that may be read, that is not there, or whose kind is unknown. The error names the
// kind and the cure, and never says that the file is damaged; NotFound: it only points to a file that was not fetched.
std::optional<Error> foreignFile(const std::filesystem::path& file);

} // namespace relievo
