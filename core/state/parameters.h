// Every editable number of a relief material, each declared here and nowhere else.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/choice.h"
#include "core/state/choices.h"
#include <algorithm>
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
    Wrap wrap = Wrap::Repeat;
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
    bool crossDiscard = true;
    float sideTolerance = 0.01f;
    // On the mesh
    Frames frames = Frames::Vertex;
    Silhouettes silhouettes = Silhouettes::Off;
    bool depthOfHit = false;
    float edgeFade = 0.f;
    int clip = 0;
    float time = 0.f;
    // Shadows
    bool shadows = true;
    float shadowStrength = 1.f;
    float shadowBias = 0.02f;
    float lightSize = 0.f;
    ShadowSearch shadowSearch = ShadowSearch::Searched;
    AmbientRelief ambientRelief = AmbientRelief::Off;
    bool specularOcclusion = false;
    HorizonAzimuths horizonAzimuths = HorizonAzimuths::Sixteen;
    bool objectShadows = false;
    int shadowMapSize = 1024;
    // Filtering
    bool textureFilter = true;
    bool mipMapping = true;
    float anisotropy = 4.f;
    NormalFiltering normalFiltering = NormalFiltering::Off;
    // Shading
    Shading shading = Shading::MetallicRoughness;
    glm::vec3 tint{1.f};
    float roughness = 1.f;
    float metallic = 1.f;
    float specular = 0.5f;
    float shininess = 40.f;
    float aoStrength = 1.f;
    float emission = 1.f;
    float mirror = 0.f;
    float ior = 1.5f;
    // Layers
    float clearcoat = 0.f;
    float clearcoatRoughness = 0.f;
    float sheen = 0.f;
    glm::vec3 sheenColor{1.f};
    float sheenRoughness = 0.4f;
    float transmission = 0.f;
    float anisotropyStrength = 0.f;
    float anisotropyRotation = 0.f;
    // Light
    LightKind lightKind = LightKind::Directional;
    float lightYaw = -50.f;
    float lightPitch = 40.f;
    float lightDistance = 2.5f;
    float lightIntensity = 1.4f;
    glm::vec3 lightColor{1.f, 0.96f, 0.9f};
    float lightCone = 40.f;
    float lightSoftness = 0.3f;
    float turnSeconds = 10.f;
    float lightTurn = 0.f;
    float environmentIntensity = 0.45f;
    float environmentYaw = 0.f;
    // Light 2
    LightKind light2Kind = LightKind::Off;
    float light2Yaw = 50.f;
    float light2Pitch = 25.f;
    float light2Distance = 2.5f;
    float light2Intensity = 1.f;
    glm::vec3 light2Color{0.55f, 0.75f, 1.f};
    float light2Cone = 40.f;
    float light2Softness = 0.3f;
    float light2Size = 0.f;
    bool light2Shadows = true;
    // Light 3
    LightKind light3Kind = LightKind::Off;
    float light3Yaw = 165.f;
    float light3Pitch = 20.f;
    float light3Distance = 2.5f;
    float light3Intensity = 1.f;
    glm::vec3 light3Color{1.f, 0.6f, 0.35f};
    float light3Cone = 40.f;
    float light3Softness = 0.3f;
    float light3Size = 0.f;
    bool light3Shadows = true;
    // Light 4
    LightKind light4Kind = LightKind::Off;
    float light4Yaw = 0.f;
    float light4Pitch = 75.f;
    float light4Distance = 2.5f;
    float light4Intensity = 1.f;
    glm::vec3 light4Color{1.f, 1.f, 1.f};
    float light4Cone = 40.f;
    float light4Softness = 0.3f;
    float light4Size = 0.f;
    bool light4Shadows = true;
    // Camera
    float exposure = 0.f;
    bool autoExposure = false;
    float whiteBalance = 6500.f;
    ToneCurve toneCurve = ToneCurve::Neutral;
    float vignette = 0.f;
    float fStop = 0.f;
    float focusDistance = 0.f;
    float bloom = 0.f;
    float bloomThreshold = 1.f;
    float bloomSize = 0.1f;
    // View
    Backdrop background = Backdrop::Plain;
    glm::vec3 backgroundColor{0.5f};
    float backgroundBlur = 0.3f;
    bool ground = false;
    float groundReflection = 0.f;
    bool wireframe = false;
    float fetchRange = 40.f;
    float errorRange = 0.05f;
    float pixelRange = 4.f;
    bool operator==(const Parameters&) const = default;
};

// The kinds of parameter. A vec3 is a linear colour.
using Member = std::variant<float Parameters::*, int Parameters::*, bool Parameters::*, glm::vec3 Parameters::*, Wrap Parameters::*,
    Frames Parameters::*, Silhouettes Parameters::*, Shading Parameters::*, Backdrop Parameters::*, ToneCurve Parameters::*,
    NormalFiltering Parameters::*, LightKind Parameters::*, ShadowSearch Parameters::*, HorizonAzimuths Parameters::*,
    AmbientRelief Parameters::*>;

template <class M> struct MemberTypeOf;
template <class T> struct MemberTypeOf<T Parameters::*> {
    using Type = T;
};
template <class M> using MemberType = typename MemberTypeOf<M>::Type;

enum class Group { Shape, Search, Mesh, Shadows, Filtering, Shading, Layers, Light, Light2, Light3, Light4, Camera, View };
constexpr std::string_view wordOf(Group group)
{
    switch (group) {
    case Group::Shape:
        return "Shape";
    case Group::Search:
        return "Search";
    case Group::Mesh:
        return "On the mesh";
    case Group::Shadows:
        return "Shadows";
    case Group::Filtering:
        return "Filtering";
    case Group::Shading:
        return "Shading";
    case Group::Layers:
        return "Layers";
    case Group::Light:
        return "Light";
    case Group::Light2:
        return "Light 2";
    case Group::Light3:
        return "Light 3";
    case Group::Light4:
        return "Light 4";
    case Group::Camera:
        return "Camera";
    case Group::View:
        return "View";
    }
    return {};
}

// What has to be made again when a parameter changes, beside the picture itself, which costs a uniform. Whatever is kept from picture to
// picture is decided by this alone.
enum class Affects {
    ProgramText, // the text of the programs
    Search, // what a ray at full resolution finds, when the technique lists the parameter
    ShadowMap, // what the light sees (shadows between objects)
    ExactAnswer, // where the displaced mesh lies
    Pose, // how a mesh with animations stands
};

// Which shader text a parameter chooses, one file for each option (of a switch, or of a number that is 0 or more, off and on), and where it
// stands in a program: before the search, where light is computed, over the shading model where there is any such layer, or where it is
// shown.
enum class ShaderPlace { Surface, Light, Layer, Display };
struct ShaderChoice {
    ShaderPlace place = ShaderPlace::Surface;
    std::array<std::string_view, 5> files = {}; // under shaders/
};

// Another parameter's value: a switch, or one of several of a choice's.
struct Condition {
    Member member;
    unsigned values; // a bit for each that is wanted, by its number
    template <class T, class... More> constexpr Condition(T Parameters::*of, T wanted, More... orElse) : member(of), values(0)
    {
        for (const int value : {int(wanted), int(orElse)...})
            values |= 1u << value;
    }
    constexpr bool holdsFor(int value) const { return value >= 0 && (values >> value & 1u) != 0; }
};
// When a row has a line in the panel; it must all hold, of the two conditions one.
struct ShownWhen {
    bool byTechnique = false; // the technique lists it
    bool inAnimationBar = false; // never there: it stands in a bar of its own
    std::optional<Condition> when = {};
    std::optional<Condition> orWhen = {};
};

struct ParameterRow {
    Member member;
    std::string_view key; // JSON key, CLI --set name and GLSL uniform, all three
    std::string_view label;
    Group group;
    float min = 0.f, max = 1.f; // hard limits: loading clamps and warns, the slider stops
    std::string_view unit = {}; // "" for a plain number
    EnumSet<Affects> affects = {};
    ShaderChoice shader = {}; // none for most
    ShownWhen shown = {};
    bool sharedByPanes = false; // the panel sets it for all panes, so that pictures side by side can be compared
    std::string_view help;
};

// The rows that each light has, by its members and their keys.
namespace detail {
using LightKindMember = LightKind Parameters::*;
constexpr Condition isLit(LightKindMember kind)
{
    return {kind, LightKind::Directional, LightKind::Point, LightKind::Spot};
}
constexpr ParameterRow lightKindRow(LightKindMember member, std::string_view key, Group group)
{
    return {.member = member,
        .key = key,
        .label = "Kind",
        .group = group,
        .max = kLast<LightKind>,
        .affects = {Affects::ProgramText},
        .help = "Directional as the sun; a point that shines all around, or a spot that shines in a cone, from a place near the mesh."};
}
constexpr ParameterRow lightYawRow(float Parameters::*member, std::string_view key, Group group, LightKindMember kind, bool castsOnObjects)
{
    return {.member = member,
        .key = key,
        .label = "Direction",
        .group = group,
        .min = -180.f,
        .max = 180.f,
        .unit = "deg",
        .affects = castsOnObjects ? EnumSet<Affects>{Affects::ShadowMap} : EnumSet<Affects>{},
        .shown = {.when = isLit(kind)},
        .help = "Where the light comes from, about the vertical axis; 0 is +z."};
}
constexpr ParameterRow lightPitchRow(
    float Parameters::*member, std::string_view key, Group group, LightKindMember kind, bool castsOnObjects)
{
    return {.member = member,
        .key = key,
        .label = "Height",
        .group = group,
        .min = -90.f,
        .max = 90.f,
        .unit = "deg",
        .affects = castsOnObjects ? EnumSet<Affects>{Affects::ShadowMap} : EnumSet<Affects>{},
        .shown = {.when = isLit(kind)},
        .help = "Angle of the light above the horizon."};
}
constexpr ParameterRow lightDistanceRow(float Parameters::*member, std::string_view key, Group group, LightKindMember kind)
{
    return {.member = member,
        .key = key,
        .label = "Distance",
        .group = group,
        .min = 0.01f,
        .max = 20.f,
        .unit = "radii",
        .shown = {.when = Condition(kind, LightKind::Point, LightKind::Spot)},
        .help = "From the mesh's middle to the light, in radii of the sphere around the mesh: from 1 on it is outside."};
}
constexpr ParameterRow lightIntensityRow(float Parameters::*member, std::string_view key, Group group, LightKindMember kind)
{
    return {.member = member,
        .key = key,
        .label = "Intensity",
        .group = group,
        .max = 20.f,
        .unit = "\u03c0 W/m\u00b2",
        .shown = {.when = isLit(kind)},
        .help
        = "Irradiance of the light over pi; of a point or a spot, where the mesh's middle is: it falls off by the square of the distance."};
}
constexpr ParameterRow lightColorRow(glm::vec3 Parameters::*member, std::string_view key, Group group, LightKindMember kind)
{
    return {.member = member,
        .key = key,
        .label = "Color",
        .group = group,
        .unit = "linear",
        .shown = {.when = isLit(kind)},
        .help = "Color of the light."};
}
constexpr ParameterRow lightConeRow(float Parameters::*member, std::string_view key, Group group, LightKindMember kind)
{
    return {.member = member,
        .key = key,
        .label = "Cone",
        .group = group,
        .min = 1.f,
        .max = 170.f,
        .unit = "deg",
        .shown = {.when = Condition(kind, LightKind::Spot)},
        .help = "Whole angle of the spot's cone, which is turned to the mesh's middle."};
}
constexpr ParameterRow lightSoftnessRow(float Parameters::*member, std::string_view key, Group group, LightKindMember kind)
{
    return {.member = member,
        .key = key,
        .label = "Soft edge",
        .group = group,
        .unit = "cone",
        .shown = {.when = Condition(kind, LightKind::Spot)},
        .help = "Share of the cone over which it fades towards its edge."};
}
constexpr ParameterRow lightSizeRow(float Parameters::*member, std::string_view key, Group group, bool Parameters::*shadows)
{
    return {.member = member,
        .key = key,
        .label = "Light size",
        .group = group,
        .max = 20.f,
        .unit = "deg",
        .affects = {Affects::ProgramText},
        .shown = {.when = Condition(shadows, true)},
        .help = "Angle that the light's disc fills: 0 casts hard shadows, more casts penumbras (and costs 8 searches instead of one)."};
}
constexpr ParameterRow lightShadowsRow(bool Parameters::*member, std::string_view key, Group group, LightKindMember kind)
{
    return {.member = member,
        .key = key,
        .label = "Self-shadows",
        .group = group,
        .affects = {Affects::ProgramText},
        .shown = {.when = isLit(kind)},
        .help
        = "Relief casts shadows on itself in this light too, where its technique can: one more search. A light within the relief is taken "
          "for one above it."};
}
} // namespace detail

inline constexpr auto kParameters = std::to_array<ParameterRow>({
    {.member = &Parameters::depth,
        .key = "depth",
        .label = "Depth",
        .group = Group::Shape,
        .max = 1.5f,
        .unit = "tile",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Distance from the surface down to height 0 (black), as a share of one tile's width."},
    {.member = &Parameters::midlevel,
        .key = "midlevel",
        .label = "Midlevel",
        .group = Group::Shape,
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Height that lies on the mesh. At 1 the relief only goes inward; below 1 the mesh is pushed out by the rest."},
    {.member = &Parameters::tiling,
        .key = "tiling",
        .label = "Tiling",
        .group = Group::Shape,
        .min = 0.01f,
        .max = 1000.f,
        .unit = "tiles/UV",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Tiles along one unit of UV."},
    {.member = &Parameters::offsetU,
        .key = "offsetU",
        .label = "Offset U",
        .group = Group::Shape,
        .min = -10.f,
        .max = 10.f,
        .unit = "tile",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Shift of the material along u."},
    {.member = &Parameters::offsetV,
        .key = "offsetV",
        .label = "Offset V",
        .group = Group::Shape,
        .min = -10.f,
        .max = 10.f,
        .unit = "tile",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Shift of the material along v (downwards)."},
    {.member = &Parameters::rotation,
        .key = "rotation",
        .label = "Rotation",
        .group = Group::Shape,
        .min = -180.f,
        .max = 180.f,
        .unit = "deg",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Turn of the material on the surface, counter-clockwise."},
    {.member = &Parameters::metresPerUV,
        .key = "metresPerUV",
        .label = "Size of a UV unit",
        .group = Group::Shape,
        .max = 1000.f,
        .unit = "m",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer},
        .help = "Metres along one unit of UV; 0 measures it from the mesh. Depth in metres = depth x this / tiling."},
    {.member = &Parameters::wrap,
        .key = "wrap",
        .label = "Wrap",
        .group = Group::Shape,
        .max = kLast<Wrap>,
        .affects = {Affects::ProgramText, Affects::ShadowMap, Affects::ExactAnswer},
        .help = "What lies outside the texture: the tile again, or its border."},
    {.member = &Parameters::normalStrength,
        .key = "normalStrength",
        .label = "Normal strength",
        .group = Group::Shape,
        .max = 4.f,
        .unit = "x",
        .help = "Scales the slopes of the normal map (or of the normals made from height)."},

    {.member = &Parameters::minSteps,
        .key = "minSteps",
        .label = "Fewest steps",
        .group = Group::Search,
        .min = 1.f,
        .max = 512.f,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Samples of the coarse search when looking straight down."},
    {.member = &Parameters::maxSteps,
        .key = "maxSteps",
        .label = "Most steps",
        .group = Group::Search,
        .min = 1.f,
        .max = 512.f,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Samples of the coarse search at grazing views."},
    {.member = &Parameters::refineSteps,
        .key = "refineSteps",
        .label = "Refining steps",
        .group = Group::Search,
        .max = 16.f,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Halvings that follow the coarse hit."},
    {.member = &Parameters::leapSteps,
        .key = "leapSteps",
        .label = "Most leaps",
        .group = Group::Search,
        .min = 1.f,
        .max = 4096.f,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Steps from cone to cone (or ball to ball) before the search gives up; few of them stop short at grazing views and darken "
                "self-shadows."},
    {.member = &Parameters::doublePrecision,
        .key = "doublePrecision",
        .label = "Double precision",
        .group = Group::Search,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "20 linear steps and 5 halvings instead of 10 and 6 (Policarpo 2004)."},
    {.member = &Parameters::lastBracket,
        .key = "lastBracket",
        .label = "Halve last step only",
        .group = Group::Search,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Off: halves all of the way, as printed in GPU Gems 3. On: only the step that went inside, which finds the right hit more "
                "often."},
    {.member = &Parameters::provenStep,
        .key = "provenStep",
        .label = "Proven step",
        .group = Group::Search,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Measures the ray by |du| + |dv|, which a bilinear surface cannot outrun, instead of by its length as in the paper."},
    {.member = &Parameters::safeBalls,
        .key = "safeBalls",
        .label = "Safe balls",
        .group = Group::Search,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Makes every ball smaller by half the diagonal of a voxel, by which the paper's interpolated distance may be too long: no "
                "step leads through the surface, and all end that much above it."},
    {.member = &Parameters::offsetLimiting,
        .key = "offsetLimiting",
        .label = "Offset limiting",
        .group = Group::Search,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Drops the division by the view's height (Welsh 2004): steadier at grazing views, but too shallow there."},
    {.member = &Parameters::heightMips,
        .key = "heightMips",
        .label = "Coarser far away",
        .group = Group::Search,
        .affects = {Affects::ProgramText, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "Searches a coarser mip level of the height map where it is minified."},
    {.member = &Parameters::crossDiscard,
        .key = "crossDiscard",
        .label = "Discard across sides",
        .group = Group::Search,
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help = "What a side of a relief object finds is dropped where the sides at right angles to it say that nothing is there (RTM "
                "report, section 5.2). Off: only the side that the ray enters by is searched, the report's naive form."},
    {.member = &Parameters::sideTolerance,
        .key = "sideTolerance",
        .label = "Discard tolerance",
        .group = Group::Search,
        .max = 0.2f,
        .unit = "box",
        .affects = {Affects::Search, Affects::ShadowMap},
        .shown = {.byTechnique = true, .when = Condition(&Parameters::crossDiscard, true)},
        .help = "How far outside of the other sides' solid a point may lie and still count, as a share of the box's length: more closes "
                "holes and thickens outlines."},

    {.member = &Parameters::frames,
        .key = "frames",
        .label = "Frames",
        .group = Group::Mesh,
        .max = kLast<Frames>,
        .affects = {Affects::ProgramText, Affects::ShadowMap},
        .shader = {.files = {"surface/frame_vertex.glsl", "surface/frame_derivatives.glsl", "surface/frame_thesis.glsl"}},
        .help
        = "How the texture lies on the mesh: from the vertices, from the screen's derivatives (needs no tangents), or from those as the "
          "thesis on derivative-based relief mapping has it, which loses skew."},
    {.member = &Parameters::silhouettes,
        .key = "silhouettes",
        .label = "Silhouettes",
        .group = Group::Mesh,
        .max = kLast<Silhouettes>,
        .affects = {Affects::ProgramText, Affects::ShadowMap},
        .shown = {.byTechnique = true},
        .help
        = "Bends the search ray over the curved mesh and cuts off what is past its outline or a border. Axes: curvature along the tangents "
          "only, as in the papers; quadric: all of it; prisms: the ray goes from triangle to triangle, slower, and right on any mesh."},
    {.member = &Parameters::depthOfHit,
        .key = "depthOfHit",
        .label = "Depth of the relief",
        .group = Group::Mesh,
        .affects = {Affects::ProgramText},
        .shader = {.files = {"surface/depth_of_polygon.glsl", "surface/depth_of_hit.glsl"}},
        .help = "Writes the depth of the point seen instead of the polygon's, so that surfaces meet where their relief does."},
    {.member = &Parameters::edgeFade,
        .key = "edgeFade",
        .label = "Fade at edges",
        .group = Group::Mesh,
        .unit = "cos",
        .affects = {Affects::ProgramText},
        .shader = {.files = {"surface/depth_constant.glsl", "surface/depth_faded.glsl"}},
        .help = "Makes the relief shallow where the surface is seen edge-on: below this cosine of view; 0 keeps its depth."},
    {.member = &Parameters::clip,
        .key = "clip",
        .label = "Animation",
        .group = Group::Mesh,
        .max = 63.f,
        .affects = {Affects::ShadowMap, Affects::ExactAnswer, Affects::Pose},
        .shown = {.inAnimationBar = true},
        .help = "Which animation of the mesh moves it, counted from 0."},
    {.member = &Parameters::time,
        .key = "time",
        .label = "Time",
        .group = Group::Mesh,
        .max = 3600.f,
        .unit = "s",
        .affects = {Affects::ShadowMap, Affects::ExactAnswer, Affects::Pose},
        .shown = {.inAnimationBar = true},
        .help = "Moment of the animation, which repeats after its end."},

    {.member = &Parameters::shadows,
        .key = "shadows",
        .label = "Self-shadows",
        .group = Group::Shadows,
        .affects = {Affects::ProgramText},
        .shown = {.byTechnique = true},
        .help = "Relief casts hard shadows on itself, found by the same search towards the light."},
    {.member = &Parameters::shadowStrength,
        .key = "shadowStrength",
        .label = "Strength",
        .group = Group::Shadows,
        .shown = {.when = Condition(&Parameters::shadows, true)},
        .help = "Share of the light that a shadow takes away."},
    {.member = &Parameters::shadowBias,
        .key = "shadowBias",
        .label = "Bias",
        .group = Group::Shadows,
        .max = 0.2f,
        .unit = "depth",
        .shown = {.byTechnique = true, .when = Condition(&Parameters::shadows, true)},
        .help
        = "How much higher than the point an occluder must lie, as a share of the depth; hides shadow acne. Exact techniques need none."},
    detail::lightSizeRow(&Parameters::lightSize, "lightSize", Group::Shadows, &Parameters::shadows),
    {.member = &Parameters::shadowSearch,
        .key = "shadowSearch",
        .label = "Found by",
        .group = Group::Shadows,
        .max = kLast<ShadowSearch>,
        .affects = {Affects::ProgramText},
        .shown = {.when = Condition(&Parameters::shadows, true)},
        .help = "How self-shadows of all lights are found: by the technique's search towards the light, or by a baked map that tells how "
                "high the relief stands around each texel (Max 1988): two texels instead of a search, for soft shadows too, right up to "
                "the map's texels and azimuths; it takes the mesh for flat around the point."},
    {.member = &Parameters::ambientRelief,
        .key = "ambientRelief",
        .label = "Ambient occlusion",
        .group = Group::Shadows,
        .max = kLast<AmbientRelief>,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Light, .files = {"shading/sky_none.glsl", "shading/sky_share.glsl", "shading/sky_bent.glsl"}},
        .help
        = "What the relief takes from the light of the surroundings, by the map of its horizons, at any depth: occlusion keeps the share "
          "that comes from above them; bent also reads the light where it comes from. Needs a height map."},
    {.member = &Parameters::specularOcclusion,
        .key = "specularOcclusion",
        .label = "Specular occlusion",
        .group = Group::Shadows,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Light, .files = {"shading/reflected_open.glsl", "shading/reflected_occluded.glsl"}},
        .shown = {.when = Condition(&Parameters::ambientRelief, AmbientRelief::Occlusion, AmbientRelief::Bent)},
        .help = "The relief also takes from reflections of the surroundings, less the smoother it is (Lagarde and de Rousiers 2014)."},
    {.member = &Parameters::horizonAzimuths,
        .key = "horizonAzimuths",
        .label = "Azimuths",
        .group = Group::Shadows,
        .max = kLast<HorizonAzimuths>,
        .shown = {.when = Condition(&Parameters::shadowSearch, ShadowSearch::Horizon),
            .orWhen = Condition(&Parameters::ambientRelief, AmbientRelief::Occlusion, AmbientRelief::Bent)},
        .help = "In how many directions the map of horizons tells them; between two it is interpolated. 16 take twice the memory of 8: 32 "
                "bytes a texel."},
    {.member = &Parameters::objectShadows,
        .key = "objectShadows",
        .label = "Between objects",
        .group = Group::Shadows,
        .affects = {Affects::ProgramText},
        .help = "Objects cast shadows on each other, with their relief: a map of what the first light sees, where that is directional."},
    {.member = &Parameters::shadowMapSize,
        .key = "shadowMapSize",
        .label = "Shadow map",
        .group = Group::Shadows,
        .min = 64.f,
        .max = 8192.f,
        .unit = "texels",
        .affects = {Affects::ShadowMap},
        .shown = {.when = Condition(&Parameters::objectShadows, true)},
        .help = "Texels a side of the map for shadows between objects; more make finer edges."},

    {.member = &Parameters::textureFilter,
        .key = "textureFilter",
        .label = "Texture filtering",
        .group = Group::Filtering,
        .help = "Off: the nearest texel of color, normal and all other maps but the heights, as old machines had it."},
    {.member = &Parameters::mipMapping,
        .key = "mipMapping",
        .label = "Mip mapping",
        .group = Group::Filtering,
        .affects = {Affects::ProgramText},
        .shader = {.files = {"surface/mips_none.glsl", "surface/mips.glsl"}},
        .help = "Off: the finest level of all maps but the heights (Coarser far away), which sparkles where they are minified."},
    {.member = &Parameters::anisotropy,
        .key = "anisotropy",
        .label = "Anisotropy",
        .group = Group::Filtering,
        .min = 1.f,
        .max = 16.f,
        .unit = "x",
        .help
        = "Where a pixel sees a long strip of the texture, mip levels follow its shorter side, but at most so much below the longer one: "
          "more is sharper at grazing views, and needs more samples."},
    {.member = &Parameters::normalFiltering,
        .key = "normalFiltering",
        .label = "Normals far away",
        .group = Group::Filtering,
        .max = kLast<NormalFiltering>,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Light,
            .files = {"shading/spread_none.glsl", "shading/spread_toksvig.glsl", "shading/spread_variance.glsl"}},
        .help
        = "Normals that differ within a pixel make it rougher, so that far views keep their brightness: by Toksvig's factor, or by adding "
          "their variance. Needs a normal map."},

    {.member = &Parameters::shading,
        .key = "shading",
        .label = "Model",
        .group = Group::Shading,
        .max = kLast<Shading>,
        .affects = {Affects::ProgramText},
        .shader
        = {.place = ShaderPlace::Light, .files = {"shading/metallic_roughness.glsl", "shading/blinn_phong.glsl", "shading/thesis.glsl"}},
        .help
        = "Metallic-roughness as glTF and engines, Blinn-Phong as the relief mapping papers, or Phong with reflection and refraction as "
          "the thesis on derivative-based relief mapping."},
    {.member = &Parameters::tint,
        .key = "tint",
        .label = "Tint",
        .group = Group::Shading,
        .unit = "linear",
        .help = "Multiplies the base color."},
    {.member = &Parameters::roughness,
        .key = "roughness",
        .label = "Roughness",
        .group = Group::Shading,
        .unit = "x",
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Multiplies the roughness map; the roughness itself when there is none."},
    {.member = &Parameters::metallic,
        .key = "metallic",
        .label = "Metallic",
        .group = Group::Shading,
        .unit = "x",
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Multiplies the metallic map; without a map the material is not metal."},
    {.member = &Parameters::specular,
        .key = "specular",
        .label = "Specular",
        .group = Group::Shading,
        .shown = {.when = Condition(&Parameters::shading, Shading::BlinnPhong)},
        .help = "Strength of the highlight; multiplies the specular map."},
    {.member = &Parameters::shininess,
        .key = "shininess",
        .label = "Shininess",
        .group = Group::Shading,
        .min = 1.f,
        .max = 512.f,
        .shown = {.when = Condition(&Parameters::shading, Shading::BlinnPhong)},
        .help = "Exponent of the Blinn-Phong highlight."},
    {.member = &Parameters::aoStrength,
        .key = "aoStrength",
        .label = "Occlusion",
        .group = Group::Shading,
        .help = "How much the occlusion map darkens ambient light."},
    {.member = &Parameters::emission,
        .key = "emission",
        .label = "Emission",
        .group = Group::Shading,
        .max = 100.f,
        .unit = "x",
        .help = "Multiplies the emission map."},
    {.member = &Parameters::mirror,
        .key = "mirror",
        .label = "Mirror",
        .group = Group::Shading,
        .shown = {.when = Condition(&Parameters::shading, Shading::Thesis)},
        .help = "Share of the surroundings' reflection in what is seen; blue of the optics map, where there is one."},
    {.member = &Parameters::ior,
        .key = "ior",
        .label = "Refraction",
        .group = Group::Shading,
        .min = 1.f,
        .max = 3.f,
        .help
        = "Index of refraction: how much is reflected from the front, and how light bends that goes through. Glass and most else: 1.5; "
          "the optics map has its inverse in green."},

    {.member = &Parameters::clearcoat,
        .key = "clearcoat",
        .label = "Clear coat",
        .group = Group::Layers,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Layer, .files = {"layers/coat_none.glsl", "layers/coat.glsl"}},
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "A layer of lacquer, as smooth as the mesh, over the relief's material."},
    {.member = &Parameters::clearcoatRoughness,
        .key = "clearcoatRoughness",
        .label = "Coat roughness",
        .group = Group::Layers,
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Roughness of the clear coat."},
    {.member = &Parameters::sheen,
        .key = "sheen",
        .label = "Sheen",
        .group = Group::Layers,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Layer, .files = {"layers/sheen_none.glsl", "layers/sheen.glsl"}},
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "The soft light along the edges of cloth and velvet."},
    {.member = &Parameters::sheenColor,
        .key = "sheenColor",
        .label = "Sheen color",
        .group = Group::Layers,
        .unit = "linear",
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Color of the sheen."},
    {.member = &Parameters::sheenRoughness,
        .key = "sheenRoughness",
        .label = "Sheen roughness",
        .group = Group::Layers,
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "How far the sheen spreads from the edges."},
    {.member = &Parameters::transmission,
        .key = "transmission",
        .label = "Transmission",
        .group = Group::Layers,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Layer, .files = {"layers/through_none.glsl", "layers/through.glsl"}},
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Share of the light that goes through instead of being scattered: the surroundings, bent by Refraction; a way of one "
                "relief depth "
                "colors it as the base color."},
    {.member = &Parameters::anisotropyStrength,
        .key = "anisotropyStrength",
        .label = "Anisotropy strength",
        .group = Group::Layers,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Layer, .files = {"layers/stretch_none.glsl", "layers/stretch.glsl"}},
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Stretches highlights and reflections along one direction of the surface, as brushed metal, hair and records have them."},
    {.member = &Parameters::anisotropyRotation,
        .key = "anisotropyRotation",
        .label = "Anisotropy rotation",
        .group = Group::Layers,
        .min = -180.f,
        .max = 180.f,
        .unit = "deg",
        .shown = {.when = Condition(&Parameters::shading, Shading::MetallicRoughness)},
        .help = "Direction in which highlights are stretched, counter-clockwise from the texture's u; scratches run across it."},

    detail::lightKindRow(&Parameters::lightKind, "lightKind", Group::Light),
    detail::lightYawRow(&Parameters::lightYaw, "lightYaw", Group::Light, &Parameters::lightKind, true),
    detail::lightPitchRow(&Parameters::lightPitch, "lightPitch", Group::Light, &Parameters::lightKind, true),
    detail::lightDistanceRow(&Parameters::lightDistance, "lightDistance", Group::Light, &Parameters::lightKind),
    detail::lightIntensityRow(&Parameters::lightIntensity, "lightIntensity", Group::Light, &Parameters::lightKind),
    detail::lightColorRow(&Parameters::lightColor, "lightColor", Group::Light, &Parameters::lightKind),
    detail::lightConeRow(&Parameters::lightCone, "lightCone", Group::Light, &Parameters::lightKind),
    detail::lightSoftnessRow(&Parameters::lightSoftness, "lightSoftness", Group::Light, &Parameters::lightKind),
    {.member = &Parameters::turnSeconds,
        .key = "turnSeconds",
        .label = "A turn takes",
        .group = Group::Light,
        .min = 1.f,
        .max = 120.f,
        .unit = "s",
        .help = "How long the lights (Ctrl + L) or the camera (Ctrl + T) take once around."},
    {.member = &Parameters::lightTurn,
        .key = "lightTurn",
        .label = "Turn lights",
        .group = Group::Light,
        .max = 360.f,
        .unit = "deg",
        .affects = {Affects::ShadowMap},
        .shown = {.inAnimationBar = true},
        .help = "How far all lights have turned about the vertical axis, as Ctrl + L turns them."},
    {.member = &Parameters::environmentIntensity,
        .key = "environmentIntensity",
        .label = "Environment",
        .group = Group::Light,
        .max = 10.f,
        .unit = "x",
        .help = "Multiplies the light of the surroundings."},
    {.member = &Parameters::environmentYaw,
        .key = "environmentYaw",
        .label = "Turn environment",
        .group = Group::Light,
        .min = -180.f,
        .max = 180.f,
        .unit = "deg",
        .help = "Turns the surroundings about the vertical axis."},
    detail::lightKindRow(&Parameters::light2Kind, "light2Kind", Group::Light2),
    detail::lightYawRow(&Parameters::light2Yaw, "light2Yaw", Group::Light2, &Parameters::light2Kind, false),
    detail::lightPitchRow(&Parameters::light2Pitch, "light2Pitch", Group::Light2, &Parameters::light2Kind, false),
    detail::lightDistanceRow(&Parameters::light2Distance, "light2Distance", Group::Light2, &Parameters::light2Kind),
    detail::lightIntensityRow(&Parameters::light2Intensity, "light2Intensity", Group::Light2, &Parameters::light2Kind),
    detail::lightColorRow(&Parameters::light2Color, "light2Color", Group::Light2, &Parameters::light2Kind),
    detail::lightConeRow(&Parameters::light2Cone, "light2Cone", Group::Light2, &Parameters::light2Kind),
    detail::lightSoftnessRow(&Parameters::light2Softness, "light2Softness", Group::Light2, &Parameters::light2Kind),
    detail::lightShadowsRow(&Parameters::light2Shadows, "light2Shadows", Group::Light2, &Parameters::light2Kind),
    detail::lightSizeRow(&Parameters::light2Size, "light2Size", Group::Light2, &Parameters::light2Shadows),

    detail::lightKindRow(&Parameters::light3Kind, "light3Kind", Group::Light3),
    detail::lightYawRow(&Parameters::light3Yaw, "light3Yaw", Group::Light3, &Parameters::light3Kind, false),
    detail::lightPitchRow(&Parameters::light3Pitch, "light3Pitch", Group::Light3, &Parameters::light3Kind, false),
    detail::lightDistanceRow(&Parameters::light3Distance, "light3Distance", Group::Light3, &Parameters::light3Kind),
    detail::lightIntensityRow(&Parameters::light3Intensity, "light3Intensity", Group::Light3, &Parameters::light3Kind),
    detail::lightColorRow(&Parameters::light3Color, "light3Color", Group::Light3, &Parameters::light3Kind),
    detail::lightConeRow(&Parameters::light3Cone, "light3Cone", Group::Light3, &Parameters::light3Kind),
    detail::lightSoftnessRow(&Parameters::light3Softness, "light3Softness", Group::Light3, &Parameters::light3Kind),
    detail::lightShadowsRow(&Parameters::light3Shadows, "light3Shadows", Group::Light3, &Parameters::light3Kind),
    detail::lightSizeRow(&Parameters::light3Size, "light3Size", Group::Light3, &Parameters::light3Shadows),

    detail::lightKindRow(&Parameters::light4Kind, "light4Kind", Group::Light4),
    detail::lightYawRow(&Parameters::light4Yaw, "light4Yaw", Group::Light4, &Parameters::light4Kind, false),
    detail::lightPitchRow(&Parameters::light4Pitch, "light4Pitch", Group::Light4, &Parameters::light4Kind, false),
    detail::lightDistanceRow(&Parameters::light4Distance, "light4Distance", Group::Light4, &Parameters::light4Kind),
    detail::lightIntensityRow(&Parameters::light4Intensity, "light4Intensity", Group::Light4, &Parameters::light4Kind),
    detail::lightColorRow(&Parameters::light4Color, "light4Color", Group::Light4, &Parameters::light4Kind),
    detail::lightConeRow(&Parameters::light4Cone, "light4Cone", Group::Light4, &Parameters::light4Kind),
    detail::lightSoftnessRow(&Parameters::light4Softness, "light4Softness", Group::Light4, &Parameters::light4Kind),
    detail::lightShadowsRow(&Parameters::light4Shadows, "light4Shadows", Group::Light4, &Parameters::light4Kind),
    detail::lightSizeRow(&Parameters::light4Size, "light4Size", Group::Light4, &Parameters::light4Shadows),

    {.member = &Parameters::exposure,
        .key = "exposure",
        .label = "Exposure",
        .group = Group::Camera,
        .min = -20.f,
        .max = 20.f,
        .unit = "EV",
        .help = "Brightness of the picture in stops; on top of the automatic one, if that is on."},
    {.member = &Parameters::autoExposure,
        .key = "autoExposure",
        .label = "Automatic",
        .group = Group::Camera,
        .help = "Meters the picture: its mean (of the logarithms) becomes middle grey, 18 %."},
    {.member = &Parameters::whiteBalance,
        .key = "whiteBalance",
        .label = "White balance",
        .group = Group::Camera,
        .min = 2000.f,
        .max = 15000.f,
        .unit = "K",
        .help = "Color temperature of the light that shall look white; 6500 leaves all colors, less makes the picture cooler."},
    {.member = &Parameters::toneCurve,
        .key = "toneCurve",
        .label = "Tone curve",
        .group = Group::Camera,
        .max = kLast<ToneCurve>,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Display,
            .files = {"output/tone_neutral.glsl", "output/tone_agx.glsl", "output/tone_aces.glsl", "output/tone_filmic.glsl",
                "output/tone_none.glsl"}},
        .help = "How light brighter than the screen is shown: Khronos neutral keeps colors as they are; AgX, ACES and filmic as film "
                "and other viewers do; none cuts it off."},
    {.member = &Parameters::vignette,
        .key = "vignette",
        .label = "Vignette",
        .group = Group::Camera,
        .affects = {Affects::ProgramText},
        .shader = {.place = ShaderPlace::Display, .files = {"output/vignette_none.glsl", "output/vignette.glsl"}},
        .help = "Darkens the corners; at 1 as a simple lens does, by the fourth power of the cosine of the field angle."},
    {.member = &Parameters::fStop,
        .key = "fStop",
        .label = "Aperture",
        .group = Group::Camera,
        .max = 64.f,
        .unit = "f/",
        .help = "Depth of field as a 35 mm camera with this f-number has it, when the picture rests; 0 keeps all of it sharp."},
    {.member = &Parameters::focusDistance,
        .key = "focusDistance",
        .label = "Focus",
        .group = Group::Camera,
        .max = 10000.f,
        .unit = "m",
        .help = "How far from the eye the picture is sharp; 0: where the camera looks."},
    {.member = &Parameters::bloom,
        .key = "bloom",
        .label = "Glow",
        .group = Group::Camera,
        .affects = {Affects::ProgramText},
        .help = "Share of the light above the threshold that is spread around bright places, as a lens and the eye do; none is added."},
    {.member = &Parameters::bloomThreshold,
        .key = "bloomThreshold",
        .label = "Glow threshold",
        .group = Group::Camera,
        .max = 100.f,
        .unit = "x white",
        .help = "Light up to this stays where it is; 1 is white before the tone curve, with the exposure. 0 spreads all of it, as haze."},
    {.member = &Parameters::bloomSize,
        .key = "bloomSize",
        .label = "Glow size",
        .group = Group::Camera,
        .min = 0.005f,
        .unit = "height",
        .help = "How far the glow reaches, as a share of the picture's height: it looks alike at any resolution."},

    {.member = &Parameters::background,
        .key = "background",
        .label = "Background",
        .group = Group::View,
        .max = kLast<Backdrop>,
        .help = "What is drawn behind the mesh; gradient: a soft grey, lighter behind the middle."},
    {.member = &Parameters::backgroundColor,
        .key = "backgroundColor",
        .label = "Background color",
        .group = Group::View,
        .unit = "linear",
        .shown = {.when = Condition(&Parameters::background, Backdrop::Color)},
        .help = "Color behind the mesh, shown as it is, whatever the exposure."},
    {.member = &Parameters::backgroundBlur,
        .key = "backgroundBlur",
        .label = "Background blur",
        .group = Group::View,
        .shown = {.when = Condition(&Parameters::background, Backdrop::Environment)},
        .help = "How far the surroundings behind the mesh are out of focus: as a surface of this roughness would mirror them; 0 is sharp."},
    {.member = &Parameters::ground,
        .key = "ground",
        .label = "Ground",
        .group = Group::View,
        .help
        = "A floor under the mesh that takes its shadow and fades into the background; alone on a transparent background, the shadow."},
    {.member = &Parameters::groundReflection,
        .key = "groundReflection",
        .label = "Ground reflection",
        .group = Group::View,
        .shown = {.when = Condition(&Parameters::ground, true)},
        .help = "How much the floor mirrors the mesh."},
    {.member = &Parameters::wireframe,
        .key = "wireframe",
        .label = "Wireframe",
        .group = Group::View,
        .help = "Draws the edges of the triangles over the picture."},
    {.member = &Parameters::fetchRange,
        .key = "fetchRange",
        .label = "Fetches shown up to",
        .group = Group::View,
        .min = 1.f,
        .max = 1024.f,
        .unit = "fetches",
        .sharedByPanes = true,
        .help = "Texture fetches at the bright end of the fetches view."},
    {.member = &Parameters::errorRange,
        .key = "errorRange",
        .label = "Error shown up to",
        .group = Group::View,
        .min = 0.0001f,
        .unit = "depth",
        .sharedByPanes = true,
        .help = "Depth error at the bright end of the views Error and Overshoot, as a share of the depth."},
    {.member = &Parameters::pixelRange,
        .key = "pixelRange",
        .label = "Shift shown up to",
        .group = Group::View,
        .min = 0.01f,
        .max = 256.f,
        .unit = "px",
        .sharedByPanes = true,
        .help = "Shift of the texture at the bright end of the views of errors in texels and in pixels."},
});

const ParameterRow* findParameter(std::string_view key); // nullptr when unknown

// What a row's value is.
enum class ValueKind { Number, Whole, Switch, Color, Choice };
constexpr std::string_view wordOf(ValueKind kind)
{
    switch (kind) {
    case ValueKind::Number:
        return "number";
    case ValueKind::Whole:
        return "whole";
    case ValueKind::Switch:
        return "switch";
    case ValueKind::Color:
        return "color";
    case ValueKind::Choice:
        return "choice";
    }
    return {};
}
constexpr ValueKind kindOf(const ParameterRow& row)
{
    return ValueKind(std::min(row.member.index(), std::size_t(ValueKind::Choice)));
}

// Of a choice row: how many there are to choose from, and their words; 0 and "" for any other.
constexpr int optionCount(const ParameterRow& row)
{
    return std::visit(
        [](auto member) {
            if constexpr (IsChoice<MemberType<decltype(member)>>)
                return int(kChoices<MemberType<decltype(member)>>);
            else
                return 0;
        },
        row.member);
}
constexpr std::string_view option(const ParameterRow& row, int index) // "" outside
{
    return std::visit(
        [index](auto member) {
            if constexpr (IsChoice<MemberType<decltype(member)>>)
                return wordOf(MemberType<decltype(member)>(index));
            else
                return std::string_view();
        },
        row.member);
}
// How many shader files a row chooses among: one for each option, or off and on.
constexpr std::size_t variantCount(const ParameterRow& row)
{
    return kindOf(row) == ValueKind::Choice ? std::size_t(optionCount(row)) : 2;
}
std::optional<int> findOption(const ParameterRow& row, std::string_view word);
std::string optionList(const ParameterRow& row, char separator); // "repeat clamp"

// One parameter's value, whatever its kind; that of a choice is the number of its option. Comparable, so that overrides and undo can be.
using Value = std::variant<float, int, bool, glm::vec3>;
bool isOfKind(const ParameterRow& row, const Value& value);
Value get(const Parameters& parameters, const ParameterRow& row);
void set(Parameters& parameters, const ParameterRow& row, const Value& value); // the kinds must agree (asserted)
bool inRange(const ParameterRow& row, const Value& value);
std::size_t variantOf(const ParameterRow& row, const Value& value); // which of the row's shader files the value chooses
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
        if (kindOf(row) == ValueKind::Choice && (row.min != 0.f || row.max != float(optionCount(row) - 1)))
            return false;
        std::size_t files = 0;
        for (const std::string_view& file : row.shader.files)
            files += file.empty() ? 0 : 1;
        if (files != 0 && (files != variantCount(row) || !row.affects.contains(Affects::ProgramText)))
            return false;
    }
    return true;
}
} // namespace detail
static_assert(detail::arity<Parameters>() == kParameters.size(), "each member of Parameters wants exactly one row in kParameters");
static_assert(detail::rowsAreSound(),
    "a key or member twice, a default outside its range, a row without label or help, or not one shader file for each option");

// The place of a member's row in the table.
constexpr std::size_t indexOf(const Member& member)
{
    std::size_t index = 0;
    while (kParameters[index].member != member)
        ++index;
    return index;
}

// Some of the parameters.
class ParameterSet {
public:
    constexpr ParameterSet() = default;
    constexpr ParameterSet(std::initializer_list<Member> members)
    {
        for (const Member& member : members)
            m_holds[indexOf(member)] = true;
    }
    constexpr bool contains(const ParameterRow& row) const { return m_holds[std::size_t(&row - kParameters.data())]; }
    constexpr bool contains(const Member& member) const { return m_holds[indexOf(member)]; }

private:
    std::array<bool, kParameters.size()> m_holds{};
};
std::string keysOf(const ParameterSet& set); // in the order of the table, separated by spaces

// The parameters that affect `what`; the others by default. For comparing what something was made for.
Parameters onlyAffecting(Affects what, const Parameters& parameters);

} // namespace relievo
