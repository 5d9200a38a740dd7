// Hard self-shadow: the same search, sent from the light to the point seen (Policarpo, Oliveira, Comba 2005, section 3, figure 10).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface)
{
    float cosine = dot(surface.frame.normal, lightDirection);
    if (cosine <= 0.0f)
        return 1.0f - shadowStrength; // the light comes from behind the surface
    Ray ray = rayInto(surface.frame, surface.hit.uv, lightDirection);
    ray.uv -= ray.duv * surface.hit.t; // up to where the light enters the relief
    Hit occluder = trace(ray);
    return occluder.found && occluder.t < surface.hit.t - shadowBias ? 1.0f - shadowStrength : 1.0f;
}
