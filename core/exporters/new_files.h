// The files that an export of several files makes: gone again when it fails half-way.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <filesystem>
#include <vector>

namespace relievo {

// Removes what it was told of unless keep() was called; what was there before is left alone (a folder also when others use it).
class NewFiles {
public:
    NewFiles() = default;
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;
    ~NewFiles()
    {
        std::error_code code;
        for (; !m_paths.empty(); m_paths.pop_back())
            std::filesystem::remove(m_paths.back(), code);
    }
    void willMake(const std::filesystem::path& path) // a file or a folder, before it is written
    {
        std::error_code code;
        if (!std::filesystem::exists(path, code))
            m_paths.push_back(path);
    }
    // Makes the folder and those above it that are missing.
    Expected<void> makeFolder(const std::filesystem::path& folder)
    {
        std::error_code code;
        willMakeFolders(folder);
        std::filesystem::create_directories(folder, code);
        if (!folder.empty() && !std::filesystem::is_directory(folder, code))
            return failure(ErrorCode::NotWritable, folder.string(), "the folder cannot be made", "Choose a folder that you may write to");
        return {};
    }
    void keep() { m_paths.clear(); }

private:
    void willMakeFolders(const std::filesystem::path& folder) // it and those above it
    {
        if (folder.has_parent_path() && folder.parent_path() != folder)
            willMakeFolders(folder.parent_path());
        willMake(folder);
    }
    std::vector<std::filesystem::path> m_paths;
};

} // namespace relievo
