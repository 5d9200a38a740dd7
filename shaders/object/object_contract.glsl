// What the search of a relief object gets and returns, and the intervals that it reads (core/object/object_texels.h). objectAxes: width,
// height (texels, 0: not given), layers and topmost level of each axis; objectLevels: where its levels begin, sixteen for each axis.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct ObjectRay {
    vec3 origin; // by the box, which reaches from -1 to 1 along each axis
    vec3 way; // for each unit of t
    float from; // it is in the box from t = from
    float end; // to t = end
};
struct ObjectHit {
    bool found;
    float t;
    int axis; // whose depths it meets
    vec3 outwards; // of the surface there, by the box, of any length
    int fetches;
};
const float kNever = 1e30f;

int objectReads = 0;

// A point or direction of the box along u, v and depth of an axis, and back.
vec3 ontoAxis(int axis, vec3 p)
{
    return axis == 0 ? vec3(-p.z, -p.y, -p.x) : axis == 1 ? vec3(p.x, p.z, -p.y) : vec3(p.x, -p.y, -p.z);
}

vec3 fromAxis(int axis, vec3 p)
{
    return axis == 0 ? vec3(-p.z, -p.y, -p.x) : axis == 1 ? vec3(p.x, -p.z, p.y) : vec3(p.x, -p.y, -p.z);
}

// Front and back of a layer, as shares of the box's length; nothing is solid where back lies before front.
vec2 intervalAt(int axis, ivec2 texel, int layer)
{
    ivec4 map = objectAxes[axis];
    ivec2 at = clamp(texel, ivec2(0), ivec2(map.x - 1, map.y - 1));
    ++objectReads;
    return objectTexel(objectLevels[16 * axis] + (at.y * map.x + at.x) * map.z + layer);
}
