// Light from all around, prefiltered for rough reflections: built-in environments and panoramas.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/environment/cube.h"
#include <string>
#include <string_view>

namespace relievo {

struct Environment {
    std::string name;
    std::vector<Cube> levels; // see core/image/environment/prefilter.h
    Warnings warnings = {}; // what is doubtful about the panorama: "panorama-shape", "panorama-numbers", "panorama-dim", "panorama-tiny"
};

// Radiance from a direction (unit), linear RGB, of a built-in environment (a key of kEnvironments); scaled by nothing yet.
glm::vec3 builtInRadiance(std::string_view key, glm::vec3 direction);
// Average radiance 1. Made at once (under 100 ms). Black for a key that is none.
Environment builtInEnvironment(std::string_view key);

// nameOrFile: a key of kEnvironments, or an equirectangular .hdr / .exr (or any image): row 0 straight up (+y), the middle column towards
// -z, columns growing towards +x.
Expected<Environment> openEnvironment(const std::string& nameOrFile, const Progress& progress = {});

} // namespace relievo
