// What can be chosen among a few by name: the kinds of the State's choices, each with its words.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/choice.h"

namespace relievo {

// What lies outside the texture: the tile again, or its border.
enum class Wrap { Repeat, Clamp };
constexpr std::string_view wordOf(Wrap wrap)
{
    switch (wrap) {
    case Wrap::Repeat:
        return "repeat";
    case Wrap::Clamp:
        return "clamp";
    }
    return {};
}

// Where the frame of the texture on the mesh comes from.
enum class Frames { Vertex, Derivatives, Thesis };
constexpr std::string_view wordOf(Frames frames)
{
    switch (frames) {
    case Frames::Vertex:
        return "vertex";
    case Frames::Derivatives:
        return "derivatives";
    case Frames::Thesis:
        return "thesis";
    }
    return {};
}

// How a search ray follows the curved mesh to its outline.
enum class Silhouettes { Off, Axes, Quadric, Prisms };
constexpr std::string_view wordOf(Silhouettes silhouettes)
{
    switch (silhouettes) {
    case Silhouettes::Off:
        return "off";
    case Silhouettes::Axes:
        return "axes";
    case Silhouettes::Quadric:
        return "quadric";
    case Silhouettes::Prisms:
        return "prisms";
    }
    return {};
}

// The shading model.
enum class Shading { MetallicRoughness, BlinnPhong, Thesis };
constexpr std::string_view wordOf(Shading shading)
{
    switch (shading) {
    case Shading::MetallicRoughness:
        return "metallic-roughness";
    case Shading::BlinnPhong:
        return "blinn-phong";
    case Shading::Thesis:
        return "thesis";
    }
    return {};
}

// How normals that differ within a pixel widen its highlight.
enum class NormalFiltering { Off, Toksvig, Variance };
constexpr std::string_view wordOf(NormalFiltering filtering)
{
    switch (filtering) {
    case NormalFiltering::Off:
        return "off";
    case NormalFiltering::Toksvig:
        return "toksvig";
    case NormalFiltering::Variance:
        return "variance";
    }
    return {};
}

// What a light is: far away, or at a place and shining all around, or from there in a cone.
enum class LightKind { Off, Directional, Point, Spot };
constexpr std::string_view wordOf(LightKind kind)
{
    switch (kind) {
    case LightKind::Off:
        return "off";
    case LightKind::Directional:
        return "directional";
    case LightKind::Point:
        return "point";
    case LightKind::Spot:
        return "spot";
    }
    return {};
}

// How the relief's shadows on itself are found: by the technique's search, or by the map of its horizons.
enum class ShadowSearch { Searched, Horizon };
constexpr std::string_view wordOf(ShadowSearch search)
{
    switch (search) {
    case ShadowSearch::Searched:
        return "searched";
    case ShadowSearch::Horizon:
        return "horizon";
    }
    return {};
}

// In how many directions the map of horizons tells them.
enum class HorizonAzimuths { Eight, Sixteen };
constexpr std::string_view wordOf(HorizonAzimuths azimuths)
{
    switch (azimuths) {
    case HorizonAzimuths::Eight:
        return "8";
    case HorizonAzimuths::Sixteen:
        return "16";
    }
    return {};
}

// What the relief takes from the light of the surroundings: nothing, a share of it, or what comes from where it stands in the way.
enum class AmbientRelief { Off, Occlusion, Bent };
constexpr std::string_view wordOf(AmbientRelief ambient)
{
    switch (ambient) {
    case AmbientRelief::Off:
        return "off";
    case AmbientRelief::Occlusion:
        return "occlusion";
    case AmbientRelief::Bent:
        return "bent";
    }
    return {};
}

// What is drawn behind the mesh.
enum class Backdrop { Plain, Environment, Transparent, Gradient, Color };
constexpr std::string_view wordOf(Backdrop background)
{
    switch (background) {
    case Backdrop::Plain:
        return "plain";
    case Backdrop::Environment:
        return "environment";
    case Backdrop::Transparent:
        return "transparent";
    case Backdrop::Gradient:
        return "gradient";
    case Backdrop::Color:
        return "color";
    }
    return {};
}

// From light to what a screen can show; the shader text of each cites its source.
enum class ToneCurve { Neutral, Agx, Aces, Filmic, None };
constexpr std::string_view wordOf(ToneCurve curve)
{
    switch (curve) {
    case ToneCurve::Neutral:
        return "neutral";
    case ToneCurve::Agx:
        return "agx";
    case ToneCurve::Aces:
        return "aces";
    case ToneCurve::Filmic:
        return "filmic";
    case ToneCurve::None:
        return "none";
    }
    return {};
}

// The number of a choice's last option, as a row's limit.
template <IsChoice E> inline constexpr float kLast = float(kChoices<E> - 1);

} // namespace relievo
