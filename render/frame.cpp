// What a picture is drawn with.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame.h"
#include "core/object/object_file.h"
#include "render/gl/driver_limits.h"
#include "render/gl/texture_units.h"
#include "render/pane_values.h"
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/vector_float2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace relievo {

void DrawContext::forgetUploads()
{
    uploads = Uploads(), mesh = MeshUpload();
    shadowMaps.clear();
}

const LinkedProgram* DrawContext::meshProgramFor(const ProgramFeatures& features, std::optional<Error>& error)
{
    const auto [name, isNew] = programNames.try_emplace(features, "mesh " + std::to_string(programNames.size()));
    return programs.get(
        name->second, [&](const ShaderReader& read) { return meshProgram(features, read); }, error);
}

const LinkedProgram* DrawContext::polygonProgramFor(bool posed, std::optional<Error>& error)
{
    return programs.get(
        posed ? "wireframe/posed" : "wireframe", [&](const ShaderReader& read) { return wireframeProgram(posed, read); }, error);
}

namespace {
constexpr float kHalfSensor = 0.012f; // m, of a 35 mm camera's picture, upwards

// Seen from a point of the lens: what lies in focus stays where it is in the picture.
CameraView throughLens(CameraView camera, const Parameters& parameters, glm::vec2 lens)
{
    const float focalLength = kHalfSensor * camera.clipFromView[1][1],
                focus = parameters.focusDistance > 0.f ? parameters.focusDistance : camera.distance;
    const glm::vec2 off = lens * (0.5f * focalLength / parameters.fStop);
    camera.eye += camera.right * off.x + camera.up * off.y;
    glm::mat4 moved(1.f);
    moved[3] = glm::vec4(-off, 0.f, 1.f);
    moved[2] = glm::vec4(-off / focus, 1.f, 0.f);
    camera.viewFromWorld = moved * camera.viewFromWorld;
    return camera;
}

// The camera of this very picture: shifted by the target's jitter, from a point of the lens, of a tile.
CameraView shotCamera(CameraView camera, const Frame& frame)
{
    const Target& target = frame.request.target();
    if (frame.parameters.fStop > 0.f && target.lens != glm::vec2(0.f) && frame.view.isColor)
        camera = throughLens(camera, frame.parameters, target.lens);
    const glm::vec2 size(std::max(target.width, 1), std::max(target.height, 1));
    if (target.wholeWidth > 0) {
        const glm::vec2 whole(target.wholeWidth, target.wholeHeight), corner(target.left, target.below);
        const glm::mat4 to = glm::translate(glm::mat4(1.f), glm::vec3((whole - 2.f * corner - size) / size, 0.f));
        camera.clipFromView = glm::scale(to, glm::vec3(whole / size, 1.f)) * camera.clipFromView;
    }
    camera.clipFromView = glm::translate(glm::mat4(1.f), glm::vec3(2.f * target.jitter / size, 0.f)) * camera.clipFromView;
    return camera;
}

SceneUniforms uniformsOf(const Frame& frame)
{
    const Target& target = frame.request.target();
    SceneUniforms uniforms
        = sceneUniforms(frame.parameters, shotCamera(frame.request.camera(), frame), frame.request.resources().mesh->metresPerUV);
    uniforms.lookDirection = (frame.request.camera().target - frame.request.camera().eye) / frame.request.camera().distance;
    setLights(uniforms, frame.parameters, around(frame.request.resources().mesh->boundsMin, frame.request.resources().mesh->boundsMax));
    if (const auto& maps = frame.request.resources().mesh->object) {
        const auto& half = maps->object.half;
        const glm::dmat4 worldFromBox(
            glm::dvec4(half[0], 0.), glm::dvec4(half[1], 0.), glm::dvec4(half[2], 0.), glm::dvec4(maps->object.center, 1.));
        uniforms.worldFromBox = worldFromBox;
        uniforms.boxFromWorld = glm::inverse(worldFromBox);
    }
    uniforms.pushOut = frame.technique.displaces ? (1.f - frame.parameters.midlevel) * uniforms.reliefDepth : 0.f;
    uniforms.heatScale = 1.f / heatRange(frame.parameters, frame.view);
    uniforms.sampleTurn = target.jitter.x;
    return uniforms;
}

ProgramFeatures featuresOf(const Frame& frame, EnumSet<MapKind> maps, MeshUpload& mesh)
{
    const DrawRequest& request = frame.request;
    ProgramFeatures features = programFeatures(frame.parameters, frame.technique, frame.view, maps, request.target().linear);
    features.posed = bool(request.resources().mesh->deformation);
    features.onMesh = !frame.view.fileOnMesh.empty() && request.exact();
    features.prisms = features.prisms && mesh.hasPrisms();
    features.borders = features.curved && !features.prisms && mesh.hasBorders();
    return features;
}
} // namespace

Expected<Frame> prepareFrame(DrawContext& context, const DrawRequest& request)
{
    const State& state = request.state();
    const Resources& resources = request.resources();
    const ViewRow* view = findView(request.view());
    const TechniqueRow* technique = request.pane() < state.panes.size() ? findTechnique(state.panes[request.pane()].technique) : nullptr;
    if (!view || !technique)
        return failure(
            ErrorCode::NotFound, std::string(request.view()), "there is no such view or pane", "relievo describe views lists them");
    Frame frame{.request = request,
        .technique = *technique,
        .view = *view,
        .parameters = drawnParameters(state, request.pane(), *technique, *view),
        .acceleration = nullptr,
        .horizons = nullptr};
    const EnumSet<MapKind> maps = presentMaps(*resources.material);
    if (technique->isOfObjects != bool(resources.mesh->object))
        return failure(resources.mesh->name,
            std::string(technique->label)
                + (technique->isOfObjects ? " draws relief objects, and this is a mesh" : " cannot draw a relief object"),
            "Choose another technique");
    if (technique->isOfObjects && view->isAgainstExact && view->fileOnMesh.empty())
        return failure(
            resources.mesh->name, "of relief objects there is no view \"" + std::string(view->label) + "\"", "Choose another view");
    if ((technique->needsHeights() || (view->isAgainstExact && !technique->isOfObjects)) && !maps.contains(MapKind::Height))
        return failure(state.name,
            std::string(technique->label) + (view->isAgainstExact ? "'s error" : "") + " needs a height map and the material has none",
            "Assign one, or choose Flat or Bump");
    auto acceleration = resources.accelerationMaps.of(*technique, frame.parameters, *resources.material);
    if (!acceleration)
        return tl::unexpected(acceleration.error());
    frame.acceleration = std::move(*acceleration);
    auto horizons = resources.accelerationMaps.horizonsOf(*technique, frame.parameters, *resources.material);
    if (!horizons)
        return tl::unexpected(horizons.error());
    frame.horizons = std::move(*horizons);
    if (const auto fits = fitTheDriver(*resources.material, *resources.mesh); !fits)
        return tl::unexpected(fits.error());

    if (context.programs.reload())
        context.shadowMaps.clear();
    std::erase_if(context.shadowMaps, [&](const auto& entry) { return entry.first >= state.panes.size(); });
    context.uploads.show(resources, state.panes.size());
    context.mesh.show(resources.mesh);
    frame.uniforms = uniformsOf(frame);
    frame.features = featuresOf(frame, maps, context.mesh);
    if (frame.features.curved && !frame.features.prisms)
        frame.curvature = frame.parameters.silhouettes;
    frame.fewerTriangles = request.target().isPassing && !frame.features.curved && context.mesh.isFinerThanPixels();
    return frame;
}

void useProgram(DrawContext& context, const Frame& frame, const LinkedProgram& program, const SceneUniforms& uniforms)
{
    program.use();
    program.set(frame.parameters);
    program.set(uniforms);
    context.uploads.bindMaps(program, frame.parameters, frame.acceleration, frame.horizons);
    context.uploads.bindExact(program, frame.request.pane(), frame.request.exact());
    context.mesh.bind(program, frame.parameters, frame.request.state().part, frame.curvature);
    if (program.reads("shadowMap"))
        program.bind("shadowMap", GL_TEXTURE_2D, context.shadowMaps[frame.request.pane()].texture(), kShadowUnit);
}

} // namespace relievo
