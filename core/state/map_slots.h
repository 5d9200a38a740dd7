// The kinds of texture map that a material holds, and what the user decides about each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

enum class MapKind { Height, Color, Normal, Roughness, Gloss, Metallic, AmbientOcclusion, Specular, Emission, Opacity };

struct MapKindRow {
    MapKind kind;
    std::string_view key; // JSON key, `info` kind, command line option --KEY
    std::string_view label;
    bool isColor; // sRGB, decoded to linear on load
    int channels; // channels used: 1, or 3
    std::string_view suffixes; // file-name suffixes seen in the wild, best first, lower case
    std::string_view help;
};

inline constexpr auto kMapKinds = std::to_array<MapKindRow>({
    {MapKind::Height, "height", "Height", false, 1, "height heightmap heightfield dem displacement displace disp depth bump hgt h ht",
        "Relief, white is high (a depth map, white is deep, is flipped by its invert switch)."},
    {MapKind::Color, "color", "Color", true, 3, "basecolor base_color albedo color colour diffuse diff col alb d", "Base color, sRGB."},
    {MapKind::Normal, "normal", "Normal", false, 3, "normalgl normaldx nor_gl nor_dx normal normals nrm nor norm ogl n dx",
        "Tangent-space normals; OpenGL style (green up), DirectX style is converted by its green flip."},
    {MapKind::Roughness, "roughness", "Roughness", false, 1, "roughness rough rgh r", "Perceptual roughness, 0 smooth to 1 rough."},
    {MapKind::Gloss, "gloss", "Gloss", false, 1, "glossiness gloss smoothness", "1 - roughness; used when there is no roughness map."},
    {MapKind::Metallic, "metallic", "Metallic", false, 1, "metallic metalness metal met m", "0 dielectric, 1 metal."},
    {MapKind::AmbientOcclusion, "ao", "Ambient occlusion", false, 1, "ambientocclusion ambient_occlusion occlusion occ ao",
        "Share of the sky that a point sees; darkens ambient light only."},
    {MapKind::Specular, "specular", "Specular", false, 3, "specular spec s", "Specular color of the Blinn-Phong model."},
    {MapKind::Emission, "emission", "Emission", true, 3, "emission emissive emit glow e", "Light that the surface sends out, sRGB."},
    {MapKind::Opacity, "opacity", "Opacity", false, 1, "opacity alpha mask", "0 transparent (cut away), 1 opaque."},
});
inline constexpr std::size_t kMapKindCount = kMapKinds.size();

constexpr const MapKindRow& row(MapKind kind)
{
    return kMapKinds[std::size_t(kind)];
}
std::optional<MapKind> findMapKind(std::string_view key);

// Which channel of the file a map is read from. Rgb is the colour, or the mean for a single-channel map (red when the three are equal).
enum class Channel { R, G, B, A, Rgb };
inline constexpr std::array<std::string_view, 5> kChannelKeys = {"r", "g", "b", "a", "rgb"};

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
