// The table of baked maps: everything that is computed from a height field and stored.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/image/image.h"
#include "core/maps/acceleration/cell_cones.h"
#include "core/maps/acceleration/cone.h"
#include "core/maps/acceleration/distance.h"
#include "core/maps/acceleration/pyramid.h"
#include "core/maps/baked_map.h"
#include "core/maps/surface/curvature.h"
#include "core/maps/surface/height_from_normal.h"
#include "core/maps/surface/horizon.h"
#include "core/state/parameters.h"
#include <array>
#include <string_view>

namespace relievo {

struct MapRow {
    std::string_view key;
    std::string_view label;
    std::string_view unit;
    int channels;
    std::array<ChannelRule, 4> rules; // of each channel, when stored
    int bits; // a channel has when stored, unless asked otherwise: 8, 16 or 32 (float)
    int version; // of the algorithm: maps of another version in the cache are not used
    MapForm form; // how a search reads it
    std::string_view parameters; // rows of kParameters that the result depends on, separated by spaces
    BakedMap (*bake)(const HeightField& field, const Parameters& parameters, const Progress& progress); // F32 values, scale 1
    std::string_view help;
    // Of a map that is made from a normal map instead (then `bake` is null); also tells the depth that the heights stand for, in tiles.
    BakedMap (*bakeFromNormals)(const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress) = nullptr;
};

BakedMap bakeNormal(const HeightField& field, const Parameters& parameters, const Progress& progress);

inline constexpr ChannelRule kRatio{Rounding::Down, Encoding::SquareRoot};
// A cone that starts too low may hold its own texel; heights that have a code stay what they are.
inline constexpr std::array<ChannelRule, 4> kApexAndRatio = {ChannelRule{Rounding::Up}, kRatio};
inline constexpr std::array<ChannelRule, 4> kFourRatios = {kRatio, kRatio, kRatio, kRatio};

inline constexpr auto kMaps = std::to_array<MapRow>({
    {"normal", "Normal", "unit vector / 2 + 1/2", 3, {}, 16, 1, MapForm::Filtered, "depth normalStrength", bakeNormal,
        "Tangent-space normals of the height map at the State's depth, OpenGL style."},
    {"height-from-normal", "Height from normals", "height", 1, {}, 16, 2, MapForm::Filtered, "", nullptr,
        "The height map whose slopes are nearest to the normal map's, for sets without one; also tells the depth that it needs.",
        bakeHeightFromNormals},
    {"ao", "Ambient occlusion", "share of the sky", 1, {}, 16, 2, MapForm::Filtered, "depth", bakeAo,
        "Cosine-weighted share of the sky that the relief leaves open at the State's depth; 1 is open."},
    {"horizon", "Horizons, 8 azimuths", "sine of the elevation", 4, {}, 8, 2, MapForm::Filtered, "depth", bakeHorizon8,
        "How high the relief stands around each texel at the State's depth, in 8 directions from +u towards +v: four in the channels of "
        "the "
        "upper image, four in the one below it."},
    {"horizon-16", "Horizons, 16 azimuths", "sine of the elevation", 4, {}, 8, 2, MapForm::Filtered, "depth", bakeHorizon16,
        "As horizon, in 16 directions: four images one below the other."},
    {"curvature", "Curvature", "1/2 + H / (2 |H| + 32), H in 1/tile", 1, {}, 16, 1, MapForm::Filtered, "depth", bakeCurvature,
        "Mean curvature H of the relief at the State's depth: 0.5 is flat, brighter bulges out."},
    {"pyramid", "Maximum pyramid", "height", 1, {ChannelRule{Rounding::Up}}, 16, 1, MapForm::Pyramid, "", bakePyramid,
        "Highest point of the surface above each cell between texel centres, then of 2 x 2, up to one texel (Tevs 2008)."},
    {"cone", "Cone map", "height, tiles per height", 2, kApexAndRatio, 16, 2, MapForm::Filtered, "", bakeCone,
        "Height, and the ratio of the widest upward cone with no texel centre above it (Dummer 2006)."},
    {"cone-quad", "Quad cone map", "tiles per height", 4, kFourRatios, 16, 1, MapForm::Filtered, "", bakeConeQuad,
        "Cone ratios of the four sectors of 90 degrees centred on +u, -u, +v, -v (GPU Gems 3, chapter 18)."},
    {"cone-relaxed", "Relaxed cone map", "height, tiles per height", 2, kApexAndRatio, 16, 2, MapForm::Filtered, "", bakeConeRelaxed,
        "Height, and the ratio of the widest cone in which a ray from above enters the surface but never leaves it (Policarpo and Oliveira "
        "2007)."},
    {"cone-robust", "Robust cone map", "height, tiles per height", 2, kApexAndRatio, 16, 2, MapForm::Filtered, "", bakeConeRobust,
        "Height, and the smallest of 3 x 3 cone ratios that only texels before a falling edge limit (Ban et al. 2024)."},
    {"cell-cone", "Cell cones", "codes", 4, {}, 16, 2, MapForm::Codes, "", bakeCellCones,
        "For each 2 x 2 cells between texel centres, and the nodes of 8, 32 and 128 cells a side that hold them: highest point (upper "
        "byte) and "
        "steepest rise from it (lower byte). See the page on cell cones."},
    {"distance", "Distance volume", "tiles", 1, {kRatio}, 16, 2, MapForm::Volume, "", bakeDistance,
        "Distance to the relief at up to 128 x 128 x 32 points of the slab, for sphere tracing (Donnelly 2005); the slices one below the "
        "other, from the top down."},
});

const MapRow* findMap(std::string_view key); // nullptr when unknown

// The row's map of a field, as floats. Cancelled: error with what == "cancelled". Out of memory: an error that says so; a row that is
// made from normals: an error.
Expected<BakedMap> bakeMap(const MapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress = {});

// The same for a row that is made from a normal map (3 channels, OpenGL style); others are an error.
Expected<BakedMap> bakeMapFromNormals(
    const MapRow& row, const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress = {});

// The map in `bits` a channel (8, 16 or 32 for float), each channel rounded and encoded by the row's rule; `map` holds floats >= 0.
// Integers: a channel of roots, or one that exceeds 1, is scaled so that its largest value is the highest code. With Rounding::Down
// the value that a shader decodes in float, (stored / max) [squared] x scale, is the largest that does not exceed the map's, with
// Rounding::Up the smallest that is not below. 32 bits: the floats themselves, or their roots rounded the same way; scale 1.
// Cancelled (`progress` is only asked): the rest is left unwritten.
BakedMap storedMap(const MapRow& row, const BakedMap& map, int bits, const Progress& progress = {});

// What a technique or a bake command uses: the row's map stored in row.bits, from the cache or baked now. Errors: those of the bake; what
// cannot be kept is returned all the same.
Expected<std::shared_ptr<const BakedMap>> cachedMap(
    const MapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress = {});

// The image in another precision: bits 8, 16 or 32 (float). Values keep their meaning; rounding is to nearest.
Image withBits(const Image& image, int bits);

} // namespace relievo
