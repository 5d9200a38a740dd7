// Comparing outputs with inputs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/inputs.h"
#include "core/gltf/pictures.h"
#include "core/state/environments.h"
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
    if (!isBuiltInMesh(state.mesh))
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

Warnings doubtsOf(const State& state)
{
    Warnings doubts;
    const auto isMissing = [](const std::string& file) {
        std::error_code code;
        return !file.empty() && !fs::exists(file, code);
    };
    if (!isBuiltInMesh(state.mesh) && isMissing(state.mesh))
        doubts.push_back({"mesh-missing", "The mesh " + state.mesh + " is not there. Put it back, or choose another one."});
    if (!isBuiltInEnvironment(state.environment) && isMissing(state.environment))
        doubts.push_back(
            {"environment-missing", "The environment " + state.environment + " is not there. Put it back, or choose another one."});
    for (std::size_t i = 0; i < state.panes.size(); ++i) {
        const Parameters parameters = effectiveParameters(state, i);
        const Warning warning{"steps-reversed",
            "Fewest steps (minSteps " + std::to_string(parameters.minSteps) + ") are above most steps (maxSteps "
                + std::to_string(parameters.maxSteps) + "): frontal views take more steps than grazing ones. Swap them."};
        if (parameters.minSteps > parameters.maxSteps && !std::ranges::count(doubts, warning))
            doubts.push_back(warning);
    }
    return doubts;
}

} // namespace relievo
