// The programs of a renderer: linked once for each set of features, and again when the shader files change.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "render/gl/program.h"
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace relievo {

class ProgramCache {
public:
    ProgramCache(); // reads RELIEVO_SHADERS

    // Whether files of the shader folder changed since reload().
    bool changed() const;
    // Forgets what was linked from files that changed since, and says whether there were any; the last good program of each kind is kept
    // for when the new text is broken.
    bool reload();

    // The program for `features`. When it does not link, `error` is set and the last one
    // of the same features that did is returned, or nothing. A text that does not link is tried once, not at every picture.
    const LinkedProgram* get(
        const std::string& features, const std::function<Expected<ProgramText>(const ShaderReader&)>& text, std::optional<Error>& error);

private:
    struct Entry {
        std::optional<LinkedProgram> program;
        std::optional<Error> error;
    };
    ShaderReader reader() const;

    std::map<std::string, Entry> m_entries, m_older;
    std::optional<std::filesystem::path> m_folder;
    std::filesystem::file_time_type m_seen = std::filesystem::file_time_type::min();
};

} // namespace relievo
