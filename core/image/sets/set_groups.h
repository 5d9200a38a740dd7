// Sorting a folder's images into sets by their names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/sets/file_names.h"
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace relievo {

// Of a file that bears the set's name and no kind.
inline constexpr int kNoKindRank = 99;

struct NamedFile {
    std::filesystem::path file;
    NameGuess guess; // roles are empty where the name says nothing or siblings do not agree
};

struct FileGroup {
    std::string stem, title; // as in NameGuess
    std::vector<NamedFile> files; // that name a kind
    std::vector<NamedFile> plain; // named like the set itself, without a kind: a colour map where there is no other
    int kinds() const; // different map kinds
    bool holds(MapKind kind) const;
    bool contains(const std::filesystem::path& file) const;
};

// Groups with kinds first, the most complete one foremost (then one with a height map, then by name); each file stands in one group.
std::vector<FileGroup> groupFiles(std::span<const std::filesystem::path> files);

} // namespace relievo
