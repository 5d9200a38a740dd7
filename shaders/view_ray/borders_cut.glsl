// Borders of the relief (core/mesh/edges/borders.h): a ray that crosses one on its way leaves the relief there. The buffer holds first and count
// for each triangle, then the segments, with the surface on their left.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float turnOf(vec2 a, vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

// Whether the way from one place to another in texture space ends outside: it went out more often than it came in again.
bool crossesBorder(vec2 fromUv, vec2 toUv)
{
    vec2 way = meshFromTexture * (toUv - fromUv);
    vec2 from = meshFromTexture * (fromUv - textureShift) - 1e-3f * way; // a pixel on the border itself is inside
    way *= 1.001f;
    vec4 list = texelFetch(borderMap, gl_PrimitiveID + int(firstTriangle));
    int outwards = 0;
    for (int i = 0; i < int(list.y); ++i) {
        vec4 ends = texelFetch(borderMap, int(list.x) + i);
        vec2 start = vec2(ends.x, ends.y) - from;
        vec2 along = vec2(ends.z, ends.w) - from - start;
        bool startLeft = turnOf(way, start) > 0.0f;
        bool endLeft = turnOf(way, start + along) > 0.0f;
        bool leaves = turnOf(along, -start) > 0.0f;
        bool inside = turnOf(along, way - start) > 0.0f;
        if (startLeft != endLeft && leaves != inside)
            outwards += leaves ? 1 : -1;
    }
    return outwards > 0;
}
