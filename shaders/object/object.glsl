// Relief objects, exactly, in one pass: the ray goes from axis to axis, each of which moves it on to where its own solid begins, until all
// agree.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "object/object_walk.glsl"

ObjectHit traceObject(ObjectRay ray)
{
    objectReads = 0;
    int given = 0;
    for (int axis = 0; axis < 3; ++axis) {
        objectLevel[axis] = max(objectAxes[axis].w - 1, 0);
        given += objectAxes[axis].x > 0 ? 1 : 0;
    }
    ObjectHit hit = ObjectHit(false, ray.from, 0, vec3(0.0f), 0);
    int axis = abs(ray.way.x) > max(abs(ray.way.y), abs(ray.way.z)) ? 0 : abs(ray.way.y) > abs(ray.way.z) ? 1 : 2;
    int agree = 0;
    for (int i = 0; i < 3 * kMostNodes && agree < given; ++i) {
        if (objectAxes[axis].x > 0) {
            SolidMet met = nextSolid(ray, axis, hit.t);
            if (met.t >= kNever)
                break;
            if (met.t > hit.t) {
                hit.t = met.t;
                hit.axis = axis;
                hit.outwards = fromAxis(axis, met.outwards);
                agree = 0;
            }
            ++agree;
        }
        axis = axis == 2 ? 0 : axis + 1;
    }
    hit.found = given > 0 && agree == given;
    hit.fetches = objectReads;
    return hit;
}
