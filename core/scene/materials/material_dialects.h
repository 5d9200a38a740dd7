// The table of engines' materials: which property is what here.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "core/state/map_slots.h"
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace relievo {

// A property that is a picture of this kind.
struct PictureProperty {
    std::string_view property;
    MapKind kind;
    Channel channel = Channel::Rgb; // where no property tells it
    std::string_view when = {}; // a property that must be as told, else the picture is not this ("KEY" for true, or "KEY=VALUE")
    std::string_view channelFrom = {}; // a property that says which channel
    std::string_view invertFrom = {}; // one that is true where the picture is the other way
    bool invert = false; // it always is
};

// A number: times x value + plus goes into a factor, or into the parameter of this key. Not where the material has a map of kind `unless`.
struct NumberProperty {
    std::string_view property;
    std::variant<float MeshFactors::*, std::string_view> target;
    double times = 1, plus = 0;
    std::optional<MapKind> unless = {};
};

struct MaterialDialect {
    std::string_view label;
    std::string_view types; // of MaterialFields "$type", separated by spaces; "" for all that no other row has
    std::span<const PictureProperty> pictures;
    std::span<const NumberProperty> numbers;
    std::string_view depth; // the property; depth in tiles, or in metres, is its value / depthFactor
    double depthFactor = 1, depthUntold = 0; // of materials that do not name it, as engines do with their default; 0: the depth stays
    bool inMetres = false;
    std::string_view metresPerUV = {}; // a property that tells it
    double midlevel = 1;
    std::string_view midlevelFrom = {};
    std::string_view color = {}; // property of the colour that multiplies the map
    bool colorIsSrgb = false;
    std::string_view clamped = {}; // "KEY=VALUE" of pictures that do not repeat
    double metallicUntold = 1; // that multiplies the map
    std::string_view offsetU = {}, offsetV = {}; // where v points up: of a tile's lower left corner
    bool offsetIsTurned = false; // the offset comes after the turn
};

using enum MapKind;
using F = MeshFactors;

// Godot 3's properties beside those of Godot 4: no material has both.
inline constexpr auto kGodotPictures = std::to_array<PictureProperty>({
    {"albedo_texture", Color},
    {"albedo_texture", Opacity, Channel::A, "transparency"},
    {"normal_texture", Normal},
    {"roughness_texture", Roughness, Channel::R, "", "roughness_texture_channel"},
    {"metallic_texture", Metallic, Channel::R, "", "metallic_texture_channel"},
    {"ao_texture", AmbientOcclusion, Channel::R, "", "ao_texture_channel"},
    {"orm_texture", AmbientOcclusion, Channel::R},
    {"orm_texture", Roughness, Channel::G},
    {"orm_texture", Metallic, Channel::B},
    {"emission_texture", Emission, Channel::Rgb, "emission_enabled"},
    {"heightmap_texture", Height, Channel::R, "", "", "heightmap_flip_texture"},
    {"albedo_texture", Opacity, Channel::A, "params_use_alpha_scissor"},
    {"depth_texture", Height, Channel::R, "", "", "", true},
});
inline constexpr auto kGodotNumbers = std::to_array<NumberProperty>({
    {"roughness", &F::roughness},
    {"metallic", &F::metallic},
    {"normal_scale", &F::normal},
    {"emission_energy_multiplier", &F::emission},
    {"heightmap_min_layers", "minSteps"},
    {"heightmap_max_layers", "maxSteps"},
    {"emission_energy", &F::emission},
    {"depth_min_layers", "minSteps"},
    {"depth_max_layers", "maxSteps"},
    {"uv1_scale.0", "tiling"},
    {"uv1_offset.0", "offsetU"},
    {"uv1_offset.1", "offsetV"},
});

// The universal pipeline's properties beside those of the built-in one, which materials keep that were brought over: of pictures the first
// that is there counts, of numbers the last.
inline constexpr auto kUnityPictures = std::to_array<PictureProperty>({
    {"_BaseMap", Color},
    {"_BaseMap", Opacity, Channel::A, "_AlphaClip"},
    {"_MainTex", Color},
    {"_MainTex", Opacity, Channel::A, "_Mode"},
    {"_BumpMap", Normal},
    {"_MetallicGlossMap", Metallic, Channel::R},
    {"_MetallicGlossMap", Gloss, Channel::A},
    {"_OcclusionMap", AmbientOcclusion, Channel::G},
    {"_EmissionMap", Emission},
    {"_ParallaxMap", Height, Channel::G},
});
inline constexpr auto kUnityNumbers = std::to_array<NumberProperty>({
    {"_Glossiness", &F::roughness, -1, 1, Gloss},
    {"_Smoothness", &F::roughness, -1, 1, Gloss},
    {"_Metallic", &F::metallic, 1, 0, Metallic},
    {"_BumpScale", &F::normal},
    {"_OcclusionStrength", &F::occlusion},
    {"_EmissionColor.r", &F::emission},
    {"_MainTex.m_Scale.x", "tiling"},
    {"_BaseMap.m_Scale.x", "tiling"},
});
inline constexpr auto kHdrpPictures = std::to_array<PictureProperty>({
    {"_BaseColorMap", Color},
    {"_BaseColorMap", Opacity, Channel::A, "_AlphaCutoffEnable"},
    {"_NormalMap", Normal},
    {"_MaskMap", Metallic, Channel::R},
    {"_MaskMap", AmbientOcclusion, Channel::G},
    {"_MaskMap", Gloss, Channel::A},
    {"_EmissiveColorMap", Emission},
    {"_HeightMap", Height, Channel::R},
});
inline constexpr auto kHdrpNumbers = std::to_array<NumberProperty>({
    {"_Smoothness", &F::roughness, -1, 1, Gloss},
    {"_Metallic", &F::metallic, 1, 0, Metallic},
    {"_NormalScale", &F::normal},
    {"_EmissiveColor.r", &F::emission},
    {"_PPDMinSamples", "minSteps"},
    {"_PPDMaxSamples", "maxSteps"},
    {"_BaseColorMap.m_Scale.x", "tiling"},
});

inline constexpr auto kBabylonPictures = std::to_array<PictureProperty>({
    {"albedoTexture", Color},
    {"diffuseTexture", Color},
    {"bumpTexture", Normal, Channel::Rgb, "", "", "invertNormalMapY"},
    {"bumpTexture", Height, Channel::A, "useParallax"},
    {"metallicTexture", AmbientOcclusion, Channel::R, "useAmbientOcclusionFromMetallicTextureRed"},
    {"metallicTexture", Roughness, Channel::G, "useRoughnessFromMetallicTextureGreen"},
    {"metallicTexture", Metallic, Channel::B, "useMetallnessFromMetallicTextureBlue"},
    {"ambientTexture", AmbientOcclusion, Channel::R},
    {"emissiveTexture", Emission},
});
inline constexpr auto kBabylonNumbers = std::to_array<NumberProperty>({
    {"roughness", &F::roughness},
    {"metallic", &F::metallic},
    {"emissiveIntensity", &F::emission},
    {"bumpTexture.uScale", "tiling"},
});

inline constexpr auto kPlayCanvasPictures = std::to_array<PictureProperty>({
    {"diffuseMap", Color},
    {"opacityMap", Opacity, Channel::A, "", "opacityMapChannel"},
    {"normalMap", Normal},
    {"metalnessMap", Metallic, Channel::G, "", "metalnessMapChannel"},
    {"glossMap", Roughness, Channel::G, "glossInvert", "glossMapChannel"},
    {"glossMap", Gloss, Channel::G, "glossInvert=false", "glossMapChannel"},
    {"glossMap", Gloss, Channel::G, "glossInvert=", "glossMapChannel"},
    {"aoMap", AmbientOcclusion, Channel::G, "", "aoMapChannel"},
    {"emissiveMap", Emission},
    {"heightMap", Height, Channel::G, "", "heightMapChannel"},
});
inline constexpr auto kPlayCanvasNumbers = std::to_array<NumberProperty>({
    {"metalness", &F::metallic},
    {"bumpMapFactor", &F::normal},
    {"bumpiness", &F::normal},
    {"emissiveIntensity", &F::emission},
    {"heightMapTiling.0", "tiling"},
    {"heightMapRotation", "rotation"},
});

inline constexpr auto kO3dePictures = std::to_array<PictureProperty>({
    {"baseColor.textureMap", Color},
    {"baseColor.textureMap", Opacity, Channel::A, "opacity.mode=Cutout"},
    {"opacity.textureMap", Opacity, Channel::R},
    {"normal.textureMap", Normal, Channel::Rgb, "", "", "normal.flipY"},
    {"roughness.textureMap", Roughness, Channel::R},
    {"metallic.textureMap", Metallic, Channel::R},
    {"occlusion.diffuseTextureMap", AmbientOcclusion, Channel::R},
    {"emissive.textureMap", Emission, Channel::Rgb, "emissive.enable"},
    {"parallax.textureMap", Height, Channel::R},
});
inline constexpr auto kO3deNumbers = std::to_array<NumberProperty>({
    {"roughness.factor", &F::roughness},
    {"metallic.factor", &F::metallic},
    {"normal.factor", &F::normal},
    {"occlusion.diffuseFactor", &F::occlusion},
    {"uv.tileU", "tiling"},
    {"uv.offsetU", "offsetU"},
    {"uv.offsetV", "offsetV"},
    {"uv.rotateDegrees", "rotation"},
});

// Standard surface, glTF PBR, OpenPBR and UsdPreviewSurface by the names of their inputs.
inline constexpr auto kMaterialXPictures = std::to_array<PictureProperty>({
    {"base_color", Color},
    {"diffuseColor", Color},
    {"normal", Normal},
    {"geometry_normal", Normal},
    {"specular_roughness", Roughness, Channel::R},
    {"roughness", Roughness, Channel::R},
    {"metalness", Metallic, Channel::R},
    {"base_metalness", Metallic, Channel::R},
    {"metallic", Metallic, Channel::R},
    {"occlusion", AmbientOcclusion, Channel::R},
    {"emission_color", Emission},
    {"emissive", Emission},
    {"displacement", Height, Channel::R},
});
inline constexpr auto kMaterialXNumbers = std::to_array<NumberProperty>({
    {"specular_roughness.times.0", &F::roughness},
    {"roughness.times.0", &F::roughness},
    {"metalness.times.0", &F::metallic},
    {"metallic.times.0", &F::metallic},
    {"normal.scale", &F::normal},
    {"emission.times.0", &F::emission},
    {"place.tiling.0", "tiling"},
    {"place.turn", "rotation"},
});

inline constexpr auto kMaterialDialects = std::to_array<MaterialDialect>({
    {.label = "Godot 4",
        .types = "StandardMaterial3D ORMMaterial3D",
        .pictures = kGodotPictures,
        .numbers = kGodotNumbers,
        .depth = "heightmap_scale",
        .depthFactor = 100,
        .depthUntold = 5,
        .color = "albedo_color",
        .colorIsSrgb = true,
        .clamped = "texture_repeat=false",
        .metallicUntold = 0},
    {.label = "Godot 3",
        .types = "SpatialMaterial",
        .pictures = kGodotPictures,
        .numbers = kGodotNumbers,
        .depth = "depth_scale",
        .depthUntold = 0.05,
        .color = "albedo_color",
        .colorIsSrgb = true,
        .metallicUntold = 0},
    {.label = "Unity (HDRP)",
        .types = "6e4ae4064600d784cac1e41a9e6f2e59",
        .pictures = kHdrpPictures,
        .numbers = kHdrpNumbers,
        .depth = "_HeightPoMAmplitude",
        .depthFactor = 100,
        .inMetres = true,
        .metresPerUV = "_PPDPrimitiveLength",
        .color = "_BaseColor",
        .colorIsSrgb = true,
        .offsetU = "_BaseColorMap.m_Offset.x",
        .offsetV = "_BaseColorMap.m_Offset.y"},
    {.label = "Unity (URP)",
        .types = "933532a4fcc9baf4fa0491de14d08ed7",
        .pictures = kUnityPictures,
        .numbers = kUnityNumbers,
        .depth = "_Parallax",
        .midlevel = 0.5,
        .color = "_BaseColor",
        .colorIsSrgb = true,
        .offsetU = "_BaseMap.m_Offset.x",
        .offsetV = "_BaseMap.m_Offset.y"},
    {.label = "Unity",
        .types = "46 45",
        .pictures = kUnityPictures,
        .numbers = kUnityNumbers,
        .depth = "_Parallax",
        .midlevel = 0.5,
        .color = "_Color",
        .colorIsSrgb = true,
        .offsetU = "_MainTex.m_Offset.x",
        .offsetV = "_MainTex.m_Offset.y"},
    {.label = "Babylon.js",
        .types = "babylon",
        .pictures = kBabylonPictures,
        .numbers = kBabylonNumbers,
        .depth = "parallaxScaleBias",
        .depthUntold = 0.05,
        .color = "albedo",
        .offsetU = "bumpTexture.uOffset",
        .offsetV = "bumpTexture.vOffset"},
    {.label = "PlayCanvas",
        .types = "playcanvas",
        .pictures = kPlayCanvasPictures,
        .numbers = kPlayCanvasNumbers,
        .depth = "heightMapFactor",
        .depthFactor = 10,
        .depthUntold = 1,
        .midlevel = 0.5,
        .midlevelFrom = "heightMapBase",
        .color = "diffuse",
        .colorIsSrgb = true,
        .offsetU = "heightMapOffset.0",
        .offsetV = "heightMapOffset.1"},
    {.label = "O3DE",
        .types = "o3de",
        .pictures = kO3dePictures,
        .numbers = kO3deNumbers,
        .depth = "parallax.factor",
        .depthUntold = 0.05,
        .inMetres = true,
        .color = "baseColor.color"},
    {.label = "MaterialX",
        .types = "materialx",
        .pictures = kMaterialXPictures,
        .numbers = kMaterialXNumbers,
        .depth = "displacement.scale.times.0",
        .inMetres = true,
        .midlevel = 0,
        .midlevelFrom = "displacement.minus",
        .color = "base_color.times",
        .clamped = "place.wrap=clamp",
        .offsetU = "place.offset.0",
        .offsetV = "place.offset.1",
        .offsetIsTurned = true},
});

} // namespace relievo
