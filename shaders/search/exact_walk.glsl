// The exact first hit in single precision: each bilinear cell that the ray crosses is solved as a quadratic. Only views
// against the exact answer use it; the measured reference is the same walk in double precision (core/trace/reference).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// Smallest s in [0, 1] where the ray meets the patch, or 2. f(s) = ray height minus surface height at the cell's entry (f0),
// middle (fm) and exit (f1): three samples fix the quadratic.
float firstRoot(float f0, float fm, float f1)
{
    if (f0 <= 0.0f)
        return 0.0f;
    float a = 2.0f * f0 - 4.0f * fm + 2.0f * f1;
    float b = -3.0f * f0 + 4.0f * fm - f1;
    float discriminant = b * b - 4.0f * a * f0;
    if (discriminant < 0.0f)
        return f1 <= 0.0f ? 1.0f : 2.0f;
    float q = -0.5f * (b + (b < 0.0f ? -sqrt(discriminant) : sqrt(discriminant)));
    float s1 = a != 0.0f ? q / a : 2.0f;
    float s2 = q != 0.0f ? f0 / q : 2.0f;
    float s = 2.0f;
    if (s1 >= 0.0f && s1 <= 1.0f)
        s = s1;
    if (s2 >= 0.0f && s2 <= 1.0f)
        s = min(s, s2);
    return s > 1.0f && f1 <= 0.0f ? 1.0f : s;
}

float bilinear(vec4 h, vec2 f)
{
    float top = h.x * (1.0f - f.x) + h.y * f.x;
    float bottom = h.z * (1.0f - f.x) + h.w * f.x;
    return top * (1.0f - f.y) + bottom * f.y;
}

// Depth t of the first hit; 1 when there is none, also for a ray that crosses more than 65536 cells (about 1024 x 1024 texels at 89.9 degrees).
float exactDepth(Ray ray)
{
    vec2 size = vec2(textureSize(heightMap, 0));
    vec2 start = ray.uv * size - 0.5f;
    vec2 slope = ray.duv * size;
    vec2 cell = floor(start);
    vec2 forward = vec2(slope.x < 0.0f ? 0.0f : 1.0f, slope.y < 0.0f ? 0.0f : 1.0f);
    float enter = 0.0f;
    float crossed = abs(slope.x) + abs(slope.y);
    int cells = crossed < 65536.0f ? int(crossed) + 3 : 65536;
    for (int i = 0; i < cells; ++i) {
        vec2 wall = cell + forward - start;
        float exitX = slope.x != 0.0f ? wall.x / slope.x : 2.0f;
        float exitY = slope.y != 0.0f ? wall.y / slope.y : 2.0f;
        float leave = max(enter, min(min(exitX, exitY), 1.0f));
        float middle = 0.5f * (enter + leave);
        vec4 h = cornersAt(cell);
        vec2 p = start - cell;
        float s = firstRoot(1.0f - enter - bilinear(h, p + slope * enter) + bendFrom(enter).x,
            1.0f - middle - bilinear(h, p + slope * middle) + bendFrom(middle).x,
            1.0f - leave - bilinear(h, p + slope * leave) + bendFrom(leave).x);
        if (s <= 1.0f)
            return enter + s * (leave - enter);
        if (!(leave < 1.0f))
            return 1.0f;
        if (exitX <= exitY)
            cell.x += slope.x < 0.0f ? -1.0f : 1.0f;
        else
            cell.y += slope.y < 0.0f ? -1.0f : 1.0f;
        enter = leave;
    }
    return 1.0f;
}
