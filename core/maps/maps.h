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

struct BakedMapRow {
    std::string_view key;
    std::string_view label;
    std::string_view unit;
    int channels;
    std::array<ChannelRule, 4> rules = {}; // of each channel, when stored
    int bits = 16; // a channel has when stored, unless asked otherwise: 8, 16 or 32 (float)
    int slices = 1; // images one below the other
    int version; // of the algorithm: maps of another version in the cache are not used
    MapForm form = MapForm::Filtered; // how a search reads it
    ParameterSet parameters = {}; // that the result depends on
    BakedMap (*bake)(const HeightField& field, const Parameters& parameters, const Progress& progress) = nullptr; // F32, scale 1
    // Of a map that is made from a normal map instead (then `bake` is null); also tells the depth that the heights stand for, in tiles.
    BakedMap (*bakeFromNormals)(const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress) = nullptr;
    std::string_view help;
};

BakedMap bakeNormal(const HeightField& field, const Parameters& parameters, const Progress& progress);

inline constexpr ChannelRule kRatio{Rounding::Down, Encoding::SquareRoot};
// A cone that starts too low may hold its own texel; heights that have a code stay what they are.
inline constexpr std::array<ChannelRule, 4> kApexAndRatio = {ChannelRule{Rounding::Up}, kRatio};
inline constexpr std::array<ChannelRule, 4> kFourRatios = {kRatio, kRatio, kRatio, kRatio};

inline constexpr auto kBakedMaps = std::to_array<BakedMapRow>({
    {.key = "normal",
        .label = "Normal",
        .unit = "unit vector / 2 + 1/2",
        .channels = 3,
        .version = 1,
        .parameters = {&Parameters::depth, &Parameters::normalStrength},
        .bake = bakeNormal,
        .help = "Tangent-space normals of the height map at the State's depth, OpenGL style."},
    {.key = "height-from-normal",
        .label = "Height from normals",
        .unit = "height",
        .channels = 1,
        .version = 2,
        .bakeFromNormals = bakeHeightFromNormals,
        .help = "The height map whose slopes are nearest to the normal map's, for sets without one; also tells the depth that it needs."},
    {.key = "ao",
        .label = "Ambient occlusion",
        .unit = "share of the sky",
        .channels = 1,
        .version = 2,
        .parameters = {&Parameters::depth},
        .bake = bakeAo,
        .help = "Cosine-weighted share of the sky that the relief leaves open at the State's depth; 1 is open."},
    {.key = "horizon",
        .label = "Horizons, 8 azimuths",
        .unit = "sine of the elevation",
        .channels = 4,
        .bits = 8,
        .slices = 2,
        .version = 2,
        .parameters = {&Parameters::depth},
        .bake = bakeHorizon8,
        .help
        = "How high the relief stands around each texel at the State's depth, in 8 directions from +u towards +v: four in the channels of "
          "the "
          "upper image, four in the one below it."},
    {.key = "horizon-16",
        .label = "Horizons, 16 azimuths",
        .unit = "sine of the elevation",
        .channels = 4,
        .bits = 8,
        .slices = 4,
        .version = 2,
        .parameters = {&Parameters::depth},
        .bake = bakeHorizon16,
        .help = "As horizon, in 16 directions: four images one below the other."},
    {.key = "horizon-slopes",
        .label = "Horizons for any depth, 8 azimuths",
        .unit = "s / (s + 8), s in heights per tile",
        .channels = 4,
        .slices = 2,
        .version = 1,
        .form = MapForm::Layers,
        .bake = bakeHorizonSlopes8,
        .help = "As horizon, as slopes that no depth is in: the tangent of the elevation is s times the depth. Shadows by horizons and "
                "occlusion of the surroundings read it."},
    {.key = "horizon-slopes-16",
        .label = "Horizons for any depth, 16 azimuths",
        .unit = "s / (s + 8), s in heights per tile",
        .channels = 4,
        .slices = 4,
        .version = 1,
        .form = MapForm::Layers,
        .bake = bakeHorizonSlopes16,
        .help = "As horizon-slopes, in 16 directions: four images one below the other."},
    {.key = "curvature",
        .label = "Curvature",
        .unit = "1/2 + H / (2 |H| + 32), H in 1/tile",
        .channels = 1,
        .version = 1,
        .parameters = {&Parameters::depth},
        .bake = bakeCurvature,
        .help = "Mean curvature H of the relief at the State's depth: 0.5 is flat, brighter bulges out."},
    {.key = "pyramid",
        .label = "Maximum pyramid",
        .unit = "height",
        .channels = 1,
        .rules = {ChannelRule{Rounding::Up}},
        .version = 1,
        .form = MapForm::Pyramid,
        .bake = bakePyramid,
        .help = "Highest point of the surface above each cell between texel centres, then of 2 x 2, up to one texel (Tevs 2008)."},
    {.key = "cone",
        .label = "Cone map",
        .unit = "height, tiles per height",
        .channels = 2,
        .rules = kApexAndRatio,
        .version = 2,
        .bake = bakeCone,
        .help = "Height, and the ratio of the widest upward cone with no texel centre above it (Dummer 2006)."},
    {.key = "cone-quad",
        .label = "Quad cone map",
        .unit = "tiles per height",
        .channels = 4,
        .rules = kFourRatios,
        .version = 1,
        .bake = bakeConeQuad,
        .help = "Cone ratios of the four sectors of 90 degrees centred on +u, -u, +v, -v (GPU Gems 3, chapter 18)."},
    {.key = "cone-relaxed",
        .label = "Relaxed cone map",
        .unit = "height, tiles per height",
        .channels = 2,
        .rules = kApexAndRatio,
        .version = 2,
        .bake = bakeConeRelaxed,
        .help = "Height, and the ratio of the widest cone in which a ray from above enters the surface but never leaves it (Policarpo and "
                "Oliveira "
                "2007)."},
    {.key = "cone-robust",
        .label = "Robust cone map",
        .unit = "height, tiles per height",
        .channels = 2,
        .rules = kApexAndRatio,
        .version = 2,
        .bake = bakeConeRobust,
        .help = "Height, and the smallest of 3 x 3 cone ratios that only texels before a falling edge limit (Ban et al. 2024)."},
    {.key = "cell-cone",
        .label = "Cell cones",
        .unit = "codes",
        .channels = 4,
        .version = 2,
        .form = MapForm::Codes,
        .bake = bakeCellCones,
        .help
        = "For each 2 x 2 cells between texel centres, and the nodes of 8, 32 and 128 cells a side that hold them: highest point (upper "
          "byte) and "
          "steepest rise from it (lower byte). See the page on cell cones."},
    {.key = "distance",
        .label = "Distance volume",
        .unit = "tiles",
        .channels = 1,
        .rules = {kRatio},
        .slices = kDistanceSlices,
        .version = 2,
        .form = MapForm::Volume,
        .bake = bakeDistance,
        .help
        = "Distance to the relief at up to 128 x 128 x 32 points of the slab, for sphere tracing (Donnelly 2005); the slices one below the "
          "other, from the top down."},
});

const BakedMapRow* findBakedMap(std::string_view key); // nullptr when unknown

// The row's map of a field, as floats. Cancelled: an error of that code. Out of memory: an error that says so; a row that is
// made from normals: an error.
Expected<BakedMap> bakeMap(const BakedMapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress = {});

// The same for a row that is made from a normal map (3 channels, OpenGL style); others are an error.
Expected<BakedMap> bakeMapFromNormals(
    const BakedMapRow& row, const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress = {});

// The map in `bits` a channel (8, 16 or 32 for float), each channel rounded and encoded by the row's rule; `map` holds floats >= 0.
// Integers: a channel of roots, or one that exceeds 1, is scaled so that its largest value is the highest code. With Rounding::Down
// the value that a shader decodes in float, (stored / max) [squared] x scale, is the largest that does not exceed the map's, with
// Rounding::Up the smallest that is not below. 32 bits: the floats themselves, or their roots rounded the same way; scale 1.
// Cancelled (`progress` is only asked): the rest is left unwritten.
BakedMap storedMap(const BakedMapRow& row, const BakedMap& map, int bits, const Progress& progress = {});

// What a technique or a bake command uses: the row's map stored in row.bits, from the cache or baked now. Errors: those of the bake; what
// cannot be kept is returned all the same.
Expected<std::shared_ptr<const BakedMap>> cachedMap(
    const BakedMapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress = {});

// The image in another precision: bits 8, 16 or 32 (float). Values keep their meaning; rounding is to nearest.
Image withBits(const Image& image, int bits);

} // namespace relievo
