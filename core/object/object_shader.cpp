// The objects' shader text in C++: each technique's file in the body of a struct whose members are the uniforms.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_shader.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace relievo::glsl {
using namespace glm;

struct ObjectMachine : Parameters {
    const Interval* texels = nullptr;
    std::array<ivec4, 3> objectAxes{};
    std::array<int, 3 * ObjectTexels::kLevels> objectLevels{};

    // As unsigned normalised texels are read on the GPU.
    vec2 objectTexel(int i) const
    {
        const Interval& interval = texels[i];
        return {float(interval.front) / 65535.f, float(interval.back) / 65535.f};
    }
};
struct ExactObject : ObjectMachine {
#include "shaders/object/object.glsl"
};
struct SteppedObject : ObjectMachine {
#include "shaders/object/object-steps.glsl"
};
struct SidedObject : ObjectMachine {
#include "shaders/object/object-sides.glsl"
};
} // namespace relievo::glsl

namespace relievo {

namespace {
struct Found {
    bool found = false;
    float t = 0.f;
    glm::vec3 outwards{0.f};
    int fetches = 0;
};

template <class Technique> Found run(const Parameters& parameters, const ObjectTexels& texels, glm::vec3 origin, glm::vec3 way, float end)
{
    Technique technique;
    static_cast<Parameters&>(technique) = parameters;
    technique.texels = texels.texels.data();
    std::ranges::copy(texels.axes, technique.objectAxes.begin());
    technique.objectLevels = texels.levels;
    const auto hit = technique.traceObject({origin, way, 0.f, end});
    return {hit.found, hit.t, hit.outwards, hit.fetches};
}

struct SearchRow {
    std::string_view technique;
    Found (*run)(const Parameters&, const ObjectTexels&, glm::vec3, glm::vec3, float);
};
constexpr SearchRow kSearches[]
    = {{"object", run<glsl::ExactObject>}, {"object-steps", run<glsl::SteppedObject>}, {"object-sides", run<glsl::SidedObject>}};

// The part of the ray that is in the box; from > to when it misses. In double precision, as the GPU has the point on the box from a
// rasteriser.
struct Part {
    double from = 0., to = 1e300;
    int entered = -1; // the axis across whose face it comes in
};
Part partInBox(glm::dvec3 o, glm::dvec3 d)
{
    Part part;
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0. && std::abs(o[i]) > 1.)
            part.to = -1.;
        if (d[i] == 0.)
            continue;
        const double near = (std::copysign(1., -d[i]) - o[i]) / d[i];
        if (near > part.from)
            part.from = near, part.entered = i;
        part.to = std::min(part.to, (std::copysign(1., d[i]) - o[i]) / d[i]);
    }
    return part;
}
} // namespace

ObjectRayHit searchObject(std::string_view technique, const Parameters& parameters, const ReliefObject& object, const ObjectTexels& texels,
    glm::dvec3 origin, glm::dvec3 direction)
{
    const glm::dvec3 o = object.inBox(origin), d = object.directionInBox(direction);
    const bool isFinite = std::isfinite(glm::dot(o, o)) && std::isfinite(glm::dot(d, d)) && d != glm::dvec3(0.);
    const Part part = isFinite ? partInBox(o, d) : Part{.to = -1.};
    const auto row = std::ranges::find(kSearches, technique, &SearchRow::technique);
    if (!(part.from <= part.to) || row == std::end(kSearches))
        return {};
    const double unit = glm::length(d); // of t in lengths of the box's halves
    const Found found = row->run(parameters, texels, glm::clamp(o + part.from * d, -1., 1.), d / unit, float((part.to - part.from) * unit));
    if (!found.found)
        return {.fetches = found.fetches};
    glm::dvec3 outwards = found.outwards;
    if (outwards == glm::dvec3(0.) && part.entered >= 0)
        outwards[part.entered] = std::copysign(1., -d[part.entered]);
    glm::dvec3 normal{0.};
    for (int i = 0; i < 3; ++i)
        normal += object.half[std::size_t(i)] * (outwards[i] / glm::dot(object.half[std::size_t(i)], object.half[std::size_t(i)]));
    const bool hasNormal = glm::dot(normal, normal) > 0.;
    return {true, part.from + double(found.t) / unit, hasNormal ? glm::normalize(normal) : -glm::normalize(direction), found.fetches};
}

} // namespace relievo
