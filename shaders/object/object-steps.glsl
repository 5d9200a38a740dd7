// Relief objects in one pass of equal steps through the box, each asked whether all axes agree, and halvings of the one that went inside.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "object/object_nearest.glsl"

bool isInObject(vec3 point)
{
    for (int axis = 0; axis < 3; ++axis)
        if (objectAxes[axis].x > 0 && insideBy(axis, point) < 0.0f)
            return false;
    return true;
}

ObjectHit traceObject(ObjectRay ray)
{
    objectReads = 0;
    ObjectHit hit = ObjectHit(false, ray.from, 0, vec3(0.0f), 0);
    float size = (ray.end - ray.from) / float(maxSteps);
    float before = ray.from;
    for (int i = 0; i < maxSteps && !hit.found; ++i) {
        before = hit.t;
        hit.t = ray.from + size * float(i + 1);
        hit.found = isInObject(ray.origin + ray.way * hit.t);
    }
    for (int i = 0; i < refineSteps && hit.found; ++i) {
        float middle = 0.5f * (before + hit.t);
        bool isIn = isInObject(ray.origin + ray.way * middle);
        before = isIn ? before : middle;
        hit.t = isIn ? middle : hit.t;
    }
    float least = 4.0f;
    vec3 point = ray.origin + ray.way * hit.t;
    for (int axis = 0; axis < 3 && hit.found; ++axis) {
        float by = objectAxes[axis].x > 0 ? insideBy(axis, point) : 4.0f;
        if (by < least) {
            least = by;
            hit.axis = axis;
        }
    }
    hit.outwards = outwardsAt(hit.axis, point);
    hit.fetches = objectReads;
    return hit;
}
