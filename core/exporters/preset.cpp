// Export target "preset": the parameters without the files they were tuned on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/exporters/new_files.h"
#include "core/ground/file.h"
#include "core/state/state_json.h"

namespace relievo {

std::vector<std::filesystem::path> filesOfPreset(const ExportJob& job)
{
    return {job.out};
}

Expected<Exported> exportPreset(const ExportJob& job)
{
    if (Expected<void> free = refuseToOverwriteSources(job, job.out); !free)
        return tl::unexpected(free.error());
    NewFiles made;
    if (Expected<void> folder = made.makeFolder(job.out.parent_path()); !folder)
        return tl::unexpected(folder.error());
    if (Expected<void> written = writeAtomically(job.out, toPresetJson(job.state)); !written)
        return tl::unexpected(written.error());
    made.keep();
    return Exported{{job.out}, {}};
}

} // namespace relievo
