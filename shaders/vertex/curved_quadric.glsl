// The quadric of the surface around a vertex (core/mesh/frames/curvature.h), and what pushing the mesh out makes of it and of the Jacobian.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 6) in vec3 vertexCurvature;
out vec3 curvature;

Placed curved(Placed at)
{
    curvature = (vertexCurvature + at.fall) * at.fallScale;
    float area = dot(at.normal, cross(at.alongU, at.alongV));
    if (pushOut != 0.0f && abs(area) > 1e-20f) {
        vec3 gradU = cross(at.alongV, at.normal) / area;
        vec3 gradV = cross(at.normal, at.alongU) / area;
        vec3 normalU = 2.0f * curvature.x * gradU + curvature.z * gradV;
        vec3 normalV = 2.0f * curvature.y * gradV + curvature.z * gradU;
        curvature += pushOut * vec3(0.5f * dot(normalU, normalU), 0.5f * dot(normalV, normalV), dot(normalU, normalV));
        at.alongU += pushOut * normalU;
        at.alongV += pushOut * normalV;
    }
    return at;
}
