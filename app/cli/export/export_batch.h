// Exporting many sources: what each is and where it goes, and one process each, several at once.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace relievo::cli {

// The sources, folders that hold no pictures themselves replaced by those below them that do (sorted by name; each once, links that
// lead back are not followed).
std::vector<std::string> setsOf(const std::vector<std::string>& sources);

// A folder name for each source, different from each other.
std::vector<std::string> folderNames(const std::vector<std::string>& sources);

// Everything that decides what is written, hashed: the program, `options`, and the bytes of the source's files.
std::string contentHash(const std::string& source, const std::string& options);
// Where the hash of an output folder stands, and whether it is `hash` and all files that were written are still there.
std::filesystem::path hashFile(const std::filesystem::path& out);
bool isUpToDate(const std::filesystem::path& out, const std::string& hash);
Expected<void> rememberHash(const std::filesystem::path& out, const std::string& hash, const std::vector<std::filesystem::path>& files);

struct BatchTask {
    std::string source;
    std::vector<std::string> arguments; // of this program, which prints JSON
};
// The "exports" that the processes print, in the order of the tasks; of one that ended otherwise an entry with its error. At most `jobs`
// run at once. `done` is given the entries of each and its place as it ends, one after the other.
nlohmann::ordered_json runBatch(
    const std::vector<BatchTask>& tasks, int jobs, const std::function<void(const nlohmann::ordered_json&, std::size_t)>& done);

} // namespace relievo::cli
