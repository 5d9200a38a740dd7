// Looking at a mesh as it is: in each prism of its shell (view_ray/prisms.glsl) the view ray is straight in texture space, and it goes from prism
// to prism, over UV seams too, until it hits the relief or leaves it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "view_ray/prisms.glsl"

const int kMostPrisms = 512; // a bound on what broken meshes cost; whole ones of half a million triangles keep below it
const float kUnfinished = 0.75f; // where a search ends that does not come to the floor
int seenTriangle = 0; // in whose prism the hit lies

// What the pixel sees: fills hit, point, and the frame there.
Surface searched(Surface surface)
{
    vec3 way = -surface.toEye;
    float depth = gl_FrontFacing ? surface.depth : -surface.depth;
    trianglesStart = int(texelFetch(prismMap, 0).x);
    Entry entry = Entry(gl_PrimitiveID + int(firstTriangle), vec3(0.0f));
    float begin = 0.0f; // m along the way, where the ray comes into the prism
    float above = 0.0f; // its depth there
    int fetches = 1;
    surface.hit = Hit(textureUv, 0.0f, false, 0);
    surface.point = position;
    bool isInside = true;
    for (int i = 0; i < kMostPrisms && isInside; ++i) {
        seenTriangle = entry.triangle;
        Prism prism = prismOf(entry.triangle, depth);
        Corner corners[3] = prism.corners;
        if (i == 0)
            entry.weights = weightsAt(position, corners[0].place, corners[1].place, corners[2].place);
        vec2 uv = i == 0 ? textureUv : uvBetween(corners, entry.weights);
        Exit exit = exitFrom(corners, position, way, begin, depth);
        float end = max(exit.way, begin);
        vec2 uvThere = uvBetween(corners, exit.weights);

        float last = exit.side == 3 ? 1.0f : kUnfinished;
        curve = vec3(-above, 1.0f - (exit.below - above) / last, 0.0f);
        Hit hit = trace(Ray(uv, (uvThere - uv) / last, cosineTo(corners, way), last));
        fetches += hit.fetches + 8; // of prismMap
        float share = hit.found ? clamp(hit.t / last, 0.0f, 1.0f) : 1.0f;
        surface.hit = Hit(hit.found ? hit.uv : uvThere, mix(above, exit.below, share), hit.found, fetches);
        surface.point = position + way * mix(begin, end, share);
        surface.frame = frameBetween(prism.vertices, mix(entry.weights, exit.weights, share));
        if (hit.found)
            break;
        entry = beyond(entry.triangle, exit);
        isInside = entry.triangle >= 0;
        begin = end;
        above = exit.below;
    }
    surface.hit.found = isInside; // also where the walk has to end before it has left the relief
    return surface;
}

bool isPastOutline(Surface surface)
{
    return !surface.hit.found;
}
