// How the files of a State were when they were read, so that a later look tells which have changed.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace relievo {

// What the system tells of a file without reading it. Two that are equal are of the same contents, as far as can be known so.
struct FileStamp {
    bool isThere = false;
    std::int64_t size = 0; // bytes
    std::int64_t modified = 0, replaced = 0; // ns: of the contents, and of anything (a rename over it, its rights)
    bool operator==(const FileStamp&) const = default;
};

// By name as it stands in a State: "FILE.glb#N" and "FILE.exr#LAYER" are stamped as the file that they lie in (fileOfPicture).
using FileStamps = std::map<std::string, FileStamp>;
using FileNames = std::set<std::string>;

FileStamp stampOf(const std::string& name);
FileStamps stampsOf(const State& state); // of all files that it names, and what a .gltf keeps beside it; what is built in is none
FileStamps stampsIn(const std::filesystem::path& folder);
FileNames namesOf(const FileStamps& stamps);
FileNames changedSince(const FileStamps& stamps);

} // namespace relievo
