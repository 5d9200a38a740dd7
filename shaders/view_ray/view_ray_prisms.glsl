// Looking at a mesh as it is: in each prism of its shell (view_ray/prisms.glsl) the view ray is straight in texture space, and it goes from prism
// to prism, over UV seams too, until it hits the relief or leaves it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "view_ray/prism_texels_buffer.glsl"

#include "view_ray/prisms.glsl"

int seenTriangle = 0; // in whose prism the hit lies

// The frame of the texture between a triangle's corners.
Frame frameBetween(vec4 vertices, vec3 weights)
{
    vec3 normal = vec3(0.0f);
    vec3 alongU = vec3(0.0f);
    vec3 alongV = vec3(0.0f);
    for (int i = 0; i < 3; ++i) {
        normal += vertexTexel(vertices[i], 1).xyz * weights[i];
        alongU += vertexTexel(vertices[i], 3).xyz * weights[i];
        alongV += vertexTexel(vertices[i], 4).xyz * weights[i];
    }
    float size = length(normal);
    normal = size > 0.0f ? normal / size : vec3(0.0f, 1.0f, 0.0f); // corners that oppose each other leave none
    return frameOf(gl_FrontFacing ? normal : -normal, alongU * meshFromTexture[0][0] + alongV * meshFromTexture[0][1],
        alongU * meshFromTexture[1][0] + alongV * meshFromTexture[1][1]);
}

PrismHit walkFromPixel(Surface surface)
{
    float floorBelow = gl_FrontFacing ? surface.depth : -surface.depth;
    return walkPrisms(gl_PrimitiveID + int(firstTriangle), position, -surface.toEye, floorBelow);
}

// What the pixel sees: fills hit, point, and the frame there.
Surface searched(Surface surface)
{
    PrismHit walk = walkFromPixel(surface);
    seenTriangle = walk.triangle;
    surface.hit = walk.hit;
    surface.point = walk.point;
    surface.frame = frameBetween(walk.vertices, walk.weights);
    return surface;
}

bool isPastOutline(Hit hit)
{
    return !hit.found;
}
