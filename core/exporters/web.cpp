// Export target "web": a page that draws the material by WebGL2 with two techniques, all in one file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/embedded_targets.h"
#include "core/exporters/map_images.h"
#include "core/exporters/new_files.h"
#include "core/exporters/uniform_values.h"
#include "core/exporters/web_data.h"
#include "core/ground/file.h"
#include "core/ground/srgb.h"
#include "core/mesh/animation/pose.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include <cmath>

namespace relievo {
namespace {

constexpr double kMegabyte = 1e6;
constexpr std::size_t kWellBehaved = 4'000'000; // bytes that a page may have before it is told
constexpr std::size_t kManyTriangles = 200'000;
constexpr std::string_view kDataGoesHere = "{{data}}", kTitleGoesHere = "{{title}}"; // in web.html

// One of the two pictures that the page wipes between.
struct Side {
    const TechniqueRow& technique;
    Parameters parameters;
};

// Picture A, and picture B; where there is none, the exact search, or what it is worth comparing with.
Expected<std::vector<Side>> sidesOf(const ExportJob& job)
{
    const State& state = job.state;
    const bool hasHeights = job.resources.material->height.has_value();
    const auto runs = [&](const TechniqueRow* row) { return row && !row->file.empty() && (hasHeights || !row->needsHeights()); };
    const TechniqueRow* a = findTechnique(techniqueOf(job));
    if (!runs(a))
        return failure(techniqueOf(job), "a page cannot draw this material by this technique",
            hasHeights ? "Choose one that draws pictures, such as cell-cone" : "Open a height map, or choose bump");
    std::vector<Side> sides = {{*a, effectiveParameters(state, 0)}};
    if (const TechniqueRow* b = state.panes.size() > 1 ? findTechnique(state.panes[1].technique) : nullptr; runs(b)) {
        sides.push_back({*b, effectiveParameters(state, 1)});
        return sides;
    }
    const TechniqueRow& exact = knownTechnique("cell-cone");
    const TechniqueRow& other = !hasHeights ? (a == &knownTechnique("flat") ? knownTechnique("bump") : knownTechnique("flat"))
        : a == &exact                       ? knownTechnique("relief")
                                            : exact;
    sides.push_back({other, sides.front().parameters});
    return sides;
}

// Programs, uniforms, and the map that the technique searches by. `shown`: the maps that are not left out.
Expected<WebJson> sideJson(const ExportJob& job, const Side& side, const std::optional<HeightField>& field, EnumSet<MapKind> shown)
{
    ProgramFeatures features = exportedFeatures(side.parameters, side.technique, shown, Dialect::Es);
    features.panorama = true;
    const Expected<ProgramText> program = meshProgram(features, embeddedReader());
    if (!program)
        return tl::unexpected(program.error());
    WebJson json = {{"label", side.technique.label}, {"vertex", program->vertex.text}, {"fragment", program->fragment.text},
        {"uniforms", uniformValues(side.parameters, side.technique, job)},
        {"covers", features.variant(&Parameters::depthOfHit) != 0 && !shown.contains(MapKind::Opacity)}};
    if (side.technique.accelerationMap.empty() || !field)
        return json;
    const auto map
        = makeAccelerationMap(side.technique.accelerationMap, field->withWrap(side.parameters.wrap), side.parameters, false, job.progress);
    if (!map)
        return tl::unexpected(map.error());
    Expected<WebJson> bound = webBound(job, **map);
    if (!bound)
        return bound;
    json["uniforms"]["boundScales[0]"] = jsonOf((*map)->scales.front());
    json["bound"] = std::move(*bound);
    return json;
}

Expected<WebJson> backgroundJson(const Parameters& parameters, const TechniqueRow& technique)
{
    const Backdrop behind = parameters.background;
    WebJson json = {{"kind", wordOf(behind)}};
    if (const glm::vec3 color = parameters.backgroundColor; behind == Backdrop::Color)
        json["color"] = jsonOf(glm::vec3(srgbOf(color.x), srgbOf(color.y), srgbOf(color.z)));
    if (behind != Backdrop::Environment && behind != Backdrop::Gradient)
        return json;
    const Expected<ProgramText> program
        = backgroundProgram(behind, exportedFeatures(parameters, technique, {}, Dialect::Es), embeddedReader());
    if (!program)
        return tl::unexpected(program.error());
    json["vertex"] = program->vertex.text;
    json["fragment"] = program->fragment.text;
    return json;
}

WebJson cameraJson(const ExportJob& job)
{
    const Camera& camera = cameraOf(job.state, 0);
    const Mesh& mesh = *job.resources.mesh;
    WebJson json = {{"yaw", shortest(camera.yaw)}, {"pitch", shortest(camera.pitch)}, {"fov", shortest(camera.fov)},
        {"fill", shortest(camera.fill)}, {"least", jsonOf(mesh.boundsMin)}, {"most", jsonOf(mesh.boundsMax)}};
    if (camera.distance)
        json["distance"] = shortest(*camera.distance);
    if (camera.target)
        json["target"] = jsonOf(*camera.target);
    return json;
}

// Those that a program of the page reads.
Expected<WebJson> mapsJson(const ExportJob& job, const WebJson& sides, Warnings& warnings)
{
    WebJson maps = WebJson::object();
    for (const MapKindRow& row : kMapKinds) {
        const Image* map = job.resources.material->map(row.kind);
        const auto reads = [&row](const WebJson& side) {
            return mentionsIdentifier(withoutComments(side["fragment"].get_ref<const std::string&>()), std::string(row.key) + "Map");
        };
        if (!map || !std::ranges::any_of(sides, reads))
            continue;
        if (row.isColor && map->type == PixelType::F32 && brightest(*map) > 1.f)
            warnings.push_back({"web-clipped", std::string(row.label) + " is brighter than 1 in places: the page's maps end there."});
        const Averaging averaging = row.isColor ? Averaging::Srgb : row.kind == MapKind::Normal ? Averaging::Normals : Averaging::Plain;
        Expected<WebJson> picture = webPicture(job, eightBit(reduced(*map, job.size, averaging), row.isColor), row.isColor);
        if (!picture)
            return picture;
        maps[std::string(row.key)] = std::move(*picture);
    }
    return maps;
}

void tellLeftOut(const std::vector<Side>& sides, const Mesh& mesh, Warnings& warnings)
{
    const auto any = [&sides](auto has) { return std::ranges::any_of(sides, [&](const Side& side) { return has(side.parameters); }); };
    if (any([](const Parameters& p) { return p.silhouettes != Silhouettes::Off; }))
        warnings.push_back({"web-silhouettes", "The page draws straight rays: silhouettes stay the mesh's."});
    if (any([](const Parameters& p) { return p.objectShadows; }))
        warnings.push_back({"web-object-shadows", "The page draws self-shadows of the relief, none between objects."});
    if (any([](const Parameters& p) { return p.vignette > 0.f || p.fStop > 0.f || p.autoExposure || p.bloom > 0.f; }))
        warnings.push_back({"web-camera", "The page has no vignette, depth of field, automatic exposure or glow."});
    if (any([](const Parameters& p) { return !isOneDirectional(p); }))
        warnings.push_back({"web-lights", std::string(kLightsLeftOut)});
    if (std::ranges::any_of(sides, [](const Side& side) { return readsHorizons(side.technique, side.parameters); }))
        warnings.push_back({"web-horizons", std::string(kHorizonsLeftOut)});
    if (any([](const Parameters& p) { return p.ground; }))
        warnings.push_back({"web-ground", "The page draws no floor under the mesh."});
    if (const std::size_t triangles = mesh.indices.size() / 3; triangles > kManyTriangles)
        warnings.push_back({"web-mesh",
            "The mesh has " + std::to_string(triangles) + " triangles: a page is better served by at most " + std::to_string(kManyTriangles)
                + "."});
}

Expected<WebJson> dataOf(const ExportJob& job, Warnings& warnings)
{
    const Expected<std::vector<Side>> sides = sidesOf(job);
    if (!sides)
        return tl::unexpected(sides.error());
    const Parameters& parameters = sides->front().parameters;
    const std::optional<HeightField>& whole = job.resources.material->height;
    const std::optional<HeightField> field = whole ? std::optional(asLargeAsWritten(*whole, job.size)) : std::nullopt;
    const EnumSet<MapKind> shown = presentMaps(*job.resources.material);
    WebJson programs = WebJson::array();
    for (const Side& side : *sides) {
        Expected<WebJson> json = sideJson(job, side, field, shown);
        if (!json)
            return json;
        programs.push_back(std::move(*json));
        job.progress.at(0.35f * float(programs.size()));
    }
    // Parts without relief, and polygons alone, for their depth.
    Parameters bare = parameters;
    bare.depthOfHit = false;
    bare.edgeFade = 0.f;
    Expected<WebJson> plain = sideJson(job, {knownTechnique("flat"), bare}, std::nullopt, {}), maps = mapsJson(job, programs, warnings),
                      background = backgroundJson(parameters, sides->front().technique);
    for (const Expected<WebJson>* part : {&plain, &maps, &background})
        if (!*part)
            return *part;
    const Mesh mesh = posed(*job.resources.mesh, poseOf(*job.resources.mesh, parameters));
    WebJson data = {{"name", job.state.name}, {"camera", cameraJson(job)},
        {"light", {{"yaw", shortest(turnedYaw(parameters, kLights.front()))}, {"pitch", shortest(parameters.lightPitch)}}},
        {"repeat", parameters.wrap == Wrap::Repeat}, {"background", std::move(*background)}, {"sides", std::move(programs)},
        {"plain", std::move(*plain)}, {"maps", std::move(*maps)}, {"environment", webEnvironment(*job.resources.environment)},
        {"mesh", webMesh(mesh, plainParts(mesh, job.state.part))}};
    if (field) {
        Expected<WebJson> planes = webPlanes(job, heightImage(*field, 16));
        if (!planes)
            return planes;
        data["height"] = std::move(*planes);
    }
    tellLeftOut(*sides, mesh, warnings);
    return data;
}

// In a script's text nothing but "<" could end it.
std::string safeInScript(const std::string& json)
{
    std::string safe;
    for (const char c : json)
        c == '<' ? safe += "\\u003c" : safe += c;
    return safe;
}

std::string safeInHtml(const std::string& text)
{
    std::string safe;
    for (const char c : text)
        c == '<' ? safe += "&lt;" : c == '&' ? safe += "&amp;" : safe += c;
    return safe;
}

std::string pageWith(const WebJson& data, const std::string& title)
{
    std::string page(std::ranges::find(embeddedTargets(), "web.html", &EmbeddedTarget::name)->text);
    const std::string json = data.dump(-1, ' ', false, WebJson::error_handler_t::replace);
    page.replace(page.find(kDataGoesHere), kDataGoesHere.size(), safeInScript(json));
    return page.replace(page.find(kTitleGoesHere), kTitleGoesHere.size(), safeInHtml(title)); // stands first, whatever the data say
}
} // namespace

std::vector<std::filesystem::path> filesOfWeb(const ExportJob& job)
{
    return {job.out};
}

Expected<Exported> exportWeb(const ExportJob& job)
{
    if (Expected<void> free = refuseToOverwriteSources(job, job.out); !free)
        return tl::unexpected(free.error());
    Exported exported{{job.out}, {}};
    const Expected<WebJson> data = dataOf(job, exported.warnings);
    if (!data)
        return tl::unexpected(data.error());
    if (job.progress.cancelled())
        return cancelled(job.out.string());
    const std::string page = pageWith(*data, job.state.name);
    if (page.size() > kWellBehaved) {
        char size[32];
        std::snprintf(size, sizeof size, "%.1f", double(page.size()) / kMegabyte);
        exported.warnings.push_back(
            {"web-large", std::string("The page takes ") + size + " MB. Textures of 512 texels make it smaller: --size 512."});
    }
    NewFiles made;
    if (Expected<void> folder = made.makeFolder(job.out.parent_path()); !folder)
        return tl::unexpected(folder.error());
    if (Expected<void> written = writeAtomically(job.out, page); !written)
        return tl::unexpected(written.error());
    made.keep();
    return exported;
}

} // namespace relievo
