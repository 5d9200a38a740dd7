// What a texture's file name says: which maps it holds, of which set, by which convention.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/sets/texture_set.h"
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

// One map that a file holds.
struct MapRole {
    MapKind kind;
    Channel channel = Channel::Rgb;
    bool operator==(const MapRole&) const = default;
};

enum class Packing {
    None, // one map
    Channels, // scalar maps in r, g, b and perhaps a: wants 3 channels or more
    ColorAndAlpha, // a colour, specular or normal with another map in alpha: wants an alpha that varies
    Relief, // normal and depth in one of the papers' two forms: the pixels decide which
};

struct NameGuess {
    std::string stem; // lower case: the name without kind words and resolution tags; files of one set share it
    std::string title; // the same as the user wrote it
    std::string whole; // the stem if the kind words belonged to the name after all
    std::vector<MapRole> roles; // empty: the name names no kind
    Packing packing = Packing::None;
    MapRole plain{MapKind::Height}; // what a packed file is when it has no alpha: the last word's kind
    bool weak = false; // one or two letters: counts only when siblings of the same stem agree
    // The letter a, b or c, which may as well number the takes of one map; else 0.
    // a: emission in a set with colours, if the pixels are mostly black; else no map.
    // b: base colour beside the packed maps of Megascans (ORDp, DpRA); else no map.
    // c: colour beside a normal or height map, where there is no b; else no map.
    char vague = '\0';
    int rank = 0; // 0 is the best word for its kind
    std::string resolution; // "1k", "2048" ...: the tag that says so, lower case; "" without any
    Convention convention = Convention::Unsure; // GL, DX, Height or Depth when the name says so
};

// name: a file name without folder and without suffix. Never fails; any bytes are allowed.
NameGuess guessFromName(std::string_view name);

// What the name may mean instead, likeliest first: its last kind words alone ("HammeredMetal_Roughness" need not be metal and
// roughness in one file), or no kind at all. Empty where guessFromName finds no kind.
std::vector<NameGuess> otherReadings(std::string_view name);

// Poliigon ends all names of a set in its workflow ("Tiles_COL_1K_METALNESS"): the reading without the last kind word, where it
// follows a tag or number and an earlier kind word is left. Whether it is right depends on the siblings.
std::optional<NameGuess> withoutWorkflow(std::string_view name);

// The layer of an EXR file that holds heights, by its name or the last part of it: height, displacement, disp, depth, z, the first of
// these that there is. The last two are distances: white is deep.
std::optional<std::string> heightLayer(const std::vector<std::string>& layers);
bool isDepthLayer(std::string_view layer);

// "wall_height.1001", "wall_1001_height": one of the tiles that a mesh's UVs are spread over, 1001 to 1999 as a word of its own.
struct UdimTile {
    std::string base; // the stem without the number
    int number;
};
std::optional<UdimTile> udimTile(std::string_view stem);

// Whether an image without siblings is a depth map.
bool endsInDepth(std::string_view name);

} // namespace relievo
