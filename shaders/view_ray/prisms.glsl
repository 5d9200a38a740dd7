// The relief's shell on the mesh, cut into one prism a triangle (Hirche, Ehlert, Guthe and Doggett 2004, Hardware Accelerated Per-Pixel
// Displacement Mapping): its floor lies a depth below the triangle along the normals of the corners, its walls are its neighbours' too.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// prismMap: where the triangles begin, then five texels a vertex: (position, u), (normal, v), (way out, 0), dPdu, dPdv; then two a triangle:
// its vertices, and the edges across its own, counted as in core/mesh/edges/across.h, -1 for none.
// prismTexel(i) reads it (view_ray/prism_texels_buffer.glsl and its like).
vec4 vertexTexel(float vertex, int i)
{
    return prismTexel(1 + 5 * int(vertex) + i);
}

struct Corner {
    vec3 place; // m
    vec3 inwards; // to the floor, m
    vec2 uv; // in the texture
};

// floorBelow: how far the relief's floor lies below, m; negative where the mesh is seen from its back.
Corner cornerOf(float vertex, float floorBelow)
{
    vec4 place = vertexTexel(vertex, 0);
    vec4 normal = vertexTexel(vertex, 1);
    vec3 push = pushOut != 0.0f ? vec3(vertexTexel(vertex, 2)) * pushOut : vec3(0.0f);
    return Corner(vec3(place) + push, vec3(normal) * -floorBelow, textureFromMesh * vec2(place.w, normal.w) + textureShift);
}

int trianglesStart = 0; // texel; walkPrisms() reads it once

struct Prism {
    vec4 vertices; // of its triangle
    Corner corners[3];
};

Prism prismOf(int triangle, float floorBelow)
{
    Prism prism;
    prism.vertices = prismTexel(trianglesStart + 2 * triangle);
    for (int i = 0; i < 3; ++i)
        prism.corners[i] = cornerOf(prism.vertices[i], floorBelow);
    return prism;
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

// Weights of a triangle's corners at a place in its plane.
vec3 weightsAt(vec3 place, vec3 a, vec3 b, vec3 c)
{
    vec3 up = cross(b - a, c - a);
    float inverse = 1.0f / max(dot(up, up), 1e-30f);
    float atA = dot(cross(c - b, place - b), up) * inverse;
    float atB = dot(cross(a - c, place - c), up) * inverse;
    return vec3(atA, atB, 1.0f - atA - atB);
}

// How a ray leaves a prism. In a prism every slice of one depth is a triangle whose corners move linearly with the depth, so that a wall is bilinear, not
// a plane. The ray passes the edge of a slice where its moment about the edge is zero, and inside of it all three moments have one sign.
struct Exit {
    float way; // m along the ray
    int side; // 0 to 2: the wall of the edge from that corner, 3: floor, 4: top
    float below; // share of the depth there
    vec3 weights; // of the corners there
    float order; // the least counts: the way, and beyond all ways by how much the ray passes the side by
};
const float kNoWay = 1e20f;
const float kPrismSlack = 0.02f; // share of the depth by which a side may lie before the entry
const float kPrismBend = 0.02f; // share of the depth by which a way that is taken for straight may be bent

// off: how far beside the side, in shares of it.
Exit exitBy(int side, float way, float below, vec3 weights, float off, float late)
{
    float wrong = max(off, 1e-3f * (late - 1.0f));
    return Exit(way, side, clamp(below, 0.0f, 1.0f), weights, wrong > 1e-4f ? kNoWay * (1.0f + wrong) : way);
}

Exit firstOf(Exit a, Exit b)
{
    return b.order < a.order ? b : a;
}

// The moment of the edge from corner i about the ray, as a quadratic of the depth: x + y d + z d^2. origin: on the ray.
vec3 edgeMoment(Corner from, Corner to, vec3 origin, vec3 way)
{
    vec3 a = cross(way, from.place - origin);
    vec3 p = cross(way, from.inwards);
    vec3 b = to.place - origin;
    return vec3(dot(a, b), dot(a, to.inwards) + dot(p, b), dot(p, to.inwards));
}

// The depth at which a ray leaves by a wall: of the two roots the one at which the moment rises. Beyond [0, 1] where it does not.
float depthOfLeaving(vec3 moment)
{
    float square = moment.y * moment.y - 4.0f * moment.z * moment.x;
    float root = sqrt(max(square, 0.0f));
    float numerator = moment.y > 0.0f ? -2.0f * moment.x : root - moment.y;
    float denominator = moment.y > 0.0f ? moment.y + root : 2.0f * moment.z;
    return square < 0.0f || denominator == 0.0f ? -kNoWay : numerator / denominator;
}

// Through the wall of the edge from corner i, where the moment leaves.
Exit exitByWall(Corner corners[3], int i, float below, vec3 origin, vec3 way, float begin, float slack)
{
    int j = i == 2 ? 0 : i + 1;
    vec3 from = corners[i].place + corners[i].inwards * below - origin;
    vec3 edge = corners[j].place + corners[j].inwards * below - origin - from;
    float along = dot(edge, way);
    float share = (along * dot(from, way) - dot(from, edge)) / max(dot(edge, edge) - along * along, 1e-30f);
    vec3 weights = vec3(0.0f);
    weights[i] = 1.0f - clamp(share, 0.0f, 1.0f);
    weights[j] = 1.0f - weights[i];
    float late = -(dot(from, way) + along * share) / slack;
    return exitBy(i, begin - late * slack, below, weights, max(abs(share - 0.5f), abs(below - 0.5f)) - 0.5f, late);
}

// Through the slice of depth 0 or 1, whose weights are shares of the moments there.
Exit exitBySlice(Corner corners[3], vec3 moments, float below, vec3 origin, vec3 way, float begin, float slack)
{
    vec3 weights = moments / (moments.x + moments.y + moments.z);
    vec3 place = vec3(0.0f);
    for (int i = 0; i < 3; ++i)
        place += (corners[i].place + corners[i].inwards * below - origin) * weights[i];
    float late = -dot(place, way) / slack;
    return exitBy(below > 0.5f ? 3 : 4, begin - late * slack, below, weights, -min(weights.x, min(weights.y, weights.z)), late);
}

// The side by which a ray leaves that comes in at `begin` by the wall of edge `cameBy` (-1: not by a wall).
Exit exitFrom(Corner corners[3], vec3 start, vec3 way, float begin, float floorBelow, int cameBy)
{
    vec3 origin = start + way * begin;
    float slack = max(kPrismSlack * abs(floorBelow), 1e-12f);
    Exit exit = Exit(begin, 4, 0.0f, vec3(1.0f / 3.0f), 1e38f);
    vec3 atTop = vec3(0.0f);
    vec3 atFloor = vec3(0.0f);
    for (int i = 0; i < 3; ++i) {
        int j = i == 2 ? 0 : i + 1;
        vec3 moment = edgeMoment(corners[i], corners[j], origin, way) * (floorBelow < 0.0f ? -1.0f : 1.0f);
        atTop[j == 2 ? 0 : j + 1] = moment.x;
        atFloor[j == 2 ? 0 : j + 1] = moment.x + moment.y + moment.z;
        float below = depthOfLeaving(moment);
        if (abs(below - 0.5f) < 0.6f) {
            Exit wall = exitByWall(corners, i, below, origin, way, begin, slack);
            if (i != cameBy || wall.way > begin + slack)
                exit = firstOf(exit, wall);
        }
    }
    if (atTop.x + atTop.y + atTop.z > 0.0f) // seen from below
        exit = firstOf(exit, exitBySlice(corners, atTop, 0.0f, origin, way, begin, slack));
    if (atFloor.x + atFloor.y + atFloor.z < 0.0f) // seen from above
        exit = firstOf(exit, exitBySlice(corners, atFloor, 1.0f, origin, way, begin, slack));
    return exit;
}

// Twice the area of the slice at a floorBelow, along its normal.
vec3 sliceNormal(Corner corners[3], float below)
{
    vec3 a = corners[0].place + corners[0].inwards * below;
    return cross(corners[1].place + corners[1].inwards * below - a, corners[2].place + corners[2].inwards * below - a);
}

// Where a ray comes into a prism.
struct Entry {
    int triangle; // -1: there is none
    int side; // the wall that it comes through, -1: none
    vec3 weights; // of the corners there
};

// Of a slice's corners where the ray passes it.
vec3 weightsInSlice(Corner corners[3], float below, vec3 origin, vec3 way)
{
    vec3 moments = vec3(0.0f);
    for (int i = 0; i < 3; ++i) {
        int j = i == 2 ? 0 : i + 1;
        vec3 from = corners[i].place + corners[i].inwards * below - origin;
        moments[j == 2 ? 0 : j + 1] = dot(way, cross(from, corners[j].place + corners[j].inwards * below - origin));
    }
    return moments / (moments.x + moments.y + moments.z);
}

// In texture space the way through a prism is bent. Into how many straight pieces it is cut, so that each is right to a part of the depth.
int piecesOf(Corner corners[3], Entry entry, float above, Exit exit, vec3 origin, vec3 way, float floorBelow)
{
    float middle = 0.5f * (above + exit.below);
    vec3 off = weightsInSlice(corners, middle, origin, way) - 0.5f * (entry.weights + exit.weights);
    vec3 bent = vec3(0.0f);
    for (int i = 0; i < 3; ++i)
        bent += (corners[i].place + corners[i].inwards * middle - origin) * off[i];
    float most = length(bent) / (kPrismBend * abs(floorBelow));
    return abs(exit.below - above) > kPrismBend && most < 1e6f ? int(clamp(ceil(sqrt(most)), 1.0f, 4.0f)) : 1;
}

// The prism beyond the wall that a ray leaves by.
Entry beyond(int triangle, Exit exit)
{
    Entry entry = Entry(-1, -1, vec3(0.0f));
    float across = exit.side < 3 ? prismTexel(trianglesStart + 2 * triangle + 1)[exit.side] : -1.0f;
    if (across >= 0.0f) {
        entry.triangle = int(across) / 3;
        int edge = int(across) - 3 * entry.triangle;
        entry.side = edge;
        entry.weights[edge] = exit.weights[exit.side == 2 ? 0 : exit.side + 1];
        entry.weights[edge == 2 ? 0 : edge + 1] = exit.weights[exit.side];
    }
    return entry;
}

const int kMostPrisms = 512; // a bound on what broken meshes cost; whole ones of half a million triangles keep below it
const float kUnfinished = 0.75f; // where a search ends that does not come to the floor

// Where a ray ends that goes from prism to prism until it hits the relief or leaves it.
struct PrismHit {
    Hit hit; // t is the depth; found also where the walk has to end before the ray has left the relief
    vec3 point; // m
    int triangle; // in whose prism it lies
    vec4 vertices; // of that
    vec3 weights; // of its corners there
};

// Whether a triangle has turned over on its way in to a depth, once, or twice as beyond the middle of a sphere: its area along its normal is a quadratic
// of the depth.
bool isTurned(Corner corners[3], float below)
{
    vec3 up = sliceNormal(corners, 0.0f);
    float whole = dot(up, up);
    float middle = dot(up, sliceNormal(corners, 0.5f * below));
    float end = dot(up, sliceNormal(corners, below));
    float square = 2.0f * (whole + end) - 4.0f * middle; // whole + line s + square s^2 with s from 0 to 1
    float line = end - whole - square;
    float least = square > 0.0f ? clamp(-0.5f * line / square, 0.0f, 1.0f) : 1.0f;
    return min(end, whole + (line + square * least) * least) <= 1e-4f * whole;
}

// A hit between two ways along the ray: where the ray passes the slice of its depth, and nowhere when the relief has turned the triangle over.
PrismHit walkEndsIn(PrismHit walk, Corner corners[3], vec3 start, vec3 way, float begin, float end)
{
    vec3 up = sliceNormal(corners, walk.hit.t);
    float speed = dot(up, way);
    float passes = dot(up, corners[0].place + corners[0].inwards * walk.hit.t - start) / speed;
    bool isSteep = abs(speed) > 1e-6f * length(up); // else the ray lies in the slice
    walk.point = start + way * (isSteep ? clamp(passes, begin, end) : 0.5f * (begin + end));
    walk.hit.found = !isTurned(corners, walk.hit.t);
    return walk;
}

// start: where the ray meets the outer surface of the triangle; way: unit.
PrismHit walkPrisms(int triangle, vec3 start, vec3 way, float floorBelow)
{
    trianglesStart = int(prismTexel(0).x);
    Entry entry = Entry(triangle, -1, vec3(0.0f));
    PrismHit walk = PrismHit(Hit(vec2(0.0f), 0.0f, false, 1), start, triangle, vec4(0.0f), vec3(0.0f));
    float begin = 0.0f; // m along the way, where the ray comes into the prism
    float above = 0.0f; // its depth there
    for (int i = 0; i < kMostPrisms && entry.triangle >= 0; ++i) {
        Prism prism = prismOf(entry.triangle, floorBelow);
        if (i == 0)
            entry.weights = weightsAt(start, prism.corners[0].place, prism.corners[1].place, prism.corners[2].place);
        vec2 uv = uvBetween(prism.corners, entry.weights);
        Exit exit = exitFrom(prism.corners, start, way, begin, floorBelow, entry.side);
        float end = max(exit.way, begin);
        walk.triangle = entry.triangle;
        walk.vertices = prism.vertices;
        walk.hit.fetches += pushOut != 0.0f ? 11 : 8;

        int pieces = piecesOf(prism.corners, entry, above, exit, start + way * begin, way, floorBelow);
        float fall = (exit.below - above) / float(pieces);
        for (int k = 1; k <= pieces; ++k) {
            float below = k == pieces ? exit.below : above + fall;
            vec3 weights = k == pieces ? exit.weights : weightsInSlice(prism.corners, below, start + way * begin, way);
            vec2 uvThere = uvBetween(prism.corners, weights);
            float last = exit.side == 3 && k == pieces ? 1.0f : kUnfinished;
            curve = vec3(-above, 1.0f - (below - above) / last, 0.0f);
            Hit hit = searchInPrism(Ray(uv, (uvThere - uv) / last, cosineTo(prism.corners, way), last));
            float share = hit.found ? clamp(hit.t / last, 0.0f, 1.0f) : 1.0f;
            walk.hit = Hit(hit.found ? hit.uv : uvThere, mix(above, below, share), hit.found, walk.hit.fetches + hit.fetches);
            walk.weights = mix(entry.weights, weights, share);
            if (hit.found)
                return walkEndsIn(walk, prism.corners, start, way, begin, end);
            uv = uvThere;
            entry.weights = weights;
            above = below;
        }
        walk.point = start + way * end;
        entry = beyond(entry.triangle, exit);
        begin = end;
    }
    walk.hit.found = entry.triangle >= 0; // the walk had to end before the ray has left the relief
    return walk;
}
