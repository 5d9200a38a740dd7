// Drawing a State: choose the program, bind what it reads, draw the mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include "core/trace/displaced_mesh.h"
#include "render/clear_target.h"
#include "render/gl/driver_limits.h"
#include "render/gl/program_cache.h"
#include "render/gl/texture_units.h"
#include "render/pane_values.h"
#include "render/shadow_map.h"
#include "render/uploads/mesh_upload.h"
#include "render/uploads/uploads.h"
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace relievo {
namespace {
// Lines more than a pixel wide are an error in contexts without what is deprecated.
void setLineWidth(float pixels)
{
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    glLineWidth(flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT ? std::min(pixels, 1.f) : pixels);
}
} // namespace

struct Renderer::Impl {
    Uploads uploads;
    MeshUpload mesh;
    std::map<Resources::BoundKey, Resources::Bound> bounds; // made here
    ProgramCache programs;
    std::map<ProgramFeatures, std::string> programNames;
    std::map<std::size_t, ShadowMap> shadowMaps; // by pane
    VertexArray noVertices;
    Framebuffer measuring;
    std::vector<float> pixels;

    const LinkedProgram* meshProgramFor(const ProgramFeatures& features, std::optional<Error>& error)
    {
        const auto [name, isNew] = programNames.try_emplace(features, "mesh " + std::to_string(programNames.size()));
        return programs.get(
            name->second, [&](const ShaderReader& read) { return meshProgram(features, read); }, error);
    }

    const LinkedProgram* polygonProgramFor(bool posed, std::optional<Error>& error)
    {
        return programs.get(
            posed ? "wireframe/posed" : "wireframe", [&](const ShaderReader& read) { return wireframeProgram(posed, read); }, error);
    }

    // The parts with relief by `features`, the plain ones by what is left of them without. First all faces towards the eye: those behind
    // them fail the depth test before they are searched. Where the front is cut off, or writes a depth of its own, the inside must not
    // show: of a closed mesh no other faces are drawn, and of others what lies behind the front's polygons is hidden (not in a shadow map,
    // whose depth is what counts). Without silhouettes, holes of the material show it. use(program, uniforms) makes a program ready.
    template <class Use>
    void drawSurface(const State& state, const ProgramFeatures& features, const Parameters& parameters, const SceneUniforms& uniforms,
        bool intoShadowMap, bool coarse, const Use& use, std::optional<Error>& error)
    {
        const LinkedProgram* ready = nullptr; // for the parts `readyFor`
        MeshUpload::Parts readyFor = MeshUpload::Parts::Relief;
        const auto draw = [&](MeshUpload::Parts parts, bool polygons) {
            const bool plain = parts == MeshUpload::Parts::Plain;
            if (!mesh.has(parts, state.part))
                return;
            const ProgramFeatures used = plain ? withoutRelief(features) : features;
            const SceneUniforms values = plain ? withoutRelief(uniforms) : uniforms;
            if (const LinkedProgram* program = polygons ? polygonProgramFor(used.posed, error) : meshProgramFor(used, error)) {
                if (program != std::exchange(ready, program) || parts != std::exchange(readyFor, parts))
                    use(*program, values);
                mesh.draw(*program, parts, state.part, values.pushOut != 0.f,
                    used.curved && !used.prisms && !polygons ? parameters.silhouettes : 0, coarse);
            }
        };
        const auto drawAll = [&](bool polygons) {
            draw(MeshUpload::Parts::Relief, polygons);
            draw(MeshUpload::Parts::Plain, polygons);
        };
        const bool covers = features.curved || (features.depthOfHit && !features.maps.contains(MapKind::Opacity));
        if (!covers && mesh.isFinerThanPixels())
            return drawAll(false);
        const bool backs = !covers || mesh.showsBacks(uniforms.eye, uniforms.pushOut);
        glEnable(GL_CULL_FACE); // the fronts first: what they hide is not searched
        glCullFace(GL_BACK);
        drawAll(false);
        if (covers && backs && !intoShadowMap) {
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            drawAll(true);
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        }
        glCullFace(GL_FRONT);
        if (backs)
            drawAll(false);
        glDisable(GL_CULL_FACE);
    }

    // What the light sees, as deep as the relief is there; sets the uniforms by which it is read.
    template <class Use>
    void drawShadowMap(ShadowMap& shadowMap, const State& state, ProgramFeatures features, const Parameters& parameters,
        SceneUniforms& uniforms, const Resources& resources, const Use& use, std::optional<Error>& error)
    {
        features.view = "depth", features.shading = 0, features.shadows = features.softShadows = features.objectShadows = false;
        features.faded = false; // by the eye's view, not the light's
        const SceneUniforms light = lightUniforms(uniforms, resources.mesh->boundsMin, resources.mesh->boundsMax, uniforms.pushOut);
        const TechniqueRow& technique = *findTechnique(features.technique);
        features.depthOfHit = technique.displaces;
        const ShadowCause cause{drawnIntoShadowMap(parameters), features.technique, state.part, resources.mesh, resources.material,
            boundFor(resources, technique, parameters)};
        shadowMap.draw(cause, [&] { drawSurface(state, features, parameters, light, true, false, use, error); });
        uniforms.shadowFromWorld = light.clipFromWorld;
        const glm::mat4& clip = light.clipFromWorld;
        uniforms.shadowTexel = 2.f / (glm::length(glm::vec3(clip[0][0], clip[1][0], clip[2][0])) * float(parameters.shadowMapSize));
    }
};

Renderer::Renderer() : m(std::make_unique<Impl>()) { }
Renderer::~Renderer() = default;
bool Renderer::shadersChanged() const
{
    return m->programs.changed();
}
int Renderer::textureCount() const
{
    return m->uploads.textureCount();
}

Expected<void> Renderer::draw(const State& state, std::size_t pane, const Resources& resources, std::string_view view, const Target& target)
{
    const ViewRow* viewRow = findView(view);
    const TechniqueRow* technique = pane < state.panes.size() ? findTechnique(state.panes[pane].technique) : nullptr;
    if (!viewRow || !technique)
        return failure(std::string(view), "there is no such view or pane", "relievo describe views lists them");
    const Parameters parameters = drawnParameters(state, pane, view);
    const std::set<MapKind> maps = presentMaps(*resources.material);
    clearTarget(parameters, target, viewRow->isHeat);
    if (const auto drawable = canBeDrawnTo(target.width, target.height); !drawable)
        return drawable;
    if ((listHas(technique->maps, "height") || viewRow->isAgainstExact) && !maps.contains(MapKind::Height))
        return failure(state.name,
            std::string(technique->label) + (viewRow->isAgainstExact ? "'s error" : "") + " needs a height map and the material has none",
            "Assign one, or choose Flat or Bump");

    Resources used = resources;
    std::erase_if(m->bounds,
        [&](const auto& made) { return !resources.material->height || made.second.heights != resources.material->height->identity(); });
    used.bounds.insert(m->bounds.begin(), m->bounds.end());
    if (target.mayBake) {
        if (const auto made = m->bounds.find(boundKey(*technique, parameters));
            made != m->bounds.end() && !boundFor(used, *technique, parameters))
            used.bounds.insert_or_assign(made->first, made->second);
        if (const auto made = makeBound(used, *technique, parameters); !made)
            return made;
        m->bounds = used.bounds;
    }
    const std::shared_ptr<const SearchTexture> bound = boundFor(used, *technique, parameters);
    if (!technique->bound.empty() && !bound)
        return failure(state.name, "the map that " + std::string(technique->label) + " searches with is not made yet",
            "Wait until it is, or choose the technique again");

    const Mesh& mesh = *resources.mesh;
    CameraView camera = cameraView(state.camera, mesh.boundsMin, mesh.boundsMax, float(target.width) / float(std::max(target.height, 1)));
    const glm::vec3 shift(2.f * target.jitter.x / float(target.width), 2.f * target.jitter.y / float(std::max(target.height, 1)), 0.f);
    camera.clipFromView = glm::translate(glm::mat4(1.f), shift) * camera.clipFromView;
    SceneUniforms uniforms = sceneUniforms(parameters, camera, mesh.metresPerUV);
    uniforms.pushOut = technique->displaces ? (1.f - parameters.midlevel) * uniforms.reliefDepth : 0.f;
    uniforms.heatScale = 1.f / heatRange(parameters, view);
    uniforms.sampleTurn = target.jitter.x;
    if (const auto fits = fitTheDriver(*resources.material, mesh); !fits)
        return fits;
    if (m->programs.reload())
        m->shadowMaps.clear();
    std::erase_if(m->shadowMaps, [&](const auto& entry) { return entry.first >= state.panes.size(); });
    m->uploads.hold(used);
    m->mesh.hold(resources.mesh);
    ProgramFeatures features = programFeatures(parameters, technique->key, view, maps, target.linear);
    features.posed = bool(mesh.deformation);
    features.onMesh = view == "error" && used.seen && used.seen->width == target.width && used.seen->height == target.height;
    features.prisms = features.prisms && (!viewRow->isAgainstExact || features.onMesh) && m->mesh.hasPrisms(); // the other walks one ray
    features.borders = features.curved && !features.prisms && m->mesh.hasBorders();
    std::optional<Error> error;
    const Wrap wrap = wrapOf(parameters);
    const int curvature = features.curved && !features.prisms ? parameters.silhouettes : 0;
    const auto use = [&](const LinkedProgram& program, const SceneUniforms& values) {
        program.use();
        program.set(parameters);
        program.set(values);
        m->uploads.bindMaps(program, wrap, technique->bound, bound);
        m->uploads.bindSeen(program);
        m->mesh.bind(program, parameters, state.part, curvature);
        if (program.reads("shadowMap"))
            program.bind("shadowMap", GL_TEXTURE_2D, m->shadowMaps[pane].texture(), kShadowUnit);
    };
    if (features.objectShadows) {
        m->drawShadowMap(m->shadowMaps[pane], state, features, parameters, uniforms, used, use, error);
        bindTarget(target);
    }
    const bool coarse = target.hasty && !features.curved && m->mesh.isFinerThanPixels();
    m->drawSurface(state, features, parameters, uniforms, false, coarse, use, error);
    if (parameters.wireframe) {
        if (const LinkedProgram* lines = m->polygonProgramFor(features.posed, error)) {
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            setLineWidth(target.lineWidth);
            glEnable(GL_BLEND);
            glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE); // alpha stays the mesh's
            glEnable(GL_POLYGON_OFFSET_LINE);
            glPolygonOffset(-1.f, -1.f);
            for (const MeshUpload::Parts parts : {MeshUpload::Parts::Relief, MeshUpload::Parts::Plain}) {
                const SceneUniforms values = parts == MeshUpload::Parts::Plain ? withoutRelief(uniforms) : uniforms;
                use(*lines, values);
                m->mesh.draw(*lines, parts, state.part, values.pushOut != 0.f, 0, coarse);
            }
            glDisable(GL_POLYGON_OFFSET_LINE);
            glDisable(GL_BLEND);
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        }
    }
    if (parameters.background == 1 && !viewRow->isHeat) {
        const std::string key = target.linear ? "background/linear" : "background";
        if (const LinkedProgram* sky = m->programs.get(
                key, [&](const ShaderReader& read) { return backgroundProgram(target.linear, read); }, error)) {
            use(*sky, uniforms);
            if (!m->noVertices)
                m->noVertices = newVertexArray();
            glDepthFunc(GL_LEQUAL);
            glBindVertexArray(*m->noVertices);
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glBindVertexArray(0);
        }
    }
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(0);
    if (const auto sufficed = memorySufficed(); !sufficed) {
        m->uploads = Uploads(), m->mesh = MeshUpload(), m->shadowMaps.clear(); // the next picture tries again, and tells again
        return sufficed;
    }
    if (error)
        return tl::unexpected(*error);
    return {};
}

Expected<Measurement> Renderer::measure(const State& state, std::size_t pane, const Resources& resources, float aspect, bool mayBake)
{
    const int width = aspect >= 1.6f ? 320 : std::max(1, int(200.f * aspect));
    const int height = aspect >= 1.6f ? std::max(1, int(320.f / aspect)) : 200;
    if (const auto made = m->measuring.resize(width, height, true); !made)
        return tl::unexpected(made.error());
    State counted = state;
    counted.parameters.wireframe = false;
    const Target target{m->measuring.handle(), width, height, true, 1.f, {}, false, mayBake};
    if (const auto drawn = draw(counted, pane, resources, "fetches", target); !drawn)
        return tl::unexpected(drawn.error());
    m->pixels.resize(std::size_t(width) * std::size_t(height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, m->pixels.data());
    Measurement result;
    double covered = 0.;
    for (std::size_t i = 0; i < m->pixels.size(); i += 4) {
        covered += double(m->pixels[i + 3]);
        result.meanFetches += double(m->pixels[i] * m->pixels[i + 3]);
        result.maxFetches = std::max(result.maxFetches, double(m->pixels[i]));
    }
    result.meanFetches /= std::max(covered, 1.);
    result.covered = covered / double(width * height);
    return result;
}

} // namespace relievo
