// Putting shader programs together from files and generated functions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/program_text.h"
#include "core/image/material.h"
#include "core/maps/maps.h"
#include "core/shader_text/assembly.h"
#include "core/shader_text/search_files.h"
#include "core/state/lights.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <cmath>

namespace relievo {

namespace {

// Of an engine's pictures, where several maps lie in one.
struct PackedMap {
    MapKind kind;
    std::string_view map, channel;
};
constexpr std::array<PackedMap, 4> kPackedMaps = {{{MapKind::AmbientOcclusion, "ormMap", ".r"}, {MapKind::Roughness, "ormMap", ".g"},
    {MapKind::Metallic, "ormMap", ".b"}, {MapKind::Opacity, "colorMap", ".a"}}};

// "vec3 colorAt(vec2 uv, float footprint)": the map at an explicit mip level, or a constant.
std::string mapFunction(const MapKindRow& row, bool present, bool gloss, bool packed)
{
    const bool scalar = row.channels == 1;
    const auto in = std::ranges::find(kPackedMaps, row.kind, &PackedMap::kind);
    if (packed && present && in != kPackedMaps.end())
        return "float " + std::string(row.key) + "At(vec2 uv, float footprint) { return textureLod(" + std::string(in->map)
            + ", uv, mapLevel(footprint + " + std::string(in->map) + "Levels))" + std::string(in->channel) + "; }\n";
    const std::string map = gloss ? "glossMap" : std::string(row.key) + "Map";
    std::string text = std::string(scalar ? "float " : "vec3 ") + std::string(row.key) + "At(vec2 uv, float footprint) { return ";
    if (!present)
        return text + std::string(row.withoutMap) + "; }\n";
    const std::string fetch = "textureLod(" + map + ", uv, mapLevel(footprint + " + map + "Levels))" + (scalar ? ".r" : ".rgb");
    return text + (gloss ? "1.0f - " + fetch : fetch) + "; }\n";
}

std::string mapFunctions(EnumSet<MapKind> maps, std::string_view text, bool packed)
{
    std::string functions;
    for (const MapKindRow& row : kMapKinds) {
        const bool gloss = row.kind == MapKind::Roughness && !maps.contains(MapKind::Roughness) && maps.contains(MapKind::Gloss);
        if (row.kind != MapKind::Height && mentionsIdentifier(text, std::string(row.key) + "At"))
            functions += mapFunction(row, gloss || maps.contains(row.kind), gloss, packed);
    }
    return functions;
}

// The same of the pictures of a relief object's sides: seenSide is the one that is looked at, front and back of each axis in turn.
std::string objectMapFunctions(std::string_view text)
{
    const auto fetch = [](std::string_view function, std::string_view map, std::string_view channels) {
        return std::string(function) + "At(vec2 uv, float footprint) { return textureLod(" + std::string(map)
            + ", vec3(uv, float(seenSide)), mapLevel(footprint + objectMapLevels))" + std::string(channels) + "; }\n";
    };
    std::string functions = "int seenSide = 0;\n" + fetch("vec3 color", "objectColorMap", ".rgb")
        + fetch("vec3 normal", "objectNormalMap", ".rgb") + fetch("float roughness", "objectNormalMap", ".a");
    for (const MapKindRow& row : kMapKinds)
        if (const std::string name = std::string(row.key) + "At";
            row.kind != MapKind::Height && mentionsIdentifier(text, name) && functions.find(name) == functions.npos)
            functions += mapFunction(row, false, false, false);
    return functions;
}

std::string_view normalsFile(EnumSet<MapKind> maps)
{
    return maps.contains(MapKind::Normal) ? "surface/normals_from_map.glsl"
        : maps.contains(MapKind::Height)  ? "surface/normals_from_height.glsl"
                                          : "surface/normals_none.glsl";
}

// The files that parameters choose, of those that stand in one place.
void variantFiles(Assembly& part, const ProgramFeatures& features, ShaderPlace place)
{
    for (std::size_t i = 0; i < kParameters.size(); ++i)
        if (const ShaderChoice& shader = kParameters[i].shader; shader.place == place && !shader.files.front().empty())
            part.file(shader.files[features.variants[i]]);
}

bool isThesis(const ProgramFeatures& features)
{
    return features.variant(&Parameters::shading) == std::size_t(Shading::Thesis);
}

// What lies over the shading model: nothing, or all layers, of which those that are off do nothing.
void layerFiles(Assembly& part, const ProgramFeatures& features)
{
    const bool any = std::ranges::any_of(
        kParameters, [&](const ParameterRow& row) { return row.shader.place == ShaderPlace::Layer && features.variant(row.member) != 0; });
    if (any)
        variantFiles(part, features, ShaderPlace::Layer);
    part.file(any ? "layers/layers.glsl" : "layers/layers_none.glsl");
}

// From light to the screen: toDisplay() and throughLens().
Assembly& displayFiles(Assembly& part, const ProgramFeatures& features)
{
    variantFiles(part, features, ShaderPlace::Display);
    return part.file("output/display.glsl");
}

// The technique and what it reads the maps by, for pictures.
void searchFiles(Assembly& part, const TechniqueRow& technique, const ViewRow& view, const ProgramFeatures& features)
{
    if (technique.isOfObjects) {
        part.file("object/object_texels_buffer.glsl").file(technique.file);
        return;
    }
    if (features.exported && features.dialect == Dialect::Es) {
        part.file("heights/heights_none.glsl");
        return exactFiles(part, technique, features.planes ? kPlanes : kExactEs,
            features.clamps ? "heights/edges_clamp.glsl" : "heights/edges_repeat.glsl", "search/bend_none.glsl");
    }
    const bool filtered = technique.needsHeights() && (!technique.isExact || features.coarser); // else no level is chosen by pixel
    part.file(!filtered ? "heights/heights_none.glsl" : features.exported ? "heights/heights_plain.glsl" : "heights/heights_filtered.glsl");
    if (technique.isExact || (view.isAgainstExact && !features.onMesh)) {
        if (!filtered)
            part.file("heights/level_base.glsl");
        part.file(features.clamps ? "heights/edges_clamp.glsl" : "heights/edges_repeat.glsl")
            .file("heights/wrapped_texel.glsl")
            .file(features.coarser ? "heights/heights_corners_texels.glsl" : "heights/heights_corners.glsl");
    }
    accelerationFiles(part, technique, kFiltered);
    if (filtered)
        part.file("search/height_on.glsl");
    part.file(technique.file);
}

// How a pixel's ray goes, and which pixels are cut out.
void viewRayFiles(Assembly& part, const TechniqueRow& technique, const ViewRow& view, const ProgramFeatures& features)
{
    const bool isCompared = view.isAgainstExact && !features.onMesh && !technique.isOfObjects;
    if (isCompared)
        part.file("search/exact_walk.glsl");
    if (features.prisms)
        part.file(isCompared ? "view_ray/search_either.glsl" : "view_ray/search_own.glsl").file("view_ray/view_ray_prisms.glsl");
    else if (technique.isOfObjects)
        part.file("object/object_surface.glsl");
    else if (features.curved)
        part.file(features.borders ? "view_ray/borders_cut.glsl" : "view_ray/borders_none.glsl").file("view_ray/view_ray_curved.glsl");
    else
        part.file("view_ray/view_ray_straight.glsl");
    if (isCompared)
        part.file(features.prisms ? "exact/exact_prisms.glsl" : "exact/exact_ray.glsl");
    const bool seesThrough = view.light == ViewLight::All && isThesis(features);
    part.file(view.showsHoles ? "view_ray/holes_shown.glsl"
            : isCompared      ? "view_ray/holes_exact.glsl"
            : seesThrough     ? "view_ray/holes_outline.glsl"
                              : "view_ray/holes_cut.glsl");
}

// What hides the light.
void shadowFiles(Assembly& part, const TechniqueRow& technique, const ProgramFeatures& features)
{
    const bool several = features.severalLights, searches = technique.hasShadowsAndOutlines() && features.shadows;
    if (several)
        part.file("shading/light_table.glsl");
    if (searches && features.horizonShadows) {
        part.file("horizon/shadow_above.glsl").file(several ? "horizon/several_horizon.glsl" : "horizon/shadow_horizon.glsl");
    } else if (searches) {
        if (technique.isOfObjects)
            part.file("object/object_shadow.glsl");
        else
            part.file(technique.isExact ? "shadow/shadow_end_exact.glsl" : "shadow/shadow_end_bias.glsl")
                .file(features.prisms ? "shadow/shadow_prisms.glsl" : "shadow/shadow_search.glsl");
        if (features.softShadows)
            part.file(several ? "shadow/several_soft.glsl" : "shadow/shadow_soft.glsl");
        else
            part.file(several ? "shadow/several_hard.glsl" : "shadow/shadow_hard.glsl");
    } else {
        part.file(several ? "shadow/several_none.glsl" : "shadow/shadow_none.glsl");
    }
    part.file(features.objectShadows ? "shadow/shadow_map.glsl" : "shadow/shadow_map_none.glsl");
    if (several)
        part.file("shadow/shadow_several.glsl");
}

// writeView(): the view's value or colour, as the target wants it.
void writeViewFiles(Assembly& part, const ViewRow& view, const ProgramFeatures& features)
{
    if (features.glows)
        part.file("glow/light.glsl");
    if (view.isHeat)
        part.file("output/heat.glsl")
            .generated(features.linear
                    ? "vec3 writeView(Surface s) { return vec3(viewValue(s)); }"
                    : "vec3 writeView(Surface s) { float v = viewValue(s); return v < 0.0f ? kNoHeat : heat(v * heatScale); }");
    else if (view.isColor && !features.linear)
        displayFiles(part, features)
            .generated(features.glows
                    ? "vec3 writeView(Surface s) { vec3 c = throughLens(viewColor(s), -s.toEye); keepLight(c); return toDisplay(c); }"
                    : "vec3 writeView(Surface s) { return toDisplay(throughLens(viewColor(s), -s.toEye)); }");
    else
        part.generated(features.glows ? "vec3 writeView(Surface s) { vec3 c = viewColor(s); keepLight(c); return c; }"
                                      : "vec3 writeView(Surface s) { return viewColor(s); }");
}

Expected<ShaderText> meshFragment(const ProgramFeatures& features, const ShaderReader& read)
{
    const TechniqueRow* technique = findTechnique(features.technique);
    const ViewRow* view = findView(features.view);
    if (!technique || technique->file.empty() || !view)
        return failure(ErrorCode::NotFound, features.technique + ", " + features.view,
            technique && view ? "this technique runs on given rays only" : "there is no such technique or view",
            technique && view ? "Use it in relievo trace" : "relievo describe lists them");

    // First the shading texts alone, to know which maps they read; the functions must stand before their use.
    const auto body = [&](Assembly& part) {
        if (!technique->readsNormals)
            part.file("surface/normals_none.glsl");
        else if (!technique->isOfObjects)
            part.file(normalsFile(features.maps));
        shadowFiles(part, *technique, features);
        if (view->light == ViewLight::All) {
            part.file(features.exported && !features.panorama ? "shading/ambient.glsl" : "shading/environment.glsl");
            variantFiles(part, features, ShaderPlace::Light);
            if (!isThesis(features))
                part.file("shading/own_light.glsl");
            layerFiles(part, features);
            part.file(features.severalLights ? "lights/lights_several.glsl" : "lights/lights_one.glsl").file("lights/shade.glsl");
        }
        const bool several = features.severalLights && !view->fileOfSeveral.empty();
        if (technique->isOfObjects && view->isAgainstExact)
            part.file(features.onMesh ? "object/object_error.glsl" : "object/object_unknown.glsl");
        else
            part.file(several ? view->fileOfSeveral : features.onMesh && !view->fileOnMesh.empty() ? view->fileOnMesh : view->file);
    };
    Assembly draft(read, features.dialect);
    draft.file("view_ray/holes_cut.glsl");
    body(draft);
    const auto drafted = draft.finish();
    if (!drafted)
        return drafted;

    Assembly part(read, features.dialect, features.exported);
    if (features.exported)
        part.generated(kTechniqueBegins);
    part.file("search/contract.glsl").file(features.curved ? "search/bend_quadric.glsl" : "search/bend_none.glsl");
    searchFiles(part, *technique, *view, features);
    if (features.exported)
        part.generated(kTechniqueEnds);
    part.file("surface/surface.glsl");
    if (technique->isOfObjects) // what the others choose is the mesh's
        part.file(kParameters[indexOf(&Parameters::mipMapping)].shader.files[features.variant(&Parameters::mipMapping)])
            .generated(objectMapFunctions(drafted->text));
    else
        variantFiles(part, features, ShaderPlace::Surface);
    if (!technique->isOfObjects)
        part.generated(mapFunctions(features.maps, drafted->text, features.planes));
    const long hundredths = std::lround(100.f * technique->meshDepth()); // as whole numbers, which no locale writes otherwise
    part.generated("const float meshDepth = " + std::to_string(hundredths) + ".0f / 100.0f;\n");
    viewRayFiles(part, *technique, *view, features);
    body(part);
    writeViewFiles(part, *view, features);
    return part.file(technique->isOfObjects ? "object/object_main.glsl" : "output/main.glsl").finish();
}

Expected<ShaderText> meshVertex(const ProgramFeatures& features, const ShaderReader& read)
{
    if (features.exported)
        return Assembly(read, features.dialect, true).file("vertex/plain_vertex.glsl").finish();
    const bool posed = features.posed, curved = features.curved && !features.prisms;
    return Assembly(read)
        .file(posed ? "vertex/place_posed.glsl" : "vertex/place_rest.glsl")
        .file(curved ? "vertex/curved_quadric.glsl" : "vertex/curved_none.glsl")
        .file("vertex/mesh_vertex.glsl")
        .finish();
}

Expected<ProgramText> program(Expected<ShaderText> vertex, Expected<ShaderText> fragment)
{
    if (!vertex)
        return tl::unexpected(vertex.error());
    if (!fragment)
        return tl::unexpected(fragment.error());
    return ProgramText{std::move(*vertex), std::move(*fragment)};
}

} // namespace

EnumSet<MapKind> presentMaps(const Material& material)
{
    EnumSet<MapKind> maps;
    if (material.height)
        maps.insert(MapKind::Height);
    for (const MapKindRow& row : kMapKinds)
        if (material.map(row.kind))
            maps.insert(row.kind);
    return maps;
}

namespace {
bool isChosen(ShaderPlace place, const Parameters& parameters, const ViewRow& view, bool linear)
{
    switch (place) {
    case ShaderPlace::Surface:
        return true;
    case ShaderPlace::Light:
        return view.light == ViewLight::All;
    case ShaderPlace::Layer:
        return view.light == ViewLight::All && parameters.shading == Shading::MetallicRoughness;
    case ShaderPlace::Display:
        return view.light == ViewLight::All && view.isColor && !linear;
    }
    return false;
}
} // namespace

ProgramFeatures programFeatures(
    const Parameters& parameters, const TechniqueRow& technique, const ViewRow& view, EnumSet<MapKind> maps, bool linear)
{
    const bool shadowed = view.light != ViewLight::None;
    const auto anyLight
        = [&](auto has) { return std::ranges::any_of(kLights, [&](auto& one) { return isLit(parameters, one) && has(one); }); };
    const auto isSoft = [&](const LightMembers& light) { return parameters.*light.shadows && parameters.*light.size > 0.f; };
    const bool selfShadows = shadowed && hasSelfShadows(technique, parameters);
    const bool curved = parameters.silhouettes != Silhouettes::Off && technique.hasSilhouettes();
    ProgramFeatures features{.technique = std::string(technique.key),
        .view = std::string(view.key),
        .maps = maps,
        .shadows = selfShadows,
        .softShadows = selfShadows && anyLight(isSoft),
        .horizonShadows = shadowed && hasHorizonShadows(technique, parameters),
        .severalLights = shadowed && !isOneDirectional(parameters),
        .linear = linear,
        .glows = parameters.bloom > 0.f && view.light == ViewLight::All && view.isColor,
        .coarser = technique.isExact && parameters.heightMips,
        .curved = curved,
        .prisms = curved && parameters.silhouettes == Silhouettes::Prisms,
        .objectShadows = parameters.objectShadows && shadowed && parameters.lightKind == LightKind::Directional,
        .clamps = (technique.isExact || view.isAgainstExact) && parameters.wrap == Wrap::Clamp};
    for (const ParameterRow& row : kParameters)
        if (!row.shader.files.front().empty() && isChosen(row.shader.place, parameters, view, linear))
            features.setVariant(row.member, variantOf(row, get(parameters, row)));
    if (!technique.displaces)
        features.setVariant(&Parameters::depthOfHit, 0);
    if (technique.isOfObjects) { // what is chosen of the mesh's surface
        features.setVariant(&Parameters::frames, 0), features.setVariant(&Parameters::edgeFade, 0);
        features.coarser = features.clamps = false;
        features.maps = {};
    }
    if (!maps.contains(MapKind::Normal))
        features.setVariant(&Parameters::normalFiltering, 0);
    if (!maps.contains(MapKind::Height) || !hasAmbientRelief(technique, parameters))
        features.setVariant(&Parameters::ambientRelief, 0), features.setVariant(&Parameters::specularOcclusion, 0);
    return features;
}

ProgramFeatures exportedFeatures(const Parameters& parameters, const TechniqueRow& technique, EnumSet<MapKind> maps, Dialect dialect)
{
    Parameters plain = withOneDirectional(parameters);
    plain.silhouettes = Silhouettes::Off;
    plain.objectShadows = false;
    plain.shadowSearch = ShadowSearch::Searched;
    plain.ambientRelief = AmbientRelief::Off;
    plain.heightMips = false;
    plain.vignette = plain.bloom = 0.f;
    plain.frames = Frames::Derivatives;
    ProgramFeatures features = programFeatures(plain, technique, knownView("shaded"), maps, false);
    features.exported = true;
    features.dialect = dialect;
    features.clamps = parameters.wrap == Wrap::Clamp;
    return features;
}

ProgramFeatures exportedForLoaders(const Parameters& parameters, const TechniqueRow& technique, EnumSet<MapKind> maps)
{
    EnumSet<MapKind> packed;
    for (const MapKindRow& row : kMapKinds)
        if (maps.contains(row.kind) && row.kind != MapKind::Specular && row.kind != MapKind::Optics) // which engines' materials do not have
            packed.insert(row.kind);
    ProgramFeatures features = exportedFeatures(parameters, technique, packed, Dialect::Es);
    features.planes = true;
    features.setVariant(&Parameters::depthOfHit, 0);
    return features;
}

Expected<ProgramText> meshProgram(const ProgramFeatures& features, const ShaderReader& read)
{
    return program(meshVertex(features, read), meshFragment(features, read));
}

namespace {
Expected<void> checkFitsPictures(const TechniqueRow& technique, const std::string& engine)
{
    const bool isVolume = !technique.accelerationMap.empty() && findBakedMap(technique.accelerationMap)->form == MapForm::Volume;
    if (technique.file.empty() || isVolume)
        return failure(std::string(technique.key), "this technique cannot run in " + engine + ": it has no shader, or reads a volume",
            "Choose another one, such as cell-cone");
    return {};
}
} // namespace

Expected<std::string> searchForUnreal(const TechniqueRow& technique, bool clamps, const ShaderReader& read)
{
    if (auto fits = checkFitsPictures(technique, "Unreal"); !fits)
        return tl::unexpected(fits.error());
    Assembly part(read, Dialect::Desktop, true);
    part.file("search/contract.glsl")
        .file("search/bend_none.glsl")
        .file("heights/level_base.glsl")
        .file(clamps ? "heights/edges_clamp.glsl" : "heights/edges_repeat.glsl")
        .file("heights/wrapped_texel.glsl");
    if (technique.isExact)
        part.file("heights/heights_corners_texels.glsl");
    else if (technique.needsHeights())
        part.file("heights/heights_plain.glsl").file("search/height_on.glsl");
    accelerationFiles(part, technique, kPlanes);
    part.file(technique.file)
        .generated(
            "in vec4 givenWay;\nin float givenCosine;\nlayout(location = 0) out vec4 foundPlace;\n"
            "void main() { Hit hit = trace(Ray(givenWay.xy, givenWay.zw, givenCosine, 1.0f)); foundPlace = vec4(hit.uv, hit.t, 1.0f); }");
    return part.finish().map([](const ShaderText& whole) { return whole.text; });
}

Expected<std::string> searchForGodot(const TechniqueRow& technique, bool clamps, const ShaderReader& read)
{
    if (auto fits = checkFitsPictures(technique, "Godot"); !fits)
        return tl::unexpected(fits.error());
    Assembly part(read, Dialect::Desktop, true);
    part.file("search/contract.glsl").file("search/bend_none.glsl");
    if (technique.isExact)
        part.file("heights/level_base.glsl")
            .file(clamps ? "heights/edges_clamp.glsl" : "heights/edges_repeat.glsl")
            .file("heights/wrapped_texel.glsl")
            .file(kGodot.corners);
    else if (technique.needsHeights())
        part.file("heights/heights_plain.glsl").file("search/height_on.glsl");
    accelerationFiles(part, technique, kGodot);
    return part.file(technique.file).body();
}

Expected<ProgramText> backgroundProgram(Backdrop behind, const ProgramFeatures& features, const ShaderReader& read)
{
    Assembly fragment(read, features.dialect);
    if (behind != Backdrop::Gradient)
        fragment.file("shading/environment.glsl");
    if (!features.linear)
        displayFiles(fragment, features);
    const bool keeps = features.glows && behind != Backdrop::Gradient;
    if (keeps)
        fragment.file("glow/light.glsl");
    const std::string kept = keeps ? "keepLight(c); " : "";
    if (behind == Backdrop::Gradient) // as the screen shows it, whatever the exposure
        fragment
            .generated(features.linear ? "vec3 shownColor(vec3 color) { return color; }"
                                       : "vec3 shownColor(vec3 color) { return encodeSrgb(color); }")
            .file("output/gradient.glsl");
    else
        fragment
            .generated(features.linear ? "vec3 shownColor(vec3 c, vec3 fromEye) { " + kept + "return c; }"
                                       : "vec3 shownColor(vec3 color, vec3 fromEye) { vec3 c = throughLens(color, fromEye); " + kept
                        + "return toDisplay(c); }")
            .file("output/background.glsl");
    return program(Assembly(read, features.dialect).file("vertex/background_vertex.glsl").finish(), fragment.finish());
}

Expected<ProgramText> groundProgram(bool linear, const ShaderReader& read)
{
    constexpr std::string_view kPlace = "uniform vec4 groundPlace[2];\n";
    Assembly fragment(read);
    fragment.generated(kPlace)
        .generated(linear ? "float shownShare(float share) { return share; }"
                          : "float shownShare(float share) { return pow(share, 1.0f / 2.2f); }")
        .file("shading/environment.glsl");
    return program(
        Assembly(read).generated(kPlace).file("vertex/ground_vertex.glsl").finish(), fragment.file("output/ground.glsl").finish());
}

Expected<ProgramText> wireframeProgram(bool posed, const ShaderReader& read)
{
    ProgramFeatures features;
    features.posed = posed;
    return program(meshVertex(features, read), Assembly(read).file("output/wireframe.glsl").finish());
}

Expected<ProgramText> composeProgram(const ShaderReader& read)
{
    Assembly fragment(read);
    fragment.generated("uniform sampler2D firstPicture;\nuniform sampler2D secondPicture;\nuniform vec4 composition[4];");
    return program(Assembly(read).file("vertex/full_screen_vertex.glsl").finish(), fragment.file("output/compose.glsl").finish());
}

Expected<ProgramText> glowProgram(GlowStep step, const ProgramFeatures& features, const ShaderReader& read)
{
    Assembly fragment(read);
    fragment.generated("uniform sampler2D glowPicture;\nuniform sampler2D lightPicture;\nuniform sampler2D shownPicture;\n"
                       "uniform vec4 glowPlace;");
    if (step == GlowStep::Glowing && !features.linear)
        displayFiles(fragment, features);
    if (step == GlowStep::Glowing)
        fragment.file(features.linear ? "glow/added_linear.glsl" : "glow/added_display.glsl");
    constexpr std::array<std::string_view, 3> kFiles = {"glow/excess_picture.glsl", "glow/resized.glsl", "glow/glowing.glsl"};
    return program(Assembly(read).file("vertex/full_screen_vertex.glsl").finish(), fragment.file(kFiles[std::size_t(step)]).finish());
}

namespace {
// A technique and what it reads the maps by, for rays that are given.
Expected<ProgramText> programForRays(std::string_view technique, const ShaderReader& read, Dialect dialect, bool onPrisms)
{
    const TechniqueRow* row = findTechnique(technique);
    if (!row || row->file.empty() || row->isOfObjects)
        return failure(std::string(technique), "this technique does not run on the GPU", "Use --device cpu");
    Assembly fragment(read, dialect);
    fragment.file("search/contract.glsl");
    exactFiles(fragment, *row, dialect == Dialect::Es ? kExactEs : kExact, "heights/edges_either.glsl",
        onPrisms ? "search/bend_quadric.glsl" : "search/bend_none.glsl");
    if (onPrisms)
        fragment.file("view_ray/search_own.glsl")
            .file(dialect == Dialect::Desktop ? "view_ray/prism_texels_buffer.glsl" : "view_ray/prism_texels_image.glsl")
            .file("view_ray/prisms.glsl")
            .file(row->isExact ? "shadow/shadow_end_exact.glsl" : "shadow/shadow_end_bias.glsl")
            .file("shadow/prism_light.glsl")
            .file("view_ray/trace_prisms.glsl");
    else
        fragment.file("search/trace_rays.glsl");
    return program(Assembly(read, dialect).file("vertex/full_screen_vertex.glsl").finish(), fragment.finish());
}
} // namespace

Expected<ProgramText> traceProgram(std::string_view technique, const ShaderReader& read, Dialect dialect)
{
    return programForRays(technique, read, dialect, false);
}

Expected<ProgramText> prismProgram(std::string_view technique, const ShaderReader& read, Dialect dialect)
{
    return programForRays(technique, read, dialect, true);
}

} // namespace relievo
