// The first t at which the stretches of all axes agree.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_search.h"
#include "core/object/axis_walk.h"
#include <cmath>

namespace relievo {

namespace {
bool isFinite(glm::dvec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The ray's way through the box, and the axis across which it enters; -1 where it begins inside.
std::optional<int> clip(BoxRay& ray)
{
    int entered = -1;
    for (int i = 0; i < 3; ++i) {
        const double o = ray.origin[i], d = ray.direction[i];
        if (d == 0.) {
            if (std::abs(o) > 1.)
                return {};
            continue;
        }
        const double near = (std::copysign(1., -d) - o) / d, far = (std::copysign(1., d) - o) / d;
        if (near > ray.from) {
            ray.from = near;
            entered = i;
        }
        ray.to = std::min(ray.to, far);
    }
    return ray.from <= ray.to ? std::optional(entered) : std::nullopt;
}

// Of a function of box coordinates with this gradient by p (an axis' u, v and depth in turn), in the world.
glm::dvec3 worldNormal(const ReliefObject& object, glm::dvec3 gradient)
{
    glm::dvec3 normal{0.};
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& half = object.half[std::size_t(i)];
        normal += half * (gradient[i] / glm::dot(half, half));
    }
    return glm::normalize(normal);
}

glm::dvec3 normalOf(const ReliefObject& object, int axis, const Span& span)
{
    const AxisMap& map = object.axes[std::size_t(axis)];
    const AxisFrame& frame = kAxisFrames[std::size_t(axis)];
    return worldNormal(
        object, span.gradient.x * map.width * frame.u + span.gradient.y * map.height * frame.v + span.gradient.z * frame.depth);
}
} // namespace

std::optional<ObjectHit> firstHit(const ReliefObject& object, glm::dvec3 origin, glm::dvec3 direction, double end)
{
    BoxRay ray{object.inBox(origin), object.directionInBox(direction), 0., end};
    if (!isFinite(ray.origin) || !isFinite(ray.direction) || direction == glm::dvec3(0.))
        return {};
    const std::optional<int> entered = clip(ray);
    if (!entered)
        return {};
    std::vector<std::pair<int, AxisWalk>> walks;
    walks.reserve(3);
    for (int axis = 0; axis < 3; ++axis)
        if (object.axes[std::size_t(axis)].isGiven())
            walks.emplace_back(axis, AxisWalk(object.axes[std::size_t(axis)], kAxisFrames[std::size_t(axis)], ray));
    if (walks.empty())
        return {};
    double t = ray.from;
    const Span* met = nullptr;
    Span last;
    int axis = std::max(*entered, 0);
    for (bool agree = false; !agree;) {
        agree = true;
        for (auto& [number, walk] : walks) {
            const Span* span = walk.from(t);
            if (!span)
                return {};
            if (span->from <= t)
                continue;
            t = span->from;
            last = *span;
            met = &last;
            axis = number;
            agree = false;
        }
    }
    ObjectHit hit{t, origin + t * direction, -glm::normalize(direction), axis, met ? met->layer : 0, met ? met->on : HitOn::Inside};
    if (met)
        hit.normal = normalOf(object, axis, *met);
    else if (*entered >= 0) {
        glm::dvec3 face{0.};
        face[axis] = std::copysign(1., -ray.direction[axis]);
        hit.normal = worldNormal(object, face);
        hit.on = HitOn::Box;
    }
    return hit;
}

} // namespace relievo
