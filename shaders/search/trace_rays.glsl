// Runs the search on given rays, one a pixel: rayMap holds (u, v, du, dv), cosineMap the cosine of the view angle.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 hitOut;     // found (-1 where the search gave up), t, u, v
layout(location = 1) out float fetchesOut;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 r = texelFetch(rayMap, pixel, 0);
    Hit hit = trace(Ray(vec2(r.x, r.y), vec2(r.z, r.w), texelFetch(cosineMap, pixel, 0).r, 1.0f));
    hitOut = vec4(gaveUp ? -1.0f : hit.found ? 1.0f : 0.0f, hit.t, hit.uv.x, hit.uv.y);
    fetchesOut = float(hit.fetches);
}
