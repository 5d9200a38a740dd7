// One directional light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 reflectedLights(Surface surface, ShadingPoint point)
{
    if (dot(point.normal, lightDirection) <= 0.0f)
        return vec3(0.0f);
    return shone(surface, point, lightDirection) * lightColor * (lightIntensity * min(lightReaching(surface), lightPassing(surface)));
}
