// Where a ray is within the solid of one axis of a relief object (resources/help/objects.md, "What is solid"), exactly: nodes of a pyramid
// of bounds are passed until a cell may be met, whose depths along the ray are quadratics.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "object/object_contract.glsl"

struct SolidMet {
    float t;
    vec3 outwards; // along u, v and depth of the axis
};

const int kMostNodes = 16384; // of one axis: a bound on what one ray costs
const float kTouches = 4e-7f; // share of the box: what is left so soon by a wall is only touched, as the walls of two axes often lie in one plane

int objectLevel[3]; // of the pyramid, on which the walk along an axis goes on

// The ray less a bilinear depth, by the way since it came into the cell: x + y s + z s^2. depths: at the corners 00 10 01 11.
vec3 depthAlong(vec4 depths, vec3 at, vec3 way)
{
    float kx = depths.y - depths.x;
    float ky = depths.z - depths.x;
    float kxy = depths.w - depths.y - ky;
    return vec3(at.z - (depths.x + kx * at.x + ky * at.y + kxy * at.x * at.y),
        way.z - kx * way.x - ky * way.y - kxy * (at.x * way.y + at.y * way.x), -kxy * way.x * way.y);
}

// The smallest root in [0, reach], without cancellation; kNever without one. A root that rounding has moved past an end counts.
float rootWithin(vec3 f, float reach)
{
    float discriminant = f.y * f.y - 4.0f * f.z * f.x;
    if (discriminant < 0.0f)
        return kNever;
    float root = sqrt(discriminant);
    float q = -0.5f * (f.y < 0.0f ? f.y - root : f.y + root);
    float slack = 1e-6f * reach;
    float first = q != 0.0f ? f.x / q : kNever;
    float second = f.z != 0.0f ? q / f.z : kNever;
    first = first >= -slack && first <= reach + slack ? first : kNever;
    second = second >= -slack && second <= reach + slack ? second : kNever;
    float least = min(first, second);
    return least < kNever ? clamp(least, 0.0f, reach) : kNever;
}

// The outwards side of a bilinear front, s after the ray came into the cell.
vec3 frontOutwards(vec4 depths, vec3 at, vec3 way, float s, vec2 size)
{
    float kxy = depths.w - depths.y - depths.z + depths.x;
    return vec3((depths.y - depths.x + kxy * (at.y + s * way.y)) * size.x, (depths.z - depths.x + kxy * (at.x + s * way.x)) * size.y, -1.0f);
}

// Of a layer that all four corners of a cell hold.
SolidMet inHeldCell(vec4 fronts, vec4 backs, vec3 at, vec3 way, float reach, vec2 size, vec3 wall)
{
    vec3 front = depthAlong(fronts, at, way);
    vec3 back = depthAlong(backs, at, way);
    if (front.x >= 0.0f && back.x <= 0.0f)
        return SolidMet(0.0f, wall);
    float atFront = rootWithin(front, reach);
    float atBack = rootWithin(back, reach);
    // What has no thickness is met from the side that the ray comes from.
    bool isFront = atFront < atBack || (atFront == atBack && front.y + 2.0f * atFront * front.z >= 0.0f);
    return isFront ? SolidMet(atFront, frontOutwards(fronts, at, way, atFront, size))
                   : SolidMet(atBack, -frontOutwards(backs, at, way, atBack, size));
}

// Of a layer that a corner lacks: each quarter of the cell is flat, as its texel says. least: way through one that counts.
SolidMet inQuarters(vec2 a, vec2 b, vec2 c, vec2 d, vec3 at, vec3 way, float reach, float least, vec3 wall)
{
    float acrossX = way.x != 0.0f ? (0.5f - at.x) / way.x : kNever;
    float acrossY = way.y != 0.0f ? (0.5f - at.y) / way.y : kNever;
    acrossX = acrossX > 0.0f && acrossX < reach ? acrossX : reach;
    acrossY = acrossY > 0.0f && acrossY < reach ? acrossY : reach;
    float begin = 0.0f;
    for (int i = 0; i < 3; ++i) {
        float end = i == 0 ? min(acrossX, acrossY) : i == 1 ? max(acrossX, acrossY) : reach;
        float middle = 0.5f * (begin + end);
        bool right = at.x + middle * way.x >= 0.5f;
        bool low = at.y + middle * way.y >= 0.5f;
        vec2 depths = low ? (right ? d : c) : (right ? b : a);
        if (depths.x <= depths.y && end - begin >= min(least, 0.3f * reach)) {
            float z = at.z + begin * way.z;
            if (z >= depths.x && z <= depths.y)
                return SolidMet(begin, wall);
            float to = (way.z > 0.0f ? depths.x : depths.y) - at.z;
            float s = to / way.z;
            if (way.z != 0.0f && s >= begin && s <= end)
                return SolidMet(s, vec3(0.0f, 0.0f, way.z > 0.0f ? -1.0f : 1.0f));
        }
        begin = end;
        if (i == 0)
            wall = acrossX <= acrossY ? vec3(way.x < 0.0f ? 1.0f : -1.0f, 0.0f, 0.0f) : vec3(0.0f, way.y < 0.0f ? 1.0f : -1.0f, 0.0f);
        else
            wall = acrossX <= acrossY ? vec3(0.0f, way.y < 0.0f ? 1.0f : -1.0f, 0.0f) : vec3(way.x < 0.0f ? 1.0f : -1.0f, 0.0f, 0.0f);
    }
    return SolidMet(kNever, wall);
}

// at: where the ray comes into the cell, x and y from its first corner; reach: how far it goes there; least: as in inQuarters; wall: what it
// came through, outwards.
SolidMet inCell(int axis, ivec2 cell, vec3 at, vec3 way, float reach, float least, vec3 wall)
{
    ivec4 map = objectAxes[axis];
    SolidMet nearest = SolidMet(kNever, wall);
    for (int k = 0; k < map.z; ++k) {
        vec2 a = intervalAt(axis, cell - 1, k);
        vec2 b = intervalAt(axis, ivec2(cell.x, cell.y - 1), k);
        vec2 c = intervalAt(axis, ivec2(cell.x - 1, cell.y), k);
        vec2 d = intervalAt(axis, cell, k);
        bool isHeld = a.x <= a.y && b.x <= b.y && c.x <= c.y && d.x <= d.y;
        SolidMet met = isHeld ? inHeldCell(vec4(a.x, b.x, c.x, d.x), vec4(a.y, b.y, c.y, d.y), at, way, reach, vec2(map.x, map.y), wall)
                              : inQuarters(a, b, c, d, at, way, reach, least, wall);
        if (met.t < nearest.t)
            nearest = met;
    }
    return nearest;
}

// Whether a node of the pyramid may hold solid between two depths of the ray.
bool mayBeIn(int axis, int level, ivec2 node, float begins, float ends)
{
    ivec4 map = objectAxes[axis];
    int across = (map.x >> level) + 1; // nodes: of width + 1 cells
    int first = objectLevels[16 * axis + level] + (node.y * across + node.x) * map.z;
    float least = min(begins, ends) - 1e-6f;
    float most = max(begins, ends) + 1e-6f;
    for (int k = 0; k < map.z; ++k) {
        vec2 bounds = objectTexel(first + k);
        ++objectReads;
        if (bounds.x <= most && bounds.y >= least)
            return true;
    }
    return false;
}

// The first t, not before `from`, at which the ray is within the axis' solid; kNever when it leaves the box before.
SolidMet nextSolid(ObjectRay ray, int axis, float from)
{
    ivec4 map = objectAxes[axis];
    vec3 place = ontoAxis(axis, ray.origin);
    vec3 o = vec3(0.5f * (1.0f + place.x) * float(map.x) + 0.5f, 0.5f * (1.0f + place.y) * float(map.y) + 0.5f, 0.5f + 0.5f * place.z);
    vec3 d = ontoAxis(axis, ray.way) * 0.5f * vec3(float(map.x), float(map.y), 1.0f);
    float x = o.x + from * d.x;
    float y = o.y + from * d.y;
    ivec2 cell = ivec2(int(floor(x)), int(floor(y)));
    cell.x -= d.x < 0.0f && x == floor(x) ? 1 : 0; // begins on the wall and leaves downwards
    cell.y -= d.y < 0.0f && y == floor(y) ? 1 : 0;
    cell = clamp(cell, ivec2(0), ivec2(map.x, map.y));
    int level = objectLevel[axis];
    vec3 wall = vec3(0.0f, 0.0f, d.z < 0.0f ? 1.0f : -1.0f);
    float t = from;
    float least = min(kTouches * float(max(map.x, map.y)) / max(max(abs(d.x), abs(d.y)), 1e-20f), 1e-5f / length(ray.way));
    for (int i = 0; i < kMostNodes; ++i) {
        ivec2 node = ivec2(cell.x >> level, cell.y >> level);
        ivec2 low = ivec2(node.x << level, node.y << level);
        ivec2 high = ivec2(low.x + (1 << level), low.y + (1 << level));
        float exitX = d.x != 0.0f ? (float(d.x > 0.0f ? high.x : low.x) - o.x) / d.x : kNever;
        float exitY = d.y != 0.0f ? (float(d.y > 0.0f ? high.y : low.y) - o.y) / d.y : kNever;
        float leave = max(t, min(min(exitX, exitY), ray.end));
        if (level > 0) {
            if (mayBeIn(axis, level, node, o.z + t * d.z, o.z + leave * d.z)) {
                --level;
                continue;
            }
        } else if (leave - t >= least || leave >= ray.end) {
            vec3 at = vec3(o.x - float(cell.x) + t * d.x, o.y - float(cell.y) + t * d.y, o.z + t * d.z);
            SolidMet met = inCell(axis, cell, at, d, leave - t, least, wall);
            if (met.t < kNever) {
                objectLevel[axis] = 0;
                return SolidMet(t + met.t, met.outwards);
            }
        }
        if (leave >= ray.end)
            break;
        // Into the next node: across the side it leaves by, and along that within the node's.
        bool acrossX = exitX <= exitY;
        int besideX = clamp(int(floor(o.x + leave * d.x)), low.x, high.x - 1);
        int besideY = clamp(int(floor(o.y + leave * d.y)), low.y, high.y - 1);
        cell.x = acrossX ? (d.x > 0.0f ? high.x : low.x - 1) : besideX;
        cell.y = acrossX ? besideY : (d.y > 0.0f ? high.y : low.y - 1);
        if (cell.x < 0 || cell.y < 0 || cell.x > map.x || cell.y > map.y)
            break;
        wall = acrossX ? vec3(d.x < 0.0f ? 1.0f : -1.0f, 0.0f, 0.0f) : vec3(0.0f, d.y < 0.0f ? 1.0f : -1.0f, 0.0f);
        t = leave;
        bool isSibling = (cell.x >> (level + 1)) == (node.x >> 1) && (cell.y >> (level + 1)) == (node.y >> 1);
        level += !isSibling && level < map.w ? 1 : 0;
    }
    objectLevel[axis] = 0;
    return SolidMet(kNever, wall);
}
