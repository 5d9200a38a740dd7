// Relief objects as the RTM report draws them (section 5.2): each axis is searched by itself, in equal steps and halvings, and what it
// finds is discarded where the other two say that nothing is there. The ray does not go on then, so holes appear. Without the discard only
// the side that the ray enters by is searched, as in the report's naive form (figure 5.2).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "object/object_nearest.glsl"

// The first t at which steps along the ray are in the solid of one axis; kNever.
float alongSide(ObjectRay ray, int axis)
{
    float size = (ray.end - ray.from) / float(maxSteps);
    float before = ray.from;
    float t = ray.from;
    bool found = false;
    for (int i = 0; i < maxSteps && !found; ++i) {
        before = t;
        t = ray.from + size * float(i + 1);
        found = insideBy(axis, ray.origin + ray.way * t) >= 0.0f;
    }
    for (int i = 0; i < refineSteps && found; ++i) {
        float middle = 0.5f * (before + t);
        bool isIn = insideBy(axis, ray.origin + ray.way * middle) >= 0.0f;
        before = isIn ? before : middle;
        t = isIn ? middle : t;
    }
    return found ? t : kNever;
}

ObjectHit traceObject(ObjectRay ray)
{
    objectReads = 0;
    ObjectHit hit = ObjectHit(false, kNever, 0, vec3(0.0f), 0);
    vec3 start = abs(ray.origin + ray.way * ray.from);
    int entered = start.x >= max(start.y, start.z) ? 0 : start.y >= start.z ? 1 : 2;
    bool onlyEntered = !crossDiscard && objectAxes[entered].x > 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (objectAxes[axis].x <= 0 || (onlyEntered && axis != entered))
            continue;
        float t = alongSide(ray, axis);
        bool counts = t < hit.t;
        for (int other = 0; other < 3; ++other)
            if (counts && crossDiscard && other != axis && objectAxes[other].x > 0)
                counts = insideBy(other, ray.origin + ray.way * t) >= -sideTolerance;
        if (counts) {
            hit.found = true;
            hit.t = t;
            hit.axis = axis;
        }
    }
    if (hit.found)
        hit.outwards = outwardsAt(hit.axis, ray.origin + ray.way * hit.t);
    else
        hit.t = ray.from;
    hit.fetches = objectReads;
    return hit;
}
