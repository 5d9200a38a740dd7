// The kinds of texture map that a material holds, and what the user decides about each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/choice.h"
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

enum class MapKind { Height, Color, Normal, Roughness, Gloss, Metallic, AmbientOcclusion, Specular, Emission, Opacity, Optics };

struct MapKindRow {
    MapKind kind;
    std::string_view key; // JSON key, `info` kind, command line option --KEY
    std::string_view label;
    bool isColor = false; // sRGB, decoded to linear on load
    int channels; // channels used: 1, or 3
    std::string_view withoutMap
        = "1.0f"; // what shaders read where the material has none; "" for heights and normals, which are made up nowhere
    std::string_view fileName; // of exported textures: NAME_Height.png
    std::string_view convention = "linear"; // as relief.json tells it
    std::string_view suffixes; // file-name suffixes seen in the wild, best first, lower case
    std::string_view help;
};

inline constexpr float kColorWithoutMap = 0.4f; // linear, each channel: what is shown where a material has no colour map
inline constexpr std::string_view kColorWithoutMapText = "vec3(0.4f)"; // the same for shaders

inline constexpr auto kMapKinds = std::to_array<MapKindRow>({
    {.kind = MapKind::Height,
        .key = "height",
        .label = "Height",
        .channels = 1,
        .withoutMap = "",
        .fileName = "Height",
        .convention = "height",
        .suffixes = "height heightmap heightfield dem displacement displace disp depth bump hgt h ht",
        .help = "Relief, white is high (a depth map, white is deep, is flipped by its invert switch)."},
    {.kind = MapKind::Color,
        .key = "color",
        .label = "Color",
        .isColor = true,
        .channels = 3,
        .withoutMap = kColorWithoutMapText,
        .fileName = "Color",
        .convention = "srgb",
        .suffixes = "basecolor base_color albedo color colour diffuse diff col alb d",
        .help = "Base color, sRGB."},
    {.kind = MapKind::Normal,
        .key = "normal",
        .label = "Normal",
        .channels = 3,
        .withoutMap = "",
        .fileName = "NormalGL",
        .convention = "gl",
        .suffixes = "normalgl normaldx nor_gl nor_dx normal normals nrm nor norm ogl n dx",
        .help = "Tangent-space normals; OpenGL style (green up), DirectX style is converted by its green flip."},
    {.kind = MapKind::Roughness,
        .key = "roughness",
        .label = "Roughness",
        .channels = 1,
        .fileName = "Roughness",
        .suffixes = "roughness rough rgh r",
        .help = "Perceptual roughness, 0 smooth to 1 rough."},
    {.kind = MapKind::Gloss,
        .key = "gloss",
        .label = "Gloss",
        .channels = 1,
        .fileName = "Glossiness",
        .suffixes = "glossiness gloss smoothness",
        .help = "1 - roughness; used when there is no roughness map."},
    {.kind = MapKind::Metallic,
        .key = "metallic",
        .label = "Metallic",
        .channels = 1,
        .withoutMap = "0.0f",
        .fileName = "Metallic",
        .suffixes = "metallic metalness metal met m",
        .help = "0 dielectric, 1 metal."},
    {.kind = MapKind::AmbientOcclusion,
        .key = "ao",
        .label = "Ambient occlusion",
        .channels = 1,
        .fileName = "AmbientOcclusion",
        .suffixes = "ambientocclusion ambient_occlusion occlusion occ ao",
        .help = "Share of the sky that a point sees; darkens ambient light only."},
    {.kind = MapKind::Specular,
        .key = "specular",
        .label = "Specular",
        .channels = 3,
        .withoutMap = "vec3(1.0f)",
        .fileName = "Specular",
        .suffixes = "specular spec s",
        .help = "Specular color of the Blinn-Phong model."},
    {.kind = MapKind::Emission,
        .key = "emission",
        .label = "Emission",
        .isColor = true,
        .channels = 3,
        .withoutMap = "vec3(0.0f)",
        .fileName = "Emission",
        .convention = "srgb",
        .suffixes = "emission emissive emit glow e",
        .help = "Light that the surface sends out, sRGB."},
    {.kind = MapKind::Opacity,
        .key = "opacity",
        .label = "Opacity",
        .channels = 1,
        .fileName = "Opacity",
        .suffixes = "opacity alpha mask",
        .help = "0 transparent (cut away), 1 opaque."},
    {.kind = MapKind::Optics,
        .key = "optics",
        .label = "Optics",
        .channels = 3,
        .withoutMap = "vec3(shininess / 255.0f, 0.5f / ior, mirror)",
        .fileName = "Optics",
        .suffixes = "optics shininessetamirror",
        .help
        = "Of the thesis shading model: shininess over 255 in red, half of the ratio of refraction (1 / index) in green, mirror in blue."},
});
inline constexpr std::size_t kMapKindCount = kMapKinds.size();

constexpr const MapKindRow& row(MapKind kind)
{
    return kMapKinds[std::size_t(kind)];
}
std::optional<MapKind> findMapKind(std::string_view key);
std::string keysOf(EnumSet<MapKind> kinds); // in the order of the table, separated by spaces

// Which channel of the file a map is read from. Rgb is the colour, or the mean for a single-channel map (red when the three are equal).
enum class Channel { R, G, B, A, Rgb };
constexpr std::string_view wordOf(Channel channel)
{
    switch (channel) {
    case Channel::R:
        return "r";
    case Channel::G:
        return "g";
    case Channel::B:
        return "b";
    case Channel::A:
        return "a";
    case Channel::Rgb:
        return "rgb";
    }
    return {};
}

// One map as the user set it. A plain value.
struct MapSlot {
    std::string file; // absolute path, "sample:KEY" for a built-in sample, "" for none
    Channel channel = Channel::Rgb;
    bool invert = false; // scalar maps: 1 - value (a depth map becomes height). Normal map: green flip (DirectX style)
    bool operator==(const MapSlot&) const = default;
    bool empty() const { return file.empty(); }
};
using MapSlots = std::array<MapSlot, kMapKindCount>;

} // namespace relievo
