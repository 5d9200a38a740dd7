// Whether points are in a relief object, by the texels nearest to them: one fetch an axis and layer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "object/object_contract.glsl"

ivec2 texelUnder(int axis, vec3 place)
{
    ivec4 map = objectAxes[axis];
    return ivec2(int(floor(0.5f * (1.0f + place.x) * float(map.x))), int(floor(0.5f * (1.0f + place.y) * float(map.y))));
}

// How far a point lies within the solid of an axis, as a share of the box's length; negative outside. What it is nearest to is its front,
// or its back.
float insideBy(int axis, vec3 point)
{
    vec3 place = ontoAxis(axis, point);
    float deep = 0.5f + 0.5f * place.z;
    float most = -2.0f;
    for (int k = 0; k < objectAxes[axis].z; ++k) {
        vec2 solid = intervalAt(axis, texelUnder(axis, place), k);
        if (solid.x <= solid.y)
            most = max(most, min(deep - solid.x, solid.y - deep));
    }
    return most;
}

// The outwards side of what a point of an axis' surface is nearest to.
vec3 outwardsAt(int axis, vec3 point)
{
    vec3 place = ontoAxis(axis, point);
    float deep = 0.5f + 0.5f * place.z;
    float least = 4.0f;
    float side = -1.0f;
    for (int k = 0; k < objectAxes[axis].z; ++k) {
        vec2 solid = intervalAt(axis, texelUnder(axis, place), k);
        if (solid.x <= solid.y && abs(deep - solid.x) < least) {
            least = abs(deep - solid.x);
            side = -1.0f;
        }
        if (solid.x <= solid.y && abs(deep - solid.y) < least) {
            least = abs(deep - solid.y);
            side = 1.0f;
        }
    }
    return fromAxis(axis, vec3(0.0f, 0.0f, side));
}
