// Sphere tracing in a volume of distances: each step is as long as the empty ball around the point allows.
// Donnelly 2005, Per-Pixel Displacement Mapping with Distance Functions (GPU Gems 2, chapter 8). The volume's metric counts a unit of
// depth as a quarter of a tile (core/maps/acceleration/distance.h), so any depth of relief is right without a new volume.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    float speed = sqrt(dot(ray.duv, ray.duv) + 0.0625f * depthRate() * depthRate()); // of the ray in that metric
    vec3 voxels = volumeVoxels();
    float tooLong = safeBalls ? 0.5f * length(vec3(1.0f / voxels.x, 1.0f / voxels.y, 0.25f / voxels.z)) : 0.0f;
    float t = 0.0f;
    int leaps = 0;
    while (leaps < leapSteps && t < ray.end) {
        vec2 uv = ray.uv + ray.duv * t;
        float root = distanceAt(vec3(uv.x, uv.y, t - bendFrom(t).x));
        ++leaps;
        recordRead(kBall);
        float leap = (root * root * boundScale().x - tooLong) / speed;
        if (!(leap > 1e-5f))
            break;
        t += leap;
        record(kBall, min(t, ray.end));
    }
    bool through = t >= ray.end;
    t = min(t, ray.end);
    return Hit(ray.uv + ray.duv * t, t, !through || endsOnFloor(ray), leaps);
}
