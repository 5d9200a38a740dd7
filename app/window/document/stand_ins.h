// Loading what a document names when files of it have moved: it is shown all the same, with defaults in place of what is not there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/resources.h"
#include <QDateTime>
#include <optional>

namespace relievo {

// In place of a file that could not be read.
struct StandIn {
    Error why;
    QDateTime changed; // when that file was, then; invalid: it was not there
};

// The data of a State, as Resources tell it; the names in there are those of the State, also where a default stands in.
struct Shown {
    Resources resources;
    std::optional<StandIn> mesh; // the plane
    std::optional<StandIn> environment; // the studio
};

// As loadResources, but maps may all be missing, and what is missing of mesh and environment is stood in for. Maps of which some
// are there and none can be read remain an error.
Expected<Shown> loadWhatIsThere(const State& state, const DecodedImages& images, Shown previous, const Progress& progress);

// One sentence for each stand-in: which file, what is shown instead, and the cure.
Warnings warningsOf(const Shown& shown);

// Whether the warning of a material is about this very file of it.
bool isAbout(const Warning& warning, const std::string& file);

// Whether a file that was missing is there again (or one that could not be read is another one now).
bool isBack(const Shown& shown);

} // namespace relievo
