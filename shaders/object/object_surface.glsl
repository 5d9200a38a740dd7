// Looking at a relief object: the box's far faces are drawn, so that it is seen from inside as well, and the ray to them is searched from
// where it enters the box, or from the eye in it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 boxPlace(vec3 point)
{
    return vec3(boxFromWorld * vec4(point, 1.0f));
}

vec3 boxWay(vec3 way)
{
    return vec3(boxFromWorld * vec4(way, 0.0f));
}

// The unit way in the world along which u, v or the depth of an axis grows.
vec3 worldAxis(int axis, vec3 along)
{
    return normalize(vec3(worldFromBox * vec4(fromAxis(axis, along), 0.0f)));
}

// How far it is from a place in the box to its border, along a way by the box: for each axis.
vec3 borderAlong(vec3 place, vec3 way)
{
    return vec3(way.x != 0.0f ? ((way.x > 0.0f ? 1.0f : -1.0f) - place.x) / way.x : kNever,
        way.y != 0.0f ? ((way.y > 0.0f ? 1.0f : -1.0f) - place.y) / way.y : kNever,
        way.z != 0.0f ? ((way.z > 0.0f ? 1.0f : -1.0f) - place.z) / way.z : kNever);
}

// The side that sees the point best: one that faces its surface, and on which nothing lies before it.
int sideSeeing(vec3 point, vec3 normal)
{
    int best = 0;
    float most = -10.0f;
    for (int axis = 0; axis < 3; ++axis) {
        ivec4 map = objectAxes[axis];
        if (map.x <= 0)
            continue;
        vec3 place = ontoAxis(axis, point) * 0.5f + 0.5f;
        ivec2 texel = ivec2(int(floor(place.x * float(map.x))), int(floor(place.y * float(map.y))));
        float front = 1.0f;
        float back = 0.0f;
        for (int k = 0; k < map.z; ++k) {
            vec2 solid = intervalAt(axis, texel, k);
            if (solid.x <= solid.y) {
                front = min(front, solid.x);
                back = max(back, solid.y);
            }
        }
        float facing = -dot(normal, worldAxis(axis, vec3(0.0f, 0.0f, 1.0f)));
        float room = 2.0f / float(min(map.x, map.y)); // what a slope makes of a texel, and some
        float atFront = facing - (place.z > front + room ? 2.0f : 0.0f);
        float atBack = -facing - (place.z < back - room ? 2.0f : 0.0f);
        if (atFront > most) {
            most = atFront;
            best = 2 * axis;
        }
        if (atBack > most) {
            most = atBack;
            best = 2 * axis + 1;
        }
    }
    return best;
}

// The normal of the side's picture, of so many times the slope.
vec3 pictureNormal(vec2 uv, float footprint, float strength)
{
    int axis = seenSide / 2;
    vec3 n = normalAt(uv, footprint) * 2.0f - 1.0f;
    vec3 inwards = worldAxis(axis, vec3(0.0f, 0.0f, 1.0f));
    vec3 along = worldAxis(axis, vec3(1.0f, 0.0f, 0.0f)) * n.x - worldAxis(axis, vec3(0.0f, 1.0f, 0.0f)) * n.y;
    return normalize((seenSide == 2 * axis ? -inwards : inwards) * max(n.z, 1e-3f) + along * strength);
}

vec3 reliefNormal(Surface surface)
{
    return normalStrength == 1.0f ? surface.frame.normal : pictureNormal(surface.hit.uv, surface.footprint, normalStrength);
}

// What the pixel sees: fills hit, point, and the frame there. spread: of a pixel, at 1 m.
Surface searched(Surface surface, float spread)
{
    vec3 way = boxWay(-surface.toEye);
    vec3 end = boxPlace(position);
    vec3 back = borderAlong(end, -way);
    float whole = min(back.x, min(back.y, back.z));
    float reach = max(min(whole, distance(position, eye)), 0.0f);
    vec3 start = clamp(end - way * reach, -1.0f, 1.0f);
    ObjectHit found = traceObject(ObjectRay(start, way, 0.0f, reach));
    if (dot(found.outwards, found.outwards) == 0.0f) // on the box itself, or around the eye
        found.outwards = reach < whole ? -way
            : back.x <= whole          ? vec3(way.x > 0.0f ? -1.0f : 1.0f, 0.0f, 0.0f)
            : back.y <= whole          ? vec3(0.0f, way.y > 0.0f ? -1.0f : 1.0f, 0.0f)
                                       : vec3(0.0f, 0.0f, way.z > 0.0f ? -1.0f : 1.0f);
    surface.point = position + surface.toEye * (reach - found.t);
    vec3 place = start + way * found.t;
    vec3 outwards = normalize(vec3(vec4(found.outwards, 0.0f) * boxFromWorld));
    seenSide = sideSeeing(place, outwards);
    int axis = seenSide / 2;
    vec3 onSide = ontoAxis(axis, place) * 0.5f + 0.5f;
    float across = length(vec3(worldFromBox * vec4(fromAxis(axis, vec3(2.0f, 0.0f, 0.0f)), 0.0f))); // m
    float down = length(vec3(worldFromBox * vec4(fromAxis(axis, vec3(0.0f, 2.0f, 0.0f)), 0.0f)));
    surface.frame.gradU = worldAxis(axis, vec3(1.0f, 0.0f, 0.0f)) / across;
    surface.frame.gradV = worldAxis(axis, vec3(0.0f, 1.0f, 0.0f)) / down;
    surface.footprint = log2(max(spread * distance(surface.point, eye) / max(across, down), 1e-10f));
    bool isFront = seenSide == 2 * axis;
    surface.hit = Hit(vec2(onSide.x, onSide.y), isFront ? onSide.z : 1.0f - onSide.z, found.found, found.fetches);
    // Walls between texels are the maps', not the surface's.
    vec3 smoothly = pictureNormal(surface.hit.uv, surface.footprint, 1.0f);
    surface.frame.normal = dot(smoothly, surface.toEye) > -0.2f ? smoothly : outwards;
    return surface;
}

bool isPastOutline(Hit hit)
{
    return !hit.found;
}
