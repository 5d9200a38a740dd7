// A search ray in texture space and what a search returns (ARCHITECTURE.md, "The contract of a technique"), as plain values for the CPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace relievo {

// uv(t) = uv + t * duv, t from 0 (polygon) to 1 (deepest). Doubles: the reference takes rays as they were given.
struct SearchRay {
    glm::dvec2 uv{0.}, duv{0.};
    double cosView = 1.; // |N.V|, in (0, 1]
    // Over a curved surface the depth at t is t - bend.x - bend.y t - bend.z t^2 (shaders/search/bend_quadric.glsl); the reference takes 0
    // only.
    glm::dvec3 bend{0.};
    double end = 1.; // the search ends at this t: the depth of the point that a ray of light comes to
};

struct SearchHit {
    bool found = false;
    double t = 1.;
    glm::dvec2 uv{0.};
    int fetches = 0; // texture reads of the search; for the reference the cells and pyramid nodes visited
    int bytes = 0; // that the fetches return, as the maps are stored; 0 for the reference
    bool isUnfinished = false; // the search gave up before it knew the answer, as its rounds are bounded; not found then
};

inline SearchHit unfinished(const SearchRay& ray, int fetches, int bytes = 0)
{
    return {false, 1., ray.uv + ray.duv, fetches, bytes, true};
}

// What the shader texts get of a ray. Numbers that are next to nothing are 0: graphics drivers take denormal floats for 0 or not as
// they like, and the CPU's answers are to be theirs.
inline glm::vec2 inFloat(glm::dvec2 v)
{
    const auto flushed = [](double x) { return std::abs(x) < double(std::numeric_limits<float>::min()) ? 0.f : float(x); };
    return {flushed(v.x), flushed(v.y)};
}

inline bool isFinite(const SearchRay& ray)
{
    return std::isfinite(ray.uv.x) && std::isfinite(ray.uv.y) && std::isfinite(ray.duv.x) && std::isfinite(ray.duv.y);
}
inline bool isFiniteInFloat(const SearchRay& ray)
{
    const auto finite = [](glm::dvec2 v) { return std::isfinite(float(v.x)) && std::isfinite(float(v.y)); };
    return finite(ray.uv) && finite(ray.duv);
}

} // namespace relievo
