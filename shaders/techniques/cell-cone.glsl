// Cell cones: one texel a cell tells how far a ray may leap from anywhere in it, by boxes and cones of four nested nodes; a cell that
// the ray may touch is solved exactly. Ours; definition and proof in resources/help/cell-cones.md.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "cell_solve.glsl"
#include "walk.glsl"

Hit trace(Ray ray)
{
    vec2 size = searchSize();
    vec2 slope = ray.duv * size;
    vec2 inverse = inverseOf(slope);
    vec2 ahead = vec2(slope.x < 0.0f ? 0.0f : 1.0f, slope.y < 0.0f ? 0.0f : 1.0f);
    float texels = max(abs(slope.x), abs(slope.y));
    float past = 1e-5f / max(texels, 1e-3f); // a hundred-thousandth of a texel beyond a wall
    float travel = length(ray.duv);
    if (!(texels < 1e12f))
        return Hit(ray.uv + ray.duv, 1.0f, false, 0);

    // Codes of the texel: each channel is a node's highest point (upper byte) and the steepest rise from it (lower byte).
    vec4 scale = boundScale(); // lowest, range, steepest, highest
    float capUnit = scale.y / 255.0f;
    float steepUnit = travel * scale.z / 65025.0f;
    // The nodes have 1, 4, 16 and 64 cells a side; their walls ahead lie this far from their low corners.
    vec4 spanX = vec4(1.0f, 4.0f, 16.0f, 64.0f) * ahead.x;
    vec4 spanY = vec4(1.0f, 4.0f, 16.0f, 64.0f) * ahead.y;
    vec2 border = size * ahead;
    float beyond = wrap == 1 ? 2.0f : 0.0f; // beyond a clamped border a node goes on
    float lowest = 1.0f - ray.end;
    Walk walk = walkFrom(ray, slope, size, max(1.0f - scale.w, 0.0f) / (1.0f + bendRise(0.0f)));
    int fetches = 0;
    int i = 0;
    while (i < 65536 && walk.z > lowest) {
        float best = 0.0f;
        float leave = 0.0f;
        // Leaps, until the ray stays in its cell and may touch it. Apart from the solving below, because machines that run many rays
        // in step pay for both.
        while (i < 65536 && walk.z > lowest) {
            ivec2 key = ivec2(clamp(walk.cell, vec2(0.0f), size - 1.0f));
            uvec4 codes = cellCodes(key);
            ++fetches;
            float rise = 1.0f + bendRise(1.0f - walk.z);
            vec4 above = vec4(walk.z - scale.x + bendFrom(1.0f - walk.z).x) - vec4(codes >> 8u) * capUnit;
            vec4 steep = vec4(codes & 255u);
            vec4 cone = above / (rise + steep * steep * steepUnit);
            vec4 wallX = min(vec4(ivec4(key.x) & ivec4(-1, -4, -16, -64)) + spanX, vec4(size.x));
            vec4 wallY = min(vec4(ivec4(key.y) & ivec4(-1, -4, -16, -64)) + spanY, vec4(size.y));
            vec4 leaveX = (wallX - walk.cell.x - walk.p.x) * inverse.x + vec4(equal(wallX, vec4(border.x))) * beyond;
            vec4 leaveY = (wallY - walk.cell.y - walk.p.y) * inverse.y + vec4(equal(wallY, vec4(border.y))) * beyond;
            vec4 leap = max(min(min(leaveX, leaveY), above / rise), cone);
            best = max(max(max(leap.x, leap.y), max(leap.z, leap.w)), 0.0f);

            vec2 toWall = (ahead - walk.p) * inverse;
            leave = max(min(toWall.x, toWall.y), 0.0f);
            ++i;
            if (best < leave)
                break;
            walk = moved(walk, slope, size, best * (1.0f + 2e-7f) + past);
        }
        float z = walk.z - best;
        if (z <= lowest)
            break;
        ++fetches;
        float s = cellRoot(cornersAt(walk.cell), walk.p + slope * best, slope, z, min(leave - best, z - lowest));
        if (s <= 1.0f) {
            float t = min(1.0f - z + s, 1.0f);
            return Hit(ray.uv + ray.duv * t, t, true, fetches);
        }
        walk = moved(walk, slope, size, leave * (1.0f + 2e-7f) + past);
    }
    return Hit(ray.uv + ray.duv * ray.end, ray.end, endsOnFloor(ray), fetches);
}
