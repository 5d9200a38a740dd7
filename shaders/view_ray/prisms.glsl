// The relief's shell on the mesh, cut into one prism a triangle (Hirche, Ehlert, Guthe and Doggett 2004, Hardware Accelerated Per-Pixel
// Displacement Mapping): its floor lies a depth below the triangle along the normals of the corners, its walls are its neighbours' too.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// prismMap: where the triangles begin, then five texels a vertex: (position, u), (normal, v), (way out, 0), dPdu, dPdv; then two a triangle:
// its vertices, and the edges across its own, counted as in core/mesh/edges/across.h, -1 for none.
vec4 vertexTexel(float vertex, int i)
{
    return texelFetch(prismMap, 1 + 5 * int(vertex) + i);
}

struct Corner {
    vec3 place; // m
    vec3 inwards; // to the floor, m
    vec2 uv; // in the texture
};

// depth: negative where the mesh is seen from its back.
Corner cornerOf(float vertex, float depth)
{
    vec4 place = vertexTexel(vertex, 0);
    vec4 normal = vertexTexel(vertex, 1);
    vec3 push = pushOut != 0.0f ? vertexTexel(vertex, 2).xyz * pushOut : vec3(0.0f);
    return Corner(place.xyz + push, normal.xyz * -depth, textureFromMesh * vec2(place.w, normal.w) + textureShift);
}

int trianglesStart = 0; // texel; searched() reads it once

struct Prism {
    vec4 vertices; // of its triangle
    Corner corners[3];
};

Prism prismOf(int triangle, float depth)
{
    vec4 vertices = texelFetch(prismMap, trianglesStart + 2 * triangle);
    return Prism(vertices, Corner[3](cornerOf(vertices.x, depth), cornerOf(vertices.y, depth), cornerOf(vertices.z, depth)));
}

vec2 uvBetween(Corner corners[3], vec3 weights)
{
    return corners[0].uv * weights.x + corners[1].uv * weights.y + corners[2].uv * weights.z;
}

// |N.V| for the triangle itself and a ray along `way`, as Ray::cosView.
float cosineTo(Corner corners[3], vec3 way)
{
    vec3 up = cross(corners[1].place - corners[0].place, corners[2].place - corners[0].place);
    return clamp(abs(dot(up, way)) * inversesqrt(max(dot(up, up), 1e-30f)), 0.002f, 1.0f);
}

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

// Where on an edge's wall a place lies: share of the way along the edge, and share of the depth.
vec2 onWall(vec3 place, Corner from, Corner to, float depth)
{
    vec3 edge = to.place - from.place;
    vec3 across = place - from.place;
    vec2 found = vec2(0.5f, 0.0f);
    for (int i = 0; i < 3; ++i) { // the way inwards turns along the edge
        vec3 inwards = mix(from.inwards, to.inwards, clamp(found.x, 0.0f, 1.0f));
        inwards *= abs(depth) * inversesqrt(max(dot(inwards, inwards), 1e-30f));
        float ee = dot(edge, edge);
        float ei = dot(edge, inwards);
        float ii = dot(inwards, inwards);
        float ae = dot(across, edge);
        float ai = dot(across, inwards);
        found = vec2(ae * ii - ai * ei, ai * ee - ae * ei) / max(ee * ii - ei * ei, 1e-30f);
    }
    return found;
}

// Weights of a triangle's corners at a place in its plane.
vec3 weightsAt(vec3 place, vec3 a, vec3 b, vec3 c)
{
    vec3 up = cross(b - a, c - a);
    float inverse = 1.0f / max(dot(up, up), 1e-30f);
    float atA = dot(cross(c - b, place - b), up) * inverse;
    float atB = dot(cross(a - c, place - c), up) * inverse;
    return vec3(atA, atB, 1.0f - atA - atB);
}

// How a ray leaves a prism.
struct Exit {
    float way; // m along the ray
    int side; // 0 to 2: the wall of the edge from that corner, 3: floor, 4: top
    float below; // share of the depth there
    vec3 weights; // of the corners there
};

Exit nearer(Exit exit, float since, float rise, float speed, int side)
{
    return speed > 0.0f && rise < exit.way * speed && rise > since * speed ? Exit(rise / speed, side, 0.0f, vec3(0.0f)) : exit;
}

// The plane of a side that the ray crosses first. since: what it crossed before, it was never inside of; without: bits of sides that do not
// count.
Exit nearestSide(Corner corners[3], vec3 start, vec3 way, float since, float depth, int without)
{
    float turn = depth < 0.0f ? -1.0f : 1.0f;
    Exit exit = Exit(1e30f, -1, 0.0f, vec3(0.0f));
    for (int i = 0; i < 3; ++i) {
        Corner from = corners[i];
        Corner to = corners[i == 2 ? 0 : i + 1];
        vec3 outwards = cross(from.inwards + to.inwards, to.place - from.place) * turn;
        if ((without & 1 << i) == 0)
            exit = nearer(exit, since, dot(outwards, from.place - start), dot(outwards, way), i);
    }
    vec3 a = corners[0].place;
    vec3 up = cross(corners[1].place - a, corners[2].place - a) * turn;
    if ((without & 16) == 0)
        exit = nearer(exit, since, dot(up, a - start), dot(up, way), 4);
    a += corners[0].inwards;
    vec3 down = cross(corners[2].place + corners[2].inwards - a, corners[1].place + corners[1].inwards - a) * turn;
    return (without & 8) == 0 ? nearer(exit, since, dot(down, a - start), dot(down, way), 3) : exit;
}

// Where normals lean far over, a prism is folded, and the plane of a side cuts through it where that side is not; then the next one counts.
Exit exitFrom(Corner corners[3], vec3 start, vec3 way, float begin, float depth)
{
    Exit first;
    int without = 0;
    for (int i = 0; i < 5; ++i) {
        Exit exit = nearestSide(corners, start, way, begin - 0.05f * abs(depth), depth, without);
        if (exit.side < 0)
            break;
        vec3 place = start + way * max(exit.way, begin);
        bool isThere;
        if (exit.side < 3) {
            int to = exit.side == 2 ? 0 : exit.side + 1;
            vec2 found = onWall(place, corners[exit.side], corners[to], depth);
            exit.weights[exit.side] = 1.0f - found.x;
            exit.weights[to] = found.x;
            exit.below = clamp(found.y, 0.0f, 1.0f);
            isThere = abs(found.y - 0.5f) < 0.52f;
        } else {
            exit.below = exit.side == 3 ? 1.0f : 0.0f;
            exit.weights = weightsAt(place, corners[0].place + exit.below * corners[0].inwards,
                corners[1].place + exit.below * corners[1].inwards, corners[2].place + exit.below * corners[2].inwards);
            isThere = min(exit.weights.x, min(exit.weights.y, exit.weights.z)) > -0.25f;
        }
        if (isThere)
            return exit;
        if (i == 0)
            first = exit;
        without |= 1 << exit.side;
    }
    return without == 0 ? Exit(begin, 4, 0.0f, vec3(1.0f / 3.0f)) : first;
}

// Where a ray comes into a prism.
struct Entry {
    int triangle; // -1: there is none
    vec3 weights; // of the corners there
};

// The prism beyond the wall that a ray leaves by.
Entry beyond(int triangle, Exit exit)
{
    Entry entry = Entry(-1, vec3(0.0f));
    float across = exit.side < 3 ? texelFetch(prismMap, trianglesStart + 2 * triangle + 1)[exit.side] : -1.0f;
    if (across >= 0.0f) {
        entry.triangle = int(across) / 3;
        int edge = int(across) - 3 * entry.triangle;
        entry.weights[edge] = exit.weights[exit.side == 2 ? 0 : exit.side + 1];
        entry.weights[edge == 2 ? 0 : edge + 1] = exit.weights[exit.side];
    }
    return entry;
}
