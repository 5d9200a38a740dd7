// Maximum mipmaps: down the pyramid where the ray may touch a node, up again where it leaves a parent; the leaf is solved exactly.
// Tevs, Ihrke, Seidel 2008, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering. The finest level is the four
// corners themselves. Levels lie on shelves of one texture (core/maps/acceleration/acceleration_map.h), sized by rounding up.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/cell_solve.glsl"
#include "search/walk.glsl"

Hit trace(Ray ray)
{
    vec2 size = searchSize();
    ivec2 base = boundSize();
    vec2 perTexel = 1.0f / size;
    vec2 slope = slopeOf(ray, size);
    vec2 inverse = inverseOf(slope);
    vec2 ahead = vec2(inverse.x < 0.0f ? 0.0f : 1.0f, inverse.y < 0.0f ? 0.0f : 1.0f);
    float texels = max(abs(slope.x), abs(slope.y));
    float past = 1e-5f / max(texels, 1e-3f); // a hundred-thousandth of a texel beyond a wall
    Hit miss = Hit(ray.uv + ray.duv * ray.end, ray.end, endsOnFloor(ray), 0);
    if (!(texels < 1e12f)) {
        gaveUp = true;
        return Hit(ray.uv + ray.duv, 1.0f, false, 0);
    }

    int top = int(ceil(log2(max(size.x, size.y)) - 1e-4f));
    int level = top;
    int first = searchLevel();
    int shelf = 0; // where the shelf of this level begins
    for (int s = 1; s < first + level; ++s)
        shelf += ((base.y - 1) >> s) + 1;
    float lowest = 1.0f - ray.end;
    float last = lowest - (past > 1e-5f ? past : 0.0f); // what is beyond the last wall that a nearly vertical ray crosses is looked at too
    Walk walk = walkFrom(ray, slope, size, perTexel, 0.0f);
    int fetches = 0;
    for (int i = 0; i < kMostRounds && heightOf(walk) > last; ++i) {
        float z = heightOf(walk);
        vec2 key = clamp(walk.cell, vec2(0.0f), size - 1.0f);
        float span = float(1 << level);
        vec2 node = level > 0 ? floor(key / span) : walk.cell;
        vec2 low = node * span;
        vec2 high = level > 0 ? min(low + span, size) : low + 1.0f;
        vec2 place = walk.cell - low;
        vec2 wall = (high - low) * ahead;
        vec2 toWall = (wall - place - walk.p) * inverse;
        if (clamped()) { // beyond a clamped border the node goes on, and so does a cell whose outer corners are the inner ones
            float inner = level > 0 ? 0.0f : -1.0f;
            if (ahead.x > 0.0f ? high.x >= size.x : low.x <= inner)
                toWall.x = 2.0f;
            if (ahead.y > 0.0f ? high.y >= size.y : low.y <= inner)
                toWall.y = 2.0f;
        }
        float leave = max(min(toWall.x, toWall.y), 0.0f);
        ++fetches;
        if (level > 0) {
            int slot = ((base.x - 1) >> (first + level)) + 1;
            float highest = boundTexel(ivec2((level - 1) * slot + int(node.x), shelf + int(node.y)));
            float least = leastHeight(z, min(leave, z - lowest));
            if (least < highest || (least == highest && leave <= 0.0f)) { // the second: just on a wall it may touch a corner
                highest -= bendLeast(1.0f - z, 1.0f - z + leave);
                walk = moved(walk, slope, size, perTexel, max(z - highest, 0.0f));
                record(kBox, 1.0f - heightOf(walk));
                --level;
                if (level > 0)
                    shelf -= ((base.y - 1) >> (first + level)) + 1;
                continue;
            }
        } else {
            float s = cellRoot(cornersAt(walk.cell), walk.p, slope, z, max(min(leave, z - lowest), 0.0f), past);
            if (s <= 1.0f) {
                float t = clamp(1.0f - walk.z + (walk.below + s), 0.0f, 1.0f);
                record(kCell, t);
                return Hit(ray.uv + ray.duv * t, t, true, fetches);
            }
        }
        vec2 parent = floor(key / (2.0f * span));
        walk = moved(walk, slope, size, perTexel, leave * (1.0f + 2e-7f) + past);
        record(level > 0 ? kBox : kCell, 1.0f - heightOf(walk));
        vec2 entered = floor(clamp(walk.cell, vec2(0.0f), size - 1.0f) / (2.0f * span));
        if (level < top && (entered.x != parent.x || entered.y != parent.y)) {
            if (level > 0)
                shelf += ((base.y - 1) >> (first + level)) + 1;
            ++level;
        }
    }
    gaveUp = heightOf(walk) > last;
    miss.fetches = fetches;
    return miss;
}
