// Comparing outputs with inputs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/inputs.h"
#include "core/gltf/pictures.h"
#include "core/state/shapes.h"
#include <algorithm>

namespace relievo {
namespace fs = std::filesystem;

std::vector<fs::path> filesOf(const MapSlots& slots)
{
    std::vector<fs::path> files;
    for (const MapSlot& slot : slots)
        if (!slot.empty())
            files.push_back(fileOfPicture(slot.file));
    return files;
}

std::vector<fs::path> filesOf(const State& state)
{
    std::vector<fs::path> files = filesOf(state.slots);
    if (!std::ranges::count(kShapes, state.mesh))
        files.emplace_back(state.mesh);
    files.emplace_back(state.environment);
    return files;
}

Expected<void> refuseToReplace(const std::vector<fs::path>& read, const fs::path& out)
{
    const auto isOut = [&out](const fs::path& file) {
        std::error_code code;
        return !file.empty() && fs::is_regular_file(file, code) && fs::equivalent(file, out, code);
    };
    if (std::ranges::any_of(read, isOut))
        return failure(
            out.string(), "this file is one of those that are read here, and would be replaced", "Write to another folder or name");
    return {};
}

} // namespace relievo
