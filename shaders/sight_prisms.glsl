// Looking at a mesh as it is: in each prism of its shell (prisms.glsl) the ray of sight is straight in texture space, and it goes from prism
// to prism, over UV seams too, until it hits the relief or leaves it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "curved_rays.glsl"
#include "prisms.glsl"

const int kMostPrisms = 96;
const float kUnfinished = 0.75f; // where a search ends that does not come to the floor

// What the pixel sees: fills hit, point, and the frame there.
Surface seen(Surface surface)
{
    vec3 way = -surface.toEye;
    float depth = gl_FrontFacing ? surface.depth : -surface.depth;
    int triangles = int(texelFetch(prismMap, 0).x);
    int triangle = gl_PrimitiveID + int(firstTriangle);
    float begin = 0.0f; // m along the way, where the ray comes into the prism
    float above = 0.0f; // its depth there
    vec3 weights = vec3(0.0f); // of the corners there
    int fetches = 0;
    surface.hit = Hit(textureUv, 0.0f, false, 0);
    surface.point = position;
    for (int i = 0; i < kMostPrisms; ++i) {
        vec4 vertices = texelFetch(prismMap, triangles + 2 * triangle);
        Corner corners[3] = Corner[3](cornerOf(vertices.x, depth), cornerOf(vertices.y, depth), cornerOf(vertices.z, depth));
        if (i == 0)
            weights = weightsAt(position, corners[0].place, corners[1].place, corners[2].place);
        vec2 uv = i == 0 ? textureUv : corners[0].uv * weights.x + corners[1].uv * weights.y + corners[2].uv * weights.z;

        Exit exit = exitFrom(corners, position, way, begin, depth);
        float end = max(exit.way, begin);
        int from = exit.side;
        int to = from == 2 ? 0 : from + 1;
        float below = exit.below;
        vec3 ahead = exit.weights;
        vec2 uvThere = corners[0].uv * ahead.x + corners[1].uv * ahead.y + corners[2].uv * ahead.z;

        float last = exit.side == 3 ? 1.0f : kUnfinished;
        vec3 up = cross(corners[1].place - corners[0].place, corners[2].place - corners[0].place);
        float cosView = abs(dot(up, way)) * inversesqrt(max(dot(up, up), 1e-30f));
        curve = vec3(-above, 1.0f - (below - above) / last, 0.0f);
        Hit hit = trace(Ray(uv, (uvThere - uv) / last, clamp(cosView, 0.002f, 1.0f), last));
        fetches += hit.fetches + 8; // of prismMap
        float share = hit.found ? clamp(hit.t / last, 0.0f, 1.0f) : 1.0f;
        surface.hit = Hit(hit.found ? hit.uv : uvThere, mix(above, below, share), hit.found, fetches);
        surface.point = position + way * mix(begin, end, share);
        surface.frame = frameBetween(vertices, mix(weights, ahead, share));
        float across = exit.side < 3 ? texelFetch(prismMap, triangles + 2 * triangle + 1)[from] : -1.0f;
        if (hit.found || across < 0.0f)
            break;
        triangle = int(across) / 3;
        int edge = int(across) - 3 * triangle;
        weights = vec3(0.0f);
        weights[edge] = ahead[to];
        weights[edge == 2 ? 0 : edge + 1] = ahead[from];
        begin = end;
        above = below;
    }
    return surface;
}

bool isPastOutline(Surface surface)
{
    return !surface.hit.found;
}
