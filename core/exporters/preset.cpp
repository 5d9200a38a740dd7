// Export target "preset": the parameters without the files they were tuned on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "core/state/state_json.h"

namespace relievo {

Expected<Exported> exportPreset(const ExportJob& job)
{
    if (Expected<void> free = refuseToOverwriteSources(job, job.out); !free)
        return tl::unexpected(free.error());
    if (Expected<void> written = writeAtomically(job.out, toPresetJson(job.state)); !written)
        return tl::unexpected(written.error());
    return Exported{{job.out}, {}};
}

} // namespace relievo
