// Walks given rays through prisms, one a pixel: rayMap holds where it meets the outer surface of a triangle, and the number of that; wayMap its way and
// how far the floor lies below. Towards the light of lightDirection from there it asks for a shadow.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 hitOut; // found, depth, u, v
layout(location = 1) out vec4 pointOut; // x, y, z, and 1 where the light is hidden

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 start = texelFetch(rayMap, pixel, 0);
    vec4 way = texelFetch(wayMap, pixel, 0);
    PrismHit walk = walkPrisms(int(start.w), vec3(start), vec3(way), way.w);
    hitOut = vec4(walk.hit.found ? 1.0f : 0.0f, walk.hit.t, walk.hit.uv.x, walk.hit.uv.y);
    bool hidden = walk.hit.found && isHiddenFrom(walk.triangle, walk.hit.uv, walk.hit.t, walk.point, lightDirection, way.w);
    pointOut = vec4(walk.point, hidden ? 1.0f : 0.0f);
}
