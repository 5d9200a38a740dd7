// What the names in a folder decide before any file is opened.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/sets/set_groups.h"
#include <filesystem>
#include <string>
#include <vector>

namespace relievo {

struct SetPlan {
    std::string name;
    std::filesystem::path folder;
    std::vector<NamedFile> files; // each with at least one role
    Warnings warnings;
};

// Whether the file is a picture by its suffix (and, of .hdr, no header of elevation data).
bool isPicture(const std::filesystem::path& file);

// source: absolute. Errors as openTextureSet.
Expected<SetPlan> planSource(const std::filesystem::path& source);

// "a, b, c and 4 more"
std::string shortList(const std::vector<std::string>& names);

} // namespace relievo
