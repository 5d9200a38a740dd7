// A search on a curved surface. Over a quadric a straight ray is a parabola in texture space (Oliveira and Policarpo 2005, An Efficient
// Representation for Surface Details): at t its depth is t - bend(t). The searches keep their straight ray and see the heights fall by
// bend(t) instead, so that a search that is exact, or safe, stays so.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 curve = vec3(0.0f); // bend(t) = curve.x + curve.y t + curve.z t^2

// bend at t, and what it is going on from there: bend(t + s) = x + y s + z s^2.
vec3 bendFrom(float t)
{
    return vec3(curve.x + (curve.y + curve.z * t) * t, curve.y + 2.0f * curve.z * t, curve.z);
}

// The fastest that heights rise by the bend, per t, from t to the end.
float bendRise(float t)
{
    return max(0.0f, -curve.y - 2.0f * curve.z * (curve.z > 0.0f ? t : 1.0f));
}

// The least bend between two t.
float bendLeast(float from, float to)
{
    float least = min(bendFrom(from).x, bendFrom(to).x);
    return curve.z > 0.0f ? min(least, bendFrom(clamp(-0.5f * curve.y / curve.z, from, to)).x) : least;
}

// The least height of the ray against the heights, from where it has z without the bend to `ahead` further on.
float leastHeight(float z, float ahead)
{
    float from = 1.0f - z;
    float least = min(z + bendFrom(from).x, z - ahead + bendFrom(from + ahead).x);
    float turn = curve.z > 0.0f ? clamp(0.5f * (1.0f - curve.y) / curve.z, from, from + ahead) : from;
    return min(least, 1.0f - turn + bendFrom(turn).x);
}

// The fastest that the ray's depth changes, per t.
float depthRate()
{
    return max(abs(1.0f - curve.y), abs(1.0f - curve.y - 2.0f * curve.z));
}

// Whether the ray ends on the relief's floor: not when its end is short of it, nor when it bends out of the relief again.
bool endsOnFloor(Ray ray)
{
    return ray.end >= 1.0f && curve.x + curve.y + curve.z < 0.5f;
}
