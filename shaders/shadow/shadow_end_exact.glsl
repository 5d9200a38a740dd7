// Where the shadow ray of an exact search ends: before the cell that the point lies in. There the patch is a quadratic along the ray with a root
// at the point, so its slope there tells whether the ray comes to it from above; if it does, nothing else in the cell hides the point.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shadow/light_end.glsl"

// Texels along the ray that are the point's own beyond its cell's wall too: four times what rounding moves it by.
float shadowRoom(vec2 uv)
{
    vec2 place = abs(uv * searchSize());
    return 1e-3f + 2.4e-7f * max(place.x, place.y);
}

// Takes the point's own surroundings off the ray's end: texels along it.
LightEnd endBeforePoint(LightWay way)
{
    Ray ray = way.ray;
    vec2 slope = ray.duv * searchSize();
    float speed = clamp(length(slope), 1e-12f, 1e4f); // texels; of more the room would be lost to rounding
    vec2 uv = ray.uv + ray.duv * ray.end;
    float room = way.atPoint ? shadowRoom(uv) : way.room;
    float without = min(room / speed, ray.end);
    room -= without * speed;
    if (way.atPoint) {
        vec2 place = uv * searchSize() - 0.5f;
        vec2 cell = floor(place);
        vec2 p = place - cell;
        vec4 h = cornersAt(cell);
        float kxy = h.w - h.z - h.y + h.x;
        float sinks = 1.0f - bendFrom(ray.end).y + (h.y - h.x) * slope.x + (h.z - h.x) * slope.y + kxy * (p.x * slope.y + p.y * slope.x);
        if (sinks <= 0.0f) // of the ray against the patch
            return LightEnd(0.0f, room, false);
        vec2 back = (p - vec2(slope.x < 0.0f ? 1.0f : 0.0f, slope.y < 0.0f ? 1.0f : 0.0f)) * inverseOf(slope);
        without = clamp(min(back.x, back.y), without, ray.end);
    }
    return LightEnd(ray.end - without, room, true);
}
