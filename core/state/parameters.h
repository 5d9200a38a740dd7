// Every editable number of a relief material, each declared here and nowhere else.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace relievo {

struct Parameters { // the initialisers ARE the defaults
    // Shape
    float depth = 0.08f;
    float midlevel = 1.f;
    float tiling = 1.f;
    float offsetU = 0.f;
    float offsetV = 0.f;
    float rotation = 0.f;
    float metresPerUV = 0.f;
    int wrap = 0;
    float normalStrength = 1.f;
    // Search
    int minSteps = 8;
    int maxSteps = 32;
    int refineSteps = 6;
    int leapSteps = 15;
    bool doublePrecision = false;
    bool lastBracket = false;
    bool provenStep = false;
    bool safeBalls = false;
    bool offsetLimiting = false;
    bool heightMips = true;
    // On the mesh
    int frames = 0;
    int silhouettes = 0;
    bool depthOfHit = false;
    float edgeFade = 0.f;
    int clip = 0;
    float time = 0.f;
    // Shadows
    bool shadows = true;
    float shadowStrength = 1.f;
    float shadowBias = 0.02f;
    float lightSize = 0.f;
    bool objectShadows = false;
    int shadowMapSize = 1024;
    // Shading
    int shading = 0;
    glm::vec3 tint{1.f};
    float roughness = 1.f;
    float metallic = 1.f;
    float specular = 0.5f;
    float shininess = 40.f;
    float aoStrength = 1.f;
    float emission = 1.f;
    // Light
    float lightYaw = -50.f;
    float lightPitch = 40.f;
    float lightIntensity = 1.4f;
    glm::vec3 lightColor{1.f, 0.96f, 0.9f};
    float environmentIntensity = 0.45f;
    float environmentYaw = 0.f;
    float exposure = 0.f;
    // View
    int background = 0;
    bool wireframe = false;
    float fetchRange = 40.f;
    float errorRange = 0.05f;
    bool operator==(const Parameters&) const = default;
};

// The kinds of parameter. A choice is an int whose row lists its options; a vec3 is a linear colour.
using Member = std::variant<float Parameters::*, int Parameters::*, bool Parameters::*, glm::vec3 Parameters::*>;

enum class Group { Shape, Search, Mesh, Shadows, Shading, Light, View };
inline constexpr std::array<std::string_view, 7> kGroupLabels = {"Shape", "Search", "On the mesh", "Shadows", "Shading", "Light", "View"};

struct ParameterRow {
    Member member;
    std::string_view key; // JSON key, CLI --set name and GLSL uniform, all three
    std::string_view label;
    Group group;
    float min, max; // hard limits: loading clamps and warns, the slider stops
    std::string_view unit; // "" for a plain number
    // "" always; words that must all hold; "technique": the technique lists it; "animated": the mesh moves, shown in a bar of its own;
    // "KEY=VALUE": KEY has that value
    std::string_view shown;
    std::string_view options; // choices, separated by spaces, in the order of their values; "" for anything else
    std::string_view help;
};

inline constexpr auto kParameters = std::to_array<ParameterRow>({
    {&Parameters::depth, "depth", "Depth", Group::Shape, 0.f, 0.5f, "tile", "", "",
        "Distance from the surface down to height 0 (black), as a share of one tile's width."},
    {&Parameters::midlevel, "midlevel", "Midlevel", Group::Shape, 0.f, 1.f, "", "", "",
        "Height that lies on the mesh. At 1 the relief only goes inward; below 1 the mesh is pushed out by the rest."},
    {&Parameters::tiling, "tiling", "Tiling", Group::Shape, 0.01f, 1000.f, "tiles/UV", "", "", "Tiles along one unit of UV."},
    {&Parameters::offsetU, "offsetU", "Offset U", Group::Shape, -10.f, 10.f, "tile", "", "", "Shift of the material along u."},
    {&Parameters::offsetV, "offsetV", "Offset V", Group::Shape, -10.f, 10.f, "tile", "", "", "Shift of the material along v (downwards)."},
    {&Parameters::rotation, "rotation", "Rotation", Group::Shape, -180.f, 180.f, "deg", "", "",
        "Turn of the material on the surface, counter-clockwise."},
    {&Parameters::metresPerUV, "metresPerUV", "Size of a UV unit", Group::Shape, 0.f, 1000.f, "m", "", "",
        "Metres along one unit of UV; 0 measures it from the mesh. Depth in metres = depth x this / tiling."},
    {&Parameters::wrap, "wrap", "Wrap", Group::Shape, 0.f, 1.f, "", "", "repeat clamp",
        "What lies outside the texture: the tile again, or its border."},
    {&Parameters::normalStrength, "normalStrength", "Normal strength", Group::Shape, 0.f, 4.f, "x", "", "",
        "Scales the slopes of the normal map (or of the normals made from height)."},

    {&Parameters::minSteps, "minSteps", "Fewest steps", Group::Search, 1.f, 512.f, "", "technique", "",
        "Samples of the coarse search when looking straight down."},
    {&Parameters::maxSteps, "maxSteps", "Most steps", Group::Search, 1.f, 512.f, "", "technique", "",
        "Samples of the coarse search at grazing views."},
    {&Parameters::refineSteps, "refineSteps", "Refining steps", Group::Search, 0.f, 16.f, "", "technique", "",
        "Halvings that follow the coarse hit."},
    {&Parameters::leapSteps, "leapSteps", "Most leaps", Group::Search, 1.f, 4096.f, "", "technique", "",
        "Steps from cone to cone (or ball to ball) before the search gives up; few of them stop short at grazing views and darken "
        "self-shadows."},
    {&Parameters::doublePrecision, "doublePrecision", "Double precision", Group::Search, 0.f, 1.f, "", "technique", "",
        "20 linear steps and 5 halvings instead of 10 and 6 (Policarpo 2004)."},
    {&Parameters::lastBracket, "lastBracket", "Halve last step only", Group::Search, 0.f, 1.f, "", "technique", "",
        "Off: halves all of the way, as printed in GPU Gems 3. On: only the step that went inside, which finds the right hit more often."},
    {&Parameters::provenStep, "provenStep", "Proven step", Group::Search, 0.f, 1.f, "", "technique", "",
        "Measures the ray by |du| + |dv|, which a bilinear surface cannot outrun, instead of by its length as in the paper."},
    {&Parameters::safeBalls, "safeBalls", "Safe balls", Group::Search, 0.f, 1.f, "", "technique", "",
        "Makes every ball smaller by half the diagonal of a voxel, by which the paper's interpolated distance may be too long: no "
        "step leads through the surface, and all end that much above it."},
    {&Parameters::offsetLimiting, "offsetLimiting", "Offset limiting", Group::Search, 0.f, 1.f, "", "technique", "",
        "Drops the division by the view's height (Welsh 2004): steadier at grazing views, but too shallow there."},
    {&Parameters::heightMips, "heightMips", "Coarser far away", Group::Search, 0.f, 1.f, "", "technique", "",
        "Searches a coarser mip level of the height map where it is minified."},

    {&Parameters::frames, "frames", "Frames", Group::Mesh, 0.f, 2.f, "", "", "vertex derivatives thesis",
        "How the texture lies on the mesh: from the vertices, from the screen's derivatives (needs no tangents), or from those as the "
        "thesis on derivative-based relief mapping has it, which loses skew."},
    {&Parameters::silhouettes, "silhouettes", "Silhouettes", Group::Mesh, 0.f, 3.f, "", "technique", "off axes quadric prisms",
        "Bends the search ray over the curved mesh and cuts off what is past its outline or a border. Axes: curvature along the tangents "
        "only, as in the papers; quadric: all of it; prisms: the ray goes from triangle to triangle, slower, and right on any mesh."},
    {&Parameters::depthOfHit, "depthOfHit", "Depth of the relief", Group::Mesh, 0.f, 1.f, "", "", "",
        "Writes the depth of the point seen instead of the polygon's, so that surfaces meet where their relief does."},
    {&Parameters::edgeFade, "edgeFade", "Fade at edges", Group::Mesh, 0.f, 1.f, "cos", "", "",
        "Makes the relief shallow where the surface is seen edge-on: below this cosine of view; 0 keeps its depth."},
    {&Parameters::clip, "clip", "Animation", Group::Mesh, 0.f, 63.f, "", "animated", "",
        "Which animation of the mesh moves it, counted from 0."},
    {&Parameters::time, "time", "Time", Group::Mesh, 0.f, 3600.f, "s", "animated", "",
        "Moment of the animation, which repeats after its end."},

    {&Parameters::shadows, "shadows", "Self-shadows", Group::Shadows, 0.f, 1.f, "", "technique", "",
        "Relief casts hard shadows on itself, found by the same search towards the light."},
    {&Parameters::shadowStrength, "shadowStrength", "Strength", Group::Shadows, 0.f, 1.f, "", "shadows=1", "",
        "Share of the light that a shadow takes away."},
    {&Parameters::shadowBias, "shadowBias", "Bias", Group::Shadows, 0.f, 0.2f, "depth", "technique shadows=1", "",
        "How much higher than the point an occluder must lie, as a share of the depth; hides shadow acne. Exact techniques need none."},
    {&Parameters::lightSize, "lightSize", "Light size", Group::Shadows, 0.f, 20.f, "deg", "shadows=1", "",
        "Angle that the light's disc fills: 0 casts hard shadows, more casts penumbras (and costs 8 searches instead of one)."},
    {&Parameters::objectShadows, "objectShadows", "Between objects", Group::Shadows, 0.f, 1.f, "", "", "",
        "Objects cast shadows on each other, with their relief: a map of what the light sees."},
    {&Parameters::shadowMapSize, "shadowMapSize", "Shadow map", Group::Shadows, 64.f, 8192.f, "texels", "objectShadows=1", "",
        "Texels a side of the map for shadows between objects; more make finer edges."},

    {&Parameters::shading, "shading", "Model", Group::Shading, 0.f, 1.f, "", "", "metallic-roughness blinn-phong",
        "Metallic-roughness as glTF and engines, or Blinn-Phong as the relief mapping papers."},
    {&Parameters::tint, "tint", "Tint", Group::Shading, 0.f, 1.f, "linear", "", "", "Multiplies the base color."},
    {&Parameters::roughness, "roughness", "Roughness", Group::Shading, 0.f, 1.f, "x", "shading=0", "",
        "Multiplies the roughness map; the roughness itself when there is none."},
    {&Parameters::metallic, "metallic", "Metallic", Group::Shading, 0.f, 1.f, "x", "shading=0", "",
        "Multiplies the metallic map; without a map the material is not metal."},
    {&Parameters::specular, "specular", "Specular", Group::Shading, 0.f, 1.f, "", "shading=1", "",
        "Strength of the highlight; multiplies the specular map."},
    {&Parameters::shininess, "shininess", "Shininess", Group::Shading, 1.f, 512.f, "", "shading=1", "",
        "Exponent of the Blinn-Phong highlight."},
    {&Parameters::aoStrength, "aoStrength", "Occlusion", Group::Shading, 0.f, 1.f, "", "", "",
        "How much the occlusion map darkens ambient light."},
    {&Parameters::emission, "emission", "Emission", Group::Shading, 0.f, 100.f, "x", "", "", "Multiplies the emission map."},

    {&Parameters::lightYaw, "lightYaw", "Direction", Group::Light, -180.f, 180.f, "deg", "", "",
        "Where the light comes from, about the vertical axis; 0 is +z."},
    {&Parameters::lightPitch, "lightPitch", "Height", Group::Light, -90.f, 90.f, "deg", "", "", "Angle of the light above the horizon."},
    {&Parameters::lightIntensity, "lightIntensity", "Intensity", Group::Light, 0.f, 20.f, "", "", "", "Irradiance of the light over pi."},
    {&Parameters::lightColor, "lightColor", "Color", Group::Light, 0.f, 1.f, "linear", "", "", "Color of the light."},
    {&Parameters::environmentIntensity, "environmentIntensity", "Environment", Group::Light, 0.f, 10.f, "x", "", "",
        "Multiplies the light of the surroundings."},
    {&Parameters::environmentYaw, "environmentYaw", "Turn environment", Group::Light, -180.f, 180.f, "deg", "", "",
        "Turns the surroundings about the vertical axis."},
    {&Parameters::exposure, "exposure", "Exposure", Group::Light, -8.f, 8.f, "EV", "", "", "Brightness of the picture in stops."},

    {&Parameters::background, "background", "Background", Group::View, 0.f, 2.f, "", "", "plain environment transparent",
        "What is drawn behind the mesh."},
    {&Parameters::wireframe, "wireframe", "Wireframe", Group::View, 0.f, 1.f, "", "", "",
        "Draws the edges of the triangles over the picture."},
    {&Parameters::fetchRange, "fetchRange", "Fetches shown up to", Group::View, 1.f, 1024.f, "fetches", "", "",
        "Texture fetches at the bright end of the fetches view."},
    {&Parameters::errorRange, "errorRange", "Error shown up to", Group::View, 0.0001f, 1.f, "depth", "", "",
        "Depth error at the bright end of the views Error and Overshoot, as a share of the depth."},
});

const ParameterRow* findParameter(std::string_view key); // nullptr when unknown

// Number of options of a choice row, 0 for any other.
constexpr int optionCount(const ParameterRow& row)
{
    int count = row.options.empty() ? 0 : 1;
    for (char c : row.options)
        count += c == ' ';
    return count;
}
std::string_view option(const ParameterRow& row, int index); // "" outside
std::optional<int> findOption(const ParameterRow& row, std::string_view); // by name

// One parameter's value, whatever its kind. Comparable, so that overrides and undo can be.
using Value = std::variant<float, int, bool, glm::vec3>;
Value get(const Parameters& parameters, const ParameterRow& row);
void set(Parameters& parameters, const ParameterRow& row, const Value& value); // the kinds must agree (asserted)
bool inRange(const ParameterRow& row, const Value& value);
Value clamped(const ParameterRow& row, const Value& value); // NaN becomes the minimum

// "0.08", "32", "true", "repeat", "#ffcc00" or "1,0.8,0": as on the command line. Nothing when the text is not of the row's kind.
std::optional<Value> parseValue(const ParameterRow& row, std::string_view text);
std::string toText(const ParameterRow& row, const Value& value); // reads back exactly by parseValue

namespace detail {
struct Any {
    template <class T> constexpr operator T() const;
};
template <class T, class... A> consteval std::size_t arity()
{
    if constexpr (requires { T{A{}..., Any{}}; })
        return arity<T, A..., Any>();
    else
        return sizeof...(A);
}
constexpr bool defaultInRange(const ParameterRow& row)
{
    const Parameters defaults;
    return std::visit(
        [&](auto member) {
            if constexpr (std::is_same_v<decltype(member), glm::vec3 Parameters::*>) {
                const glm::vec3 v = defaults.*member;
                return v.x >= row.min && v.x <= row.max && v.y >= row.min && v.y <= row.max && v.z >= row.min && v.z <= row.max;
            } else {
                return float(defaults.*member) >= row.min && float(defaults.*member) <= row.max;
            }
        },
        row.member);
}
consteval bool rowsAreSound()
{
    for (std::size_t i = 0; i < kParameters.size(); ++i) {
        const ParameterRow& row = kParameters[i];
        for (std::size_t j = 0; j < i; ++j)
            if (kParameters[j].key == row.key || kParameters[j].member == row.member)
                return false;
        if (row.key.empty() || row.label.empty() || row.help.empty() || !(row.min < row.max) || !defaultInRange(row))
            return false;
        if (!row.options.empty() && (row.min != 0.f || row.max != float(optionCount(row) - 1)))
            return false;
    }
    return true;
}
} // namespace detail
static_assert(detail::arity<Parameters>() == kParameters.size(), "each member of Parameters wants exactly one row in kParameters");
static_assert(detail::rowsAreSound(), "a key or member twice, a default outside its range, or a row without label or help");

} // namespace relievo
