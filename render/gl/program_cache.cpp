// Linking programs once, and again when their files change.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/program_cache.h"
#include <algorithm>
#include <cstdlib>

namespace relievo {
namespace fs = std::filesystem;

namespace {
// Newest change of any file under the folder.
fs::file_time_type newestIn(const fs::path& folder)
{
    fs::file_time_type newest = fs::file_time_type::min();
    std::error_code code;
    for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
        if (const auto time = entry->last_write_time(code); !code)
            newest = std::max(newest, time);
    return newest;
}
} // namespace

ProgramCache::ProgramCache()
{
    if (const char* folder = std::getenv("RELIEVO_SHADERS"); folder && *folder)
        m_folder = folder;
}

ShaderReader ProgramCache::reader() const
{
    return m_folder ? folderReader(*m_folder) : embeddedReader();
}

bool ProgramCache::changed() const
{
    return m_folder && newestIn(*m_folder) != m_seen;
}

bool ProgramCache::reload()
{
    if (!changed())
        return false;
    m_seen = newestIn(*m_folder);
    for (auto& [features, entry] : m_entries)
        if (entry.program)
            m_older[features] = std::move(entry);
    m_entries.clear();
    return true;
}

const LinkedProgram* ProgramCache::get(
    const std::string& features, const std::function<Expected<ProgramText>(const ShaderReader&)>& text, std::optional<Error>& error)
{
    auto [found, isNew] = m_entries.try_emplace(features);
    Entry& entry = found->second;
    if (isNew) {
        const Expected<ProgramText> assembled = text(reader());
        Expected<LinkedProgram> linked = assembled ? LinkedProgram::link(*assembled) : tl::unexpected(assembled.error());
        if (linked)
            entry.program = std::move(*linked);
        else
            entry.error = linked.error();
    }
    if (entry.program)
        return &*entry.program;
    error = entry.error;
    const auto older = m_older.find(features);
    return older == m_older.end() ? nullptr : &*older->second.program;
}

} // namespace relievo
