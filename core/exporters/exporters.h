// The table of export targets and the one function that runs a row.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/choice.h"
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/scene/resources.h"
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

// What is done to the maps on their way out because a reader needs it; each can be chosen.
enum class Cure { FullRange, Normals, Dither, Bump };
constexpr std::string_view wordOf(Cure cure)
{
    switch (cure) {
    case Cure::FullRange:
        return "full-range";
    case Cure::Normals:
        return "normals";
    case Cure::Dither:
        return "dither";
    case Cure::Bump:
        return "bump";
    }
    return {};
}
struct CureRow {
    std::string_view label, help;
    bool byDefault = true;
};
inline constexpr PerChoice<Cure, CureRow> kCures{{{
    {"Use the full range of heights",
        "Stretches the heights to 0..1 and makes the depth smaller by as much: engines that put white on the surface draw relief that "
        "never is white as if it were sunk, and 8 bits hold more of it."},
    {"Make missing normals",
        "Makes a normal map of the heights at the material's depth where there is none: parallax moves the picture, the light needs "
        "normals."},
    {"Dither to 8 bits", "Spreads what 8 bits cannot hold over neighbours, where a target keeps 8 bits only: no terraces."},
    {"Name heights as a bump map too",
        "glTF has no height map that other programs read. EXT_materials_bump is a draft that three.js reads; it takes no more space, and "
        "where there is a normal map three.js shows that.",
        false},
}}};
constexpr EnumSet<Cure> curesByDefault()
{
    EnumSet<Cure> cures;
    for (std::size_t i = 0; i < kChoices<Cure>; ++i)
        if (kCures[Cure(i)].byDefault)
            cures.insert(Cure(i));
    return cures;
}

// What a target is for, in the order of lists.
enum class ExportGroup { Engines, Formats, Shaders, Relievo, Own };
constexpr std::string_view wordOf(ExportGroup group)
{
    switch (group) {
    case ExportGroup::Engines:
        return "Engines and programs";
    case ExportGroup::Formats:
        return "Formats";
    case ExportGroup::Shaders:
        return "Shader text";
    case ExportGroup::Relievo:
        return "Relievo";
    case ExportGroup::Own:
        return "Your own";
    }
    return {};
}

struct TargetText;

// Pictures that were written, by what is in them: an equal one for another target is copied. In a file of their own, or within another,
// and kept.
struct WrittenPicture {
    std::filesystem::path file;
    std::shared_ptr<const std::vector<std::byte>> bytes = nullptr; // of a PNG
};
using WrittenPictures = std::map<std::string, WrittenPicture>;

struct ExportJob {
    const State& state;
    const Resources& resources;
    std::filesystem::path out; // a file, or a folder (made when missing) when the row says so
    int size = 0; // texels of the longest side of written textures; 0 keeps each map's own size
    Progress progress;
    std::vector<std::filesystem::path> alsoRead = {}; // beside what the State names: the project, a preset
    EnumSet<Cure> cures = curesByDefault();
    WrittenPictures* pictures = nullptr; // of this material's other targets; may be null
    const TargetText* packing = nullptr; // whose textures stand in for those of a target by text; may be null
};
struct Exported {
    std::vector<std::filesystem::path> files; // what was written
    Warnings warnings; // what the target will get wrong, or what was left out
};

// What an engine takes for height, and how it draws it.
enum class DepthOf { Tile, Metres }; // what its number is a multiple of: the depth in tiles (after tiling), or in metres
constexpr std::string_view wordOf(DepthOf of)
{
    switch (of) {
    case DepthOf::Tile:
        return "tile";
    case DepthOf::Metres:
        return "m";
    }
    return {};
}
struct EngineFacts {
    std::string_view version = {}; // that the row was read from or run with; "" for formats that no engine is behind
    std::string_view technique = {}; // row of kTechniques that draws as it does; "" where vertices are moved, or nothing is drawn
    Channel channel = Channel::R; // of the height texture that is read
    bool isDepth = false; // white is deep
    float zero = 1.f; // height (white is 1) that lies on the surface
    bool zeroIsFree = false; // a number of its own says it: the midlevel arrives
    std::string_view property = {}; // that holds the depth: factor x depth, within [min, max]
    DepthOf of = DepthOf::Tile;
    float factor = 1.f, min = 0.f, max = std::numeric_limits<float>::infinity();
    bool greenDown = false; // reads DirectX normals
    int bits = 16; // of a height that it keeps
    std::string_view limits = {}; // what it gets wrong, in sentences; "" for nothing
};

// Written by code of its own (`code`, `codeWrites`), or by a text: one of resources/exports, named by the key, or a user's file.
struct ExportRow {
    std::string_view key;
    std::string_view label;
    ExportGroup group = ExportGroup::Engines;
    std::string_view icon = "engine"; // file under resources/icons without suffix: one shape a family
    std::string_view suffix = {}; // ".glb"; "" when `out` is a folder
    std::string_view otherSuffix = {}; // of a second form of the same file, which `out` may have instead
    Expected<Exported> (*code)(const ExportJob& job) = nullptr;
    std::vector<std::filesystem::path> (*codeWrites)(const ExportJob& job) = nullptr; // the files that `code` makes or replaces
    EngineFacts engine = {};
    std::string_view help;
    const TargetText* text = nullptr; // a user's own

    bool takes(const std::filesystem::path& out) const; // a folder, or a file whose suffix fits
    Expected<Exported> run(const ExportJob& job) const;
    std::vector<std::filesystem::path> writes(const ExportJob& job) const; // the files that `run` makes or replaces
};

// Folders that are missing are made. What the material was opened from is never written over: an error when `file` is one of the State's
// own, of the mesh's pictures or of what else was read.
Expected<void> refuseToOverwriteSources(const ExportJob& job, const std::filesystem::path& file);

Expected<Exported> exportGltf(const ExportJob& job);
Expected<Exported> exportTextures(const ExportJob& job);
Expected<Exported> exportPreset(const ExportJob& job);
Expected<Exported> exportWeb(const ExportJob& job);
std::vector<std::filesystem::path> filesOfGltf(const ExportJob& job);
std::vector<std::filesystem::path> filesOfTextures(const ExportJob& job);
std::vector<std::filesystem::path> filesOfPreset(const ExportJob& job);
std::vector<std::filesystem::path> filesOfWeb(const ExportJob& job);

inline constexpr std::string_view kHorizonsLeftOut = "What is written reads no map of horizons: its self-shadows are searched, and the "
                                                     "relief takes nothing from the light of the surroundings.";
inline constexpr std::string_view kShaderLimits = "Rays are straight and no mip level of the heights is read: silhouettes stay the mesh's.";
inline constexpr auto kExports = std::to_array<ExportRow>({
    {.key = "gltf",
        .label = "glTF",
        .group = ExportGroup::Formats,
        .icon = "mesh",
        .suffix = ".glb",
        .otherSuffix = ".gltf",
        .code = exportGltf,
        .codeWrites = filesOfGltf,
        .help = "Mesh and material in one file (.glb) or two (.gltf and .bin): base color, normal, packed occlusion-roughness-metallic, "
                "height in RELIEVO_materials_relief."},
    {.key = "textures",
        .label = "Texture folder",
        .group = ExportGroup::Formats,
        .icon = "maps",
        .code = exportTextures,
        .codeWrites = filesOfTextures,
        .help = "Each map as its own file, height at 16 bits, and relief.json with the physical depth."},
    {.key = "preset",
        .label = "Relievo preset",
        .group = ExportGroup::Relievo,
        .icon = "sample",
        .suffix = ".json",
        .code = exportPreset,
        .codeWrites = filesOfPreset,
        .help = "The material's parameters without its files, to be laid on other materials."},
    {.key = "web",
        .label = "Web page",
        .group = ExportGroup::Relievo,
        .icon = "globe",
        .suffix = ".html",
        .code = exportWeb,
        .codeWrites = filesOfWeb,
        .help = "One file that a browser draws, also from disk and without a network: mesh, maps and the techniques of both panes to be "
                "turned, lit and wiped between. Take textures of 512 or 1024."},
    {.key = "godot4",
        .label = "Godot 4",
        .engine = {.version = "4.6, run",
            .technique = "as-godot4",
            .property = "heightmap_scale",
            .factor = 100.f,
            .bits = 32,
            .limits = "Deep parallax does not divide by the view's height: at grazing views it draws too little depth. Heights are not "
                      "drawn with triplanar "
                      "mapping."},
        .help = "StandardMaterial3D (.tres) with its textures and their .import files: the height lossless and without mipmaps, which "
                "spoil the march."},
    {.key = "godot4-shader",
        .label = "Godot 4, this technique",
        .group = ExportGroup::Shaders,
        .icon = "code",
        .engine = {.version = "4.6, run",
            .zeroIsFree = true,
            .property = "relief_depth",
            .of = DepthOf::Metres,
            .bits = 32,
            .limits = "Heights are read at the finest level, so that far away the relief may shimmer."},
        .help = "Spatial shader (.gdshader) with the search that is chosen here, self-shadows and depth, and the ShaderMaterial (.tres) "
                "that fills it."},
    {.key = "godot3",
        .label = "Godot 3",
        .engine = {.version = "3.2.3, run",
            .technique = "as-godot3",
            .isDepth = true,
            .property = "depth_scale",
            .bits = 8,
            .limits = "Deep parallax does not divide by the view's height: at grazing views it draws too little depth."},
        .help = "SpatialMaterial (.tres) with its textures; the height is written as a depth map, which Godot 3 reads."},
    {.key = "unity-builtin",
        .label = "Unity, built-in pipeline",
        .engine = {.version = "2022.3, by its published formula",
            .technique = "as-unity-builtin",
            .channel = Channel::G,
            .zero = 0.5f,
            .property = "_Parallax",
            .min = 0.005f,
            .max = 0.08f,
            .bits = 8,
            .limits = "One step along the view, with mid-grey on the surface: no occlusion, and wrong on steep relief."},
        .help = "Standard material (.mat) with .meta files that set up its textures; to be copied into Assets."},
    {.key = "unity-urp",
        .label = "Unity, universal pipeline",
        .engine = {.version = "URP 14, by its published formula",
            .technique = "as-unity-urp",
            .channel = Channel::G,
            .zero = 0.5f,
            .property = "_Parallax",
            .min = 0.005f,
            .max = 0.08f,
            .bits = 8,
            .limits = "One step along the view, with mid-grey on the surface: no occlusion, and wrong on steep relief. Its shadow and "
                      "depth passes know no "
                      "parallax."},
        .help = "Lit material (.mat) with .meta files that set up its textures; to be copied into Assets."},
    {.key = "unity-hdrp",
        .label = "Unity, high definition pipeline",
        .engine = {.version = "HDRP 14, by its published formula",
            .technique = "as-unity-hdrp",
            .property = "_HeightPoMAmplitude",
            .of = DepthOf::Metres,
            .factor = 100.f,
            .limits = "Few steps (5 to 15) unless they are raised: thin relief is missed."},
        .help = "Lit material (.mat) with pixel displacement in centimetres, a mask map, and .meta files; to be copied into Assets."},
    {.key = "unreal",
        .label = "Unreal Engine 5",
        .engine = {.version = "5.4, by its published formula",
            .technique = "as-unreal",
            .zeroIsFree = true,
            .property = "Height Ratio",
            .greenDown = true,
            .limits = "The depth of steep views ends in steps where Max Steps are few."},
        .help = "Python for the editor that imports the textures and makes the material: the parallax occlusion node is wired, a Custom "
                "node with "
                "this technique stands beside it. Not run in the engine."},
    {.key = "o3de",
        .label = "O3DE",
        .engine = {.version = "24.09, by its published formula",
            .technique = "as-o3de",
            .property = "parallax.factor",
            .of = DepthOf::Metres,
            .limits = "Shadows stay flat under parallax."},
        .help = "StandardPBR material (.material) with its textures."},
    {.key = "bevy",
        .label = "Bevy",
        .engine = {.version = "0.15, by its published formula",
            .technique = "as-bevy",
            .isDepth = true,
            .property = "parallax_depth_scale",
            .bits = 8,
            .limits = "The prepass (shadows, ambient occlusion) knows no parallax."},
        .help = "Rust that makes the StandardMaterial, with its textures; the height is written as a depth map, which Bevy reads."},
    {.key = "babylon",
        .label = "Babylon.js",
        .icon = "globe",
        .engine = {.version = "9.35, run",
            .technique = "as-babylon",
            .channel = Channel::A,
            .property = "parallaxScaleBias",
            .bits = 8,
            .limits
            = "15 steps whatever the view, and the ray ends before the full depth: at 0.58 of it straight down, 0.8 at 70 degrees."},
        .help = "ES module of two materials: a PBRMaterial with parallax occlusion, its height in the alpha of the normal map, and a "
                "ShaderMaterial with this technique."},
    {.key = "playcanvas",
        .label = "PlayCanvas",
        .icon = "globe",
        .engine = {.version = "2.23, run",
            .technique = "as-playcanvas",
            .zeroIsFree = true,
            .property = "heightMapFactor",
            .factor = 10.f,
            .bits = 8,
            .limits = "At most 16 samples, and never more than 5 depths sideways: grazing views are too shallow. Versions before 2.22 draw "
                      "an offset only."},
        .help = "ES module of two materials: a StandardMaterial with parallax occlusion, and a ShaderMaterial with this technique."},
    {.key = "three",
        .label = "three.js",
        .icon = "globe",
        .engine = {.version = "0.187, run",
            .zeroIsFree = true,
            .property = "displacementScale",
            .of = DepthOf::Metres,
            .bits = 8,
            .limits = "three.js has no parallax of its own: vertices are moved, so the mesh must be finely divided."},
        .help = "ES module of two materials: a MeshStandardMaterial with a displacement map, and a ShaderMaterial with this technique."},
    {.key = "blender",
        .label = "Blender",
        .icon = "spheres",
        .engine = {.version = "3.4, run",
            .zeroIsFree = true,
            .property = "Scale",
            .of = DepthOf::Metres,
            .limits = "Vertices are moved: the mesh must be finely divided (a Subdivision modifier, or adaptive subdivision)."},
        .help = "Python that makes the material's nodes, displacement with midlevel and scale, in Blender 3.4 and later."},
    {.key = "materialx",
        .label = "MaterialX",
        .group = ExportGroup::Formats,
        .icon = "nodes",
        .engine = {.version = "1.39, read by its own library",
            .zeroIsFree = true,
            .property = "scale of the displacement node",
            .of = DepthOf::Metres,
            .limits = "Displacement is drawn by renderers that divide meshes; MaterialX's own viewers leave it out, and three.js refuses "
                      "files with it: "
                      "take the one without."},
        .help = "Material (.mtlx) with standard_surface and displacement in metres; for 1.39, for 1.38, and without displacement."},
    {.key = "usd",
        .label = "USD",
        .group = ExportGroup::Formats,
        .icon = "nodes",
        .engine = {.zeroIsFree = true,
            .property = "inputs:scale of the displacement texture",
            .of = DepthOf::Metres,
            .limits = "Displacement is drawn by renderers that divide meshes; real-time viewers leave it out."},
        .help = "Material (.usda) with UsdPreviewSurface: textures, displacement with scale and bias in metres."},
    {.key = "glsl",
        .label = "GLSL",
        .group = ExportGroup::Shaders,
        .icon = "code",
        .engine = {.zeroIsFree = true, .property = "reliefDepth", .of = DepthOf::Metres, .limits = kShaderLimits},
        .help = "This technique as complete shaders of GLSL 4.10 and ES 3.00 (WebGL2), with its textures; each uniform tells its value."},
    {.key = "hlsl",
        .label = "HLSL",
        .group = ExportGroup::Shaders,
        .icon = "code",
        .engine = {.zeroIsFree = true, .property = "u_reliefDepth", .of = DepthOf::Metres, .limits = kShaderLimits},
        .help
        = "This technique as complete shaders of HLSL 5.0, translated from ours, with its textures; the head tells each uniform's value."},
    {.key = "msl",
        .label = "Metal",
        .group = ExportGroup::Shaders,
        .icon = "code",
        .engine = {.zeroIsFree = true, .property = "u.reliefDepth", .of = DepthOf::Metres, .limits = kShaderLimits},
        .help
        = "This technique as complete shaders of the Metal Shading Language, translated from ours, with its textures; the head tells each "
          "uniform's value."},
    {.key = "packed",
        .label = "Packed textures",
        .group = ExportGroup::Formats,
        .icon = "maps",
        .help = "Base color, normal and height, and occlusion, roughness and metallic in one texture: what most engines and painting "
                "programs take."},
});

const ExportRow* findExport(std::string_view key); // nullptr when unknown

// What the engine will draw of the material, measured: "Godot 4 will draw 66 % less depth at 70 degrees; mean error 0.11 of the depth". ""
// where no technique stands for it or there are no heights. About 0.05 s for 2048 x 2048 heights.
std::string drawingTold(const ExportRow& row, const ExportJob& job);

// The names of the files that a folder holds, with NAME for the material's; none of targets that write a file of any name.
std::vector<std::string> namesInFolder(const ExportRow& row);

// The cures that may change what the row writes; packing: as in ExportJob.
EnumSet<Cure> curesUsedBy(const ExportRow& row, const TargetText* packing = nullptr);

// What all targets are given where a State is exported: picture A, and what it shows.
Parameters parametersOf(const ExportJob& job);
std::string techniqueOf(const ExportJob& job); // key

} // namespace relievo
