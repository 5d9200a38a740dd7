// Reading presets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/presets.h"
#include <algorithm>

namespace relievo {

Expected<StateRead> readPreset(const State& base, const std::string& nameOrFile)
{
    const auto row = std::ranges::find(kPresets, nameOrFile, &PresetRow::key);
    if (row != kPresets.end())
        return fromJson(base, std::string(row->json), {}, nameOrFile);
    std::error_code code;
    if (std::filesystem::exists(nameOrFile, code))
        return readState(base, nameOrFile);
    std::string known;
    for (const PresetRow& preset : kPresets)
        known += (known.empty() ? "" : ", ") + std::string(preset.key);
    return failure(ErrorCode::NotFound, nameOrFile, "there is no such preset and no such file", "Presets are " + known);
}

} // namespace relievo
