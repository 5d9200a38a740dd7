// A shaded relief frame against the bare search with the same steps, and each technique's frame against flat: ratios of one run,
// interleaved, median of 9, by the clock between glFinish calls. Then what each switch of light, layers and camera costs, and how many
// pixels shadows by horizons have wrong; and relief objects against their meshes (alone: --objects).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "core/state/techniques.h"
#include "render/windowless.h"
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <epoxy/gl.h>
#include <sstream>
#include <string>
#include <utility>

using namespace relievo;

namespace {

struct Case {
    const char* name;
    State state;
    const char* view;
    std::vector<double> milliseconds = {};
    double median()
    {
        std::ranges::sort(milliseconds);
        return milliseconds[milliseconds.size() / 2];
    }
};

// Settings of a relief frame with self-shadows, each with what it is compared by.
constexpr std::array<std::pair<const char*, const char*>, 28> kSwitches = {{{"plain", ""}, {"thesis shading", "shading=thesis"},
    {"clear coat", "clearcoat=1"}, {"sheen", "sheen=1"}, {"transmission", "transmission=0.5"},
    {"stretched highlights", "anisotropyStrength=0.7"}, {"glow", "bloom=0.3"}, {"soft shadow", "lightSize=2"},
    {"no shadow", "shadows=false"}, {"horizon shadow", "shadowSearch=horizon"}, {"soft horizon shadow", "shadowSearch=horizon lightSize=2"},
    {"ambient occlusion", "ambientRelief=occlusion"}, {"bent normals", "ambientRelief=bent"},
    {"bent, specular occlusion", "ambientRelief=bent specularOcclusion=true"}, {"second light, shadow", "light2Kind=directional"},
    {"second light, none", "light2Kind=directional light2Shadows=false"}, {"floor", "ground=true"},
    {"floor, reflection", "ground=true groundReflection=0.5"}, {"shadows between objects", "objectShadows=true"},
    {"environment behind", "background=environment"}, {"tone curve agx", "toneCurve=agx"}, {"tone curve aces", "toneCurve=aces"},
    {"tone curve none", "toneCurve=none"}, {"vignette", "vignette=1"}, {"metered", "autoExposure=true"},
    {"white balance", "whiteBalance=4000"}, {"nearest texels", "textureFilter=false"}, {"no mip mapping", "mipMapping=false"}}};

double frame(Renderer& renderer, const Case& measured, const Resources& resources, const Target& target)
{
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    if (const auto drawn = renderer.draw({measured.state, 0, resources, target, measured.view}); !drawn)
        std::fprintf(stderr, "%s\n", message(drawn.error()).c_str());
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Pixels whose shadow by horizons is another than the one that is searched exactly, by the light's height, and what a frame costs with
// each.
void horizonsByHeight(Renderer& renderer, const Framebuffer& framebuffer)
{
    const Target target{.framebuffer = framebuffer.handle(), .width = 800, .height = 600};
    for (const char* source : {"sample:bricks", "sample:cobblestones"}) {
        State state = openSource(source, State())->state;
        state.camera.pitch = 35.f, state.camera.distance = 0.7f;
        state.panes = {Pane{"cell-cone"}};
        state.parameters.heightMips = false;
        std::printf("%s, cell cones: wrong pixels of 8, 16 azimuths; frame x searched shadow\n", source);
        for (const float pitch : {10.f, 20.f, 40.f, 60.f, 80.f}) {
            state.parameters.lightPitch = pitch;
            std::array<Case, 3> cases = {Case{"searched", state, "shaded"}, Case{"8", state, "shaded"}, Case{"16", state, "shaded"}};
            cases[1].state.parameters.horizonAzimuths = HorizonAzimuths::Eight;
            for (std::size_t i = 1; i < cases.size(); ++i)
                cases[i].state.parameters.shadowSearch = ShadowSearch::Horizon;
            Resources resources = *loadResources(state, {}, {});
            std::array<Image, 3> pictures;
            for (std::size_t i = 0; i < cases.size(); ++i)
                pictures[i] = *drawPicture(renderer, cases[i].state, 0, resources, "shadow", 800, 600, 1, true);
            const auto wrong = [&](const Image& picture) {
                double count = 0.;
                for (int n = 0; n < 800 * 600; ++n)
                    count += std::abs(picture.value(n % 800, n / 800, 0) - pictures[0].value(n % 800, n / 800, 0)) > 0.5f;
                return 100. * count / (800. * 600.);
            };
            for (int round = 0; round < 11; ++round)
                for (Case& measured : cases)
                    if (const double ms = frame(renderer, measured, resources, target); round >= 2)
                        measured.milliseconds.push_back(ms);
            const double searched = cases[0].median();
            std::printf("light at %2.0f deg   %5.2f %%  %5.2f %%   %5.2f  %5.2f x\n", double(pitch), wrong(pictures[1]), wrong(pictures[2]),
                cases[1].median() / searched, cases[2].median() / searched);
        }
    }
}

// Relief objects against the meshes that they stand for, with the same light: a renderer each, as uploads are a mesh's.
void objectsByMesh(const Framebuffer& framebuffer)
{
    const Target target{.framebuffer = framebuffer.handle(), .width = 800, .height = 600};
    std::printf("relief objects of 256 x 256, six sides, two layers: frame x mesh; fetches a pixel seen\n");
    for (const std::string shape : {"torus", "teapot", "knight", "character"}) {
        State mesh = openSource("sample:bricks", State())->state, object = mesh;
        mesh.mesh = shape, object.mesh = "object:" + shape;
        mesh.panes = {Pane{"flat"}};
        mesh.parameters.shadows = object.parameters.shadows = false;
        mesh.camera.fill = object.camera.fill = 0.9f;
        std::vector<Case> cases = {{"mesh", mesh, "shaded"}};
        for (const TechniqueRow& technique : kObjectTechniques) {
            object.panes = {Pane{std::string(technique.key)}};
            cases.push_back({technique.key.data(), object, "shaded"});
        }
        const auto ofMesh = loadResources(mesh, {}, {}), ofObject = loadResources(object, {}, {});
        if (!ofMesh || !ofObject)
            return;
        Renderer meshes, objects;
        for (int round = 0; round < 11; ++round)
            for (Case& measured : cases) {
                const bool isMesh = &measured == cases.data();
                if (const double ms = frame(isMesh ? meshes : objects, measured, isMesh ? *ofMesh : *ofObject, target); round >= 2)
                    measured.milliseconds.push_back(ms);
            }
        const double plain = cases.front().median();
        std::printf("%-10s %zu triangles, %.2f ms:", shape.c_str(), ofMesh->mesh->indices.size() / 3, plain);
        for (std::size_t i = 1; i < cases.size(); ++i) {
            const auto counted = objects.measure(cases[i].state, 0, *ofObject, 4.f / 3.f);
            std::printf("  %s %.2f x, %.0f", cases[i].name, cases[i].median() / plain, counted ? counted->meanFetches : 0.);
        }
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv)
{
    const auto context = WindowlessContext::create();
    if (context && argc > 1 && std::string(argv[1]) == "--objects") {
        Framebuffer framebuffer;
        framebuffer.resize(800, 600);
        objectsByMesh(framebuffer);
        return 0;
    }
    auto opened = openSource("sample:bricks", State());
    if (!context || !opened)
        return 1;
    State state = opened->state;
    state.camera.pitch = 35.f; // the default view, close enough to fill the picture
    state.camera.distance = 0.7f;
    const auto with = [&](const char* technique, bool shadows, Shading shading) {
        State other = state;
        other.panes = {Pane{technique}};
        other.parameters.shadows = shadows;
        other.parameters.shading = shading;
        return other;
    };
    std::vector<Case> cases = {{"search alone (depth view)", with("relief", false, Shading::MetallicRoughness), "depth"},
        {"relief, metallic-roughness", with("relief", false, Shading::MetallicRoughness), "shaded"},
        {"relief, Blinn-Phong", with("relief", false, Shading::BlinnPhong), "shaded"},
        {"relief with self-shadows", with("relief", true, Shading::MetallicRoughness), "shaded"},
        {"parallax", with("parallax", false, Shading::MetallicRoughness), "shaded"},
        {"bump", with("bump", false, Shading::MetallicRoughness), "shaded"},
        {"flat", with("flat", false, Shading::MetallicRoughness), "shaded"}};
    auto resources = loadResources(state, {}, {});
    if (!resources)
        return 1;
    Renderer renderer;
    Framebuffer framebuffer;
    framebuffer.resize(800, 600);
    const Target target{.framebuffer = framebuffer.handle(), .width = 800, .height = 600};
    for (int round = 0; round < 11; ++round)
        for (Case& measured : cases)
            if (const double ms = frame(renderer, measured, *resources, target); round >= 2) // two rounds warm up
                measured.milliseconds.push_back(ms);
    const double search = cases.front().median();
    std::printf("800x600, plane, sample bricks, relief %d to %d + %d steps, %s\n", state.parameters.minSteps, state.parameters.maxSteps,
        state.parameters.refineSteps, reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    for (Case& measured : cases)
        std::printf("%-30s %7.2f ms  %5.2f x the search alone\n", measured.name, measured.median(), measured.median() / search);
    std::vector<Case> switched;
    for (const auto& [name, settings] : kSwitches) {
        switched.push_back({name, with("relief", true, Shading::MetallicRoughness), "shaded"});
        std::istringstream words(settings);
        for (std::string word; words >> word;)
            if (const auto set = setParameter(switched.back().state, word); !set)
                return std::fprintf(stderr, "%s\n", message(set.error()).c_str()), 1;
    }
    for (const Case& measured : switched)
        if (const auto made = resources->accelerationMaps.makeFor(measured.state, *resources->material); !made)
            return std::fprintf(stderr, "%s\n", message(made.error()).c_str()), 1;
    for (int round = 0; round < 11; ++round)
        for (Case& measured : switched)
            if (const double ms = frame(renderer, measured, *resources, target); round >= 2)
                measured.milliseconds.push_back(ms);
    const double plain = switched.front().median();
    std::printf("each switch, relief with self-shadows\n");
    for (Case& measured : switched)
        std::printf("%-30s %7.2f ms  %5.2f x plain\n", measured.name, measured.median(), measured.median() / plain);
    horizonsByHeight(renderer, framebuffer);
    objectsByMesh(framebuffer);
}
