// Choosing which file gives which map of a set.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/sets/set_groups.h"
#include "core/image/sets/texture_set.h"
#include <optional>
#include <vector>

namespace relievo {

struct Candidate {
    std::filesystem::path file;
    NameGuess guess;
    std::vector<MapRole> roles; // what it may give; shrinks as its pixels are seen
    ImageInfo info;
    bool chosenByUser = false; // SOURCE itself: wins over better siblings
    bool likeChosen = false; // has SOURCE's resolution tag
};

// The roles that the channels of the file allow. A pair without alpha gives both: its pixels decide which one it is.
std::vector<MapRole> rolesByChannels(const NameGuess& guess, int channels);

struct Choice {
    MapRole role;
    const Candidate* candidate;
};
// The best candidate for each kind: SOURCE, then one that names a kind, SOURCE's resolution, for heights deeper than 8 bits, OpenGL
// before DirectX, larger, deeper, one map to itself, better word.
std::vector<Choice> chooseMaps(const std::vector<Candidate>& candidates);

} // namespace relievo
