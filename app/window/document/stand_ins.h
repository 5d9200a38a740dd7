// Loading what a document names when files of it have moved or cannot be read: it is shown all the same, as they were read last, or with
// defaults in place of what never was.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/file_stamps.h"
#include "core/scene/resources.h"
#include <optional>

namespace relievo {

// In place of a file that could not be read.
struct StandIn {
    Error why;
    bool isThere = false; // the file was, then
    bool asBefore = false; // what was read of it before; else a default
};

// The data of a State, as Resources tell it; the names in there are those of the State, also where a default stands in.
struct Shown {
    Resources resources;
    std::optional<StandIn> mesh; // the plane
    std::optional<StandIn> environment; // the studio
    FileStamps files; // before they were read
    FileNames stale; // those of them to be read again with whatever is loaded next
    FileNames readAgain; // those that had been stale and were read
};

// As loadResources, but maps may all be missing, and what is missing of mesh and environment is stood in for. A stale file that cannot be
// read stays as it was read before, with a warning. Maps of which some are there and none can be read, nor was before, remain an error.
Expected<Shown> loadWhatIsThere(const State& state, const DecodedImages& images, Shown previous, const Progress& progress);

// One sentence for each stand-in: which file, what is shown instead, and the cure.
Warnings warningsOf(const Shown& shown);

// Whether the warning of a material is about this very file of it.
bool isAbout(const Warning& warning, const std::string& file);

// Whether the material told that the file of this slot could not be read.
bool isTroubled(const Material& material, const MapSlot& slot);

} // namespace relievo
