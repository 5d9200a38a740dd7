// Looking up a row of the export table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/scene/inputs.h"
#include <algorithm>

namespace relievo {

const ExportRow* findExport(std::string_view key)
{
    const auto found = std::ranges::find(kExports, key, &ExportRow::key);
    return found == kExports.end() ? nullptr : &*found;
}

Expected<void> refuseToOverwriteSources(const ExportJob& job, const std::filesystem::path& file)
{
    std::vector<std::filesystem::path> read = filesOf(job.state);
    const auto add = [&read](const std::vector<std::filesystem::path>& more) { read.insert(read.end(), more.begin(), more.end()); };
    add(job.alsoRead);
    if (job.resources.mesh)
        for (const MeshMaterial& material : job.resources.mesh->materials)
            add(filesOf(material.maps));
    return refuseToReplace(read, file);
}

} // namespace relievo
