// Reading a relief object from the file that names its maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/relief_object.h"
#include <filesystem>

namespace relievo {

inline constexpr std::string_view kObjectSuffix = ".object.json"; // of NAME.object.json

struct ObjectRead {
    ReliefObject object;
    Warnings warnings; // those of checkObject; "side-missing": the object reaches to that side of its box
};

// resources/help/objects.md, "The file". Errors name the file or the map: no JSON of this kind, numbers that make no box, maps that cannot
// be read, sides of one axis or layers that differ in size, no side at all.
Expected<ObjectRead> readObject(const std::filesystem::path& file);

} // namespace relievo
