// Cell cones: one texel for each 2 x 2 cells tells how far a ray may leap from anywhere in them, by boxes and cones of four nested nodes;
// a cell that the ray may touch is solved exactly. Ours; definition and proof in resources/help/cell-cones.md.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/cell_solve.glsl"
#include "search/walk.glsl"

Hit trace(Ray ray)
{
    vec2 size = searchSize();
    vec2 perTexel = 1.0f / size;
    vec2 slope = slopeOf(ray, size);
    vec2 inverse = inverseOf(slope);
    vec2 ahead = vec2(inverse.x < 0.0f ? 0.0f : 1.0f, inverse.y < 0.0f ? 0.0f : 1.0f);
    float texels = max(abs(slope.x), abs(slope.y));
    float past = 1e-5f / max(texels, 1e-3f); // a hundred-thousandth of a texel beyond a wall
    float travel = length(ray.duv);
    if (!(texels < 1e12f)) {
        gaveUp = true;
        return Hit(ray.uv + ray.duv, 1.0f, false, 0);
    }

    // Codes of the texel: each channel is a node's highest point (upper byte) and the steepest rise from it (lower byte).
    vec4 scale = boundScale(); // lowest, range, steepest, highest
    float capUnit = scale.y / 255.0f;
    float steepUnit = travel * scale.z / 65025.0f;
    // The nodes have 2, 8, 32 and 128 cells a side; their walls ahead lie this far from their low corners.
    vec4 acrossX = vec4(2.0f, 8.0f, 32.0f, 128.0f) * ahead.x;
    vec4 acrossY = vec4(2.0f, 8.0f, 32.0f, 128.0f) * ahead.y;
    vec2 border = size * ahead;
    float lowest = 1.0f - ray.end;
    float last = lowest - (past > 1e-5f ? past : 0.0f); // what is beyond the last wall that a nearly vertical ray crosses is looked at too
    Walk walk = walkFrom(ray, slope, size, perTexel, max(1.0f - scale.w + bendFrom(0.0f).x, 0.0f) / (1.0f + bendRise(0.0f)));
    int fetches = 0;
    ivec2 held = ivec2(-1);
    ivec4 codes = ivec4(0);
    int i = 0;
    float z = heightOf(walk);
    int most = kMostRounds / 2; // there are two loops
    while (i < most && z > last) {
        bool mayTouch = false;
        float best = 0.0f;
        float leave = 0.0f;
        // Leaps, until the ray stays in its cell and may touch it. Apart from the solving below, because machines that run many rays
        // in step pay for both.
        while (i < most && z > last) {
            vec2 inside = clamped() ? clamp(walk.cell, vec2(0.0f), size - 1.0f) : walk.cell;
            ivec2 key = ivec2(inside);
            if ((key >> 1) != held) { // else the ray is still over the texel's cells
                held = key >> 1;
                codes = ivec4(cellCodes(held));
                ++fetches;
            }
            float rise = 1.0f + bendRise(1.0f - z); // of the heights against the ray
            vec4 above = (z - scale.x + bendFrom(1.0f - z).x) - vec4(codes >> 8) * capUnit;
            vec4 steep = vec4(codes & ivec4(255));
            vec4 cone = above / (rise + steep * steep * steepUnit);
            vec2 toWall = (ahead - walk.p) * inverse;
            vec2 toBorder = (border - walk.cell - walk.p) * inverse;
            vec2 from = walk.cell - inside + walk.p;
            vec4 wallX = acrossX - vec4(ivec4(key.x) & ivec4(1, 7, 31, 127)); // from the corner of the cell
            vec4 wallY = acrossY - vec4(ivec4(key.y) & ivec4(1, 7, 31, 127));
            vec4 leaveX = (wallX - from.x) * inverse.x;
            vec4 leaveY = (wallY - from.y) * inverse.y;
            if (clamped()) { // a node at a border goes on beyond it
                leaveX = mix(leaveX, vec4(1e30f), vec4(equal(min(wallX + inside.x, vec4(size.x)), vec4(border.x))));
                leaveY = mix(leaveY, vec4(1e30f), vec4(equal(min(wallY + inside.y, vec4(size.y)), vec4(border.y))));
                toBorder = vec2(1e30f);
                // So does a cell whose outer corners are the inner ones.
                toWall.x = (ahead.x > 0.0f ? walk.cell.x >= size.x - 1.0f : walk.cell.x < 0.0f) ? 2.0f : toWall.x;
                toWall.y = (ahead.y > 0.0f ? walk.cell.y >= size.y - 1.0f : walk.cell.y < 0.0f) ? 2.0f : toWall.y;
            }
            vec4 leap = max(min(min(leaveX, leaveY), min(above / rise, min(toBorder.x, toBorder.y))), cone);
            best = max(max(max(leap.x, leap.y), max(leap.z, leap.w)), 0.0f);

            leave = max(min(toWall.x, toWall.y), 0.0f);
            ++i;
            mayTouch = best < leave || best <= 0.0f; // the second: just on a wall it may touch a corner
            if (mayTouch)
                break;
            walk = moved(walk, slope, size, perTexel, best * (1.0f + 2e-7f) + past);
            z = heightOf(walk);
            record(max(max(cone.x, cone.y), max(cone.z, cone.w)) >= best ? kCone : kBox, 1.0f - z);
        }
        float after = z - best;
        if (!mayTouch || after <= last) {
            z = mayTouch ? after : z;
            break;
        }
        ++fetches;
        float s = cellRoot(cornersAt(walk.cell), walk.p + slope * best, slope, after, max(min(leave - best, after - lowest), 0.0f), past);
        if (s <= 1.0f) {
            float t = clamp(1.0f - walk.z + (walk.below + best + s), 0.0f, 1.0f);
            record(kCell, t);
            return Hit(ray.uv + ray.duv * t, t, true, fetches);
        }
        walk = moved(walk, slope, size, perTexel, leave * (1.0f + 2e-7f) + past);
        z = heightOf(walk);
        record(kCell, 1.0f - z);
    }
    gaveUp = z > last;
    return Hit(ray.uv + ray.duv * ray.end, ray.end, endsOnFloor(ray), fetches);
}
