// The exact meeting of a ray with one bilinear cell.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// Smallest s in [0, reach] at which the ray is no longer above the patch, or 2. p: where the ray is in the cell, in texels from corner
// h.x; slope: texels per unit of depth; z: its height. Along the ray the patch is a quadratic, solved without cancellation. The ray may have
// gone by `past` too far, which is not little when it is nearly vertical: then s is negative.
float cellRoot(vec4 h, vec2 p, vec2 slope, float z, float reach, float past)
{
    float kx = h.y - h.x;
    float ky = h.z - h.x;
    float kxy = h.w - h.y - ky;
    vec3 bend = bendFrom(1.0f - z);
    float c = z - (h.x + kx * p.x + ky * p.y + kxy * p.x * p.y) + bend.x;
    if (c <= 0.0f)
        return max(c, -past);
    float b = -1.0f - kx * slope.x - ky * slope.y - kxy * (p.x * slope.y + p.y * slope.x) + bend.y;
    float a = bend.z - kxy * slope.x * slope.y;
    float discriminant = b * b - 4.0f * a * c;
    float s = 2.0f;
    if (discriminant >= 0.0f) {
        float root = sqrt(discriminant);
        float q = -0.5f * (b < 0.0f ? b - root : b + root);
        float s1 = q != 0.0f ? c / q : 2.0f;
        float s2 = a != 0.0f ? q / a : 2.0f;
        if (s1 >= 0.0f && s1 <= reach)
            s = s1;
        if (s2 >= 0.0f && s2 <= reach)
            s = min(s, s2);
    }
    return s > reach && c + reach * (b + reach * a) <= 0.0f ? reach : s; // within rounding of the wall
}
