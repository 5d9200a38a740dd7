// Looking up a row of the export table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include <algorithm>

namespace relievo {

const ExportRow* findExport(std::string_view key)
{
    const auto found = std::ranges::find(kExports, key, &ExportRow::key);
    return found == kExports.end() ? nullptr : &*found;
}

Expected<void> refuseToOverwriteSources(const ExportJob& job, const std::filesystem::path& file)
{
    const auto same = [&](const std::string& source) {
        std::error_code code;
        return !source.empty() && std::filesystem::equivalent(source, file, code);
    };
    if (same(job.state.mesh) || same(job.state.environment) || std::ranges::any_of(job.state.slots, same, &MapSlot::file))
        return failure(file.string(), "this file is what the material was opened from", "Export to another folder or name");
    return {};
}

} // namespace relievo
