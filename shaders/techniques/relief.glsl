// Relief mapping: linear search for the first sample inside the relief, then bisection of that step.
// Policarpo, Oliveira, Comba 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, section 3. The step count follows
// the angle as there ("delta varies from fragment to fragment as function of the angle between VD' and the normal").
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv + ray.duv, 1.0f, false, 0);

    // Steeper views cross less of the map and need fewer steps. Written so that equal limits give exactly that many.
    int steps = int(ceil(float(maxSteps) + float(minSteps - maxSteps) * ray.cosView));
    float outside = 0.0f;
    float inside = 1.0f;
    for (int i = 1; i <= steps && !hit.found; ++i) {
        float t = float(i) / float(steps); // not a running sum: that would miss the floor
        ++hit.fetches;
        if (1.0f - heightAt(ray.uv + ray.duv * t) <= t) {
            hit.found = true;
            inside = t;
        } else {
            outside = t;
        }
    }
    if (!hit.found)
        return hit;

    for (int i = 0; i < refineSteps; ++i) {
        float middle = 0.5f * (outside + inside);
        ++hit.fetches;
        if (1.0f - heightAt(ray.uv + ray.duv * middle) <= middle)
            inside = middle;
        else
            outside = middle;
    }

    hit.t = inside;
    hit.uv = ray.uv + ray.duv * inside;
    return hit;
}
