// Looking up a row of the export table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/exporters/engines/engine_export.h"
#include "core/scene/inputs.h"
#include <algorithm>

namespace relievo {

const ExportRow* findExport(std::string_view key)
{
    const auto found = std::ranges::find(kExports, key, &ExportRow::key);
    return found == kExports.end() ? nullptr : &*found;
}

Expected<Exported> ExportRow::run(const ExportJob& job) const
{
    return code ? code(job) : exportByText(*this, job);
}

std::vector<std::filesystem::path> ExportRow::writes(const ExportJob& job) const
{
    return codeWrites ? codeWrites(job) : filesOfText(*this, job);
}

Parameters parametersOf(const ExportJob& job)
{
    return effectiveParameters(job.state, 0);
}

std::string techniqueOf(const ExportJob& job)
{
    return job.state.panes.empty() ? Pane().technique : job.state.panes.front().technique;
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
