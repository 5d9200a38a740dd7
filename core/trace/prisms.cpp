// The prisms' shader text in C++.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/prisms.h"
#include "core/mesh/edges/across.h"
#include "core/mesh/edges/prism_texels.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/state/techniques.h"
#include "core/trace/machine.h"
#include <glm/mat2x2.hpp>

namespace relievo::glsl {

// Searches through a technique's own machine.
struct PrismMachine : Machine, SceneUniforms {
    const SearchMaps* maps = nullptr;
    TextSearch search = nullptr;
    const glm::vec4* texels = nullptr;

    vec4 prismTexel(int i) const { return texels[i]; }
    Hit trace(Ray ray) { return search(*this, *maps, ray, curve, nullptr).hit; }
#include "shaders/view_ray/prisms.glsl"
#include "shaders/view_ray/search_own.glsl"
};
struct ExactPrisms : PrismMachine {
    explicit ExactPrisms(const PrismMachine& prisms) : PrismMachine(prisms) { }
#include "shaders/search/walk.glsl"
#include "shaders/shadow/prism_light.glsl"
#include "shaders/shadow/shadow_end_exact.glsl"
};
struct MarchedPrisms : PrismMachine {
    explicit MarchedPrisms(const PrismMachine& prisms) : PrismMachine(prisms) { }
#include "shaders/shadow/prism_light.glsl"
#include "shaders/shadow/shadow_end_bias.glsl"
};

} // namespace relievo::glsl

namespace relievo {

struct Prisms::Impl {
    SearchMaps maps;
    std::vector<glm::vec4> texels;
    glsl::PrismMachine machine; // to be copied: its text keeps values of the ray
    bool isExact = false;
};

Expected<Prisms> Prisms::make(std::string_view technique, const Parameters& parameters, const Mesh& mesh, const HeightField& field)
{
    auto maps = searchMaps(technique, parameters, &field);
    if (!maps)
        return tl::unexpected(maps.error());
    const TechniqueRow& row = *findTechnique(technique);
    const auto impl = std::make_shared<Impl>();
    impl->maps = std::move(*maps);
    impl->texels = prismTexels(mesh, edgesAcross(mesh), std::vector<char>(mesh.parts.size(), 0));
    impl->isExact = row.isExact;
    glsl::PrismMachine& machine = impl->machine;
    static_cast<Parameters&>(machine) = parameters;
    static_cast<SceneUniforms&>(machine) = sceneUniforms(parameters, {}, mesh.metresPerUV);
    machine.pushOut = (1.f - parameters.midlevel) * machine.reliefDepth;
    machine.heightMap = &*impl->maps.height;
    machine.wrap = machine.heightMap->wrap();
    machine.maps = &impl->maps, machine.texels = impl->texels.data(), machine.search = textSearch(row.file);
    machine.trianglesStart = int(impl->texels.front().x);
    if (!machine.search || !row.hasShadowsAndOutlines())
        return failure(std::string(technique), "this technique has no silhouettes", "Take another");
    Prisms prisms;
    prisms.m = impl;
    return prisms;
}

PrismRayHit Prisms::hit(int triangle, glm::vec3 start, glm::vec3 way) const
{
    const glm::vec3 a = outerCorner(triangle, 0), b = outerCorner(triangle, 1), c = outerCorner(triangle, 2);
    glsl::PrismMachine machine = m->machine;
    const float depth = glm::dot(glm::cross(b - a, c - a), way) < 0.f ? machine.reliefDepth : -machine.reliefDepth;
    const auto walk = machine.walkPrisms(triangle, start, way, depth);
    return {walk.hit.found, walk.hit.t, walk.hit.uv, walk.point, walk.triangle, walk.hit.fetches};
}

bool Prisms::isHidden(const PrismRayHit& from, glm::vec3 toLight, bool isFront) const
{
    const float depth = isFront ? m->machine.reliefDepth : -m->machine.reliefDepth;
    const auto hidden = [&](auto machine) { return machine.isHiddenFrom(from.triangle, from.uv, from.depth, from.point, toLight, depth); };
    return m->isExact ? hidden(glsl::ExactPrisms(m->machine)) : hidden(glsl::MarchedPrisms(m->machine));
}

glm::vec3 Prisms::outerCorner(int triangle, int corner) const
{
    glsl::PrismMachine machine = m->machine;
    return machine.prismOf(triangle, 0.f).corners[corner].place;
}

} // namespace relievo
