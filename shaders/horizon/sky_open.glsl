// The open part of the sky over a surface with some normal: above the horizons all around, and above the surface itself. Integrals of the cosine
// to the normal over the elevations of each azimuth, in closed form (Max 1988; with the normal: Jimenez et al. 2016, Practical Real-Time
// Strategies for Accurate Indirect Occlusion), so exact but for what changes between two azimuths.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "horizon/sky.glsl"
#include "horizon/horizons.glsl"

Sky openSky(Surface surface, vec3 normal)
{
    Frame frame = surface.frame;
    float area = dot(frame.normal, cross(frame.gradU, frame.gradV));
    if (!(abs(area) > 1e-20f))
        return Sky(1.0f, normal);
    vec3 alongU = cross(frame.gradV, frame.normal) / area; // m per uv
    vec3 alongV = cross(frame.normal, frame.gradU) / area;
    float up = max(dot(normal, frame.normal), 0.001f);
    int count = azimuthCount();
    float turn = 6.2831853f / float(count);
    mat2 next = mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
    vec2 azimuth = vec2(1.0f, 0.0f);
    float open = 0.0f;
    float whole = 0.0f;
    vec3 towards = vec3(0.0f);
    vec4 slopes = vec4(0.0f);
    for (int i = 0; i < count; ++i) {
        if (i % 4 == 0)
            slopes = slopesOf(horizonTexel(surface, i / 4));
        vec3 way = alongU * azimuth.x + alongV * azimuth.y;
        float size = length(way);
        way = way / size;
        float weight = 1.0f / (size * size); // the angle that the azimuth stands for, where the texture is stretched
        float across = dot(normal, way);
        float tangent = max(slopes[i % 4] * surface.depth / size, -across / up);
        float c = inversesqrt(1.0f + tangent * tangent); // cosine and sine of the elevation from where on it is open
        float s = tangent * c;
        open += weight * (across * (acos(s) - c * s) + up * c * c);
        towards += weight * (way * (across * (2.0f - s * (3.0f - s * s)) + up * c * c * c)
            + frame.normal * (across * c * c * c + up * (1.0f - s * s * s)));
        whole += weight;
        azimuth = next * azimuth;
    }
    float far = length(towards);
    return Sky(clamp(open / whole, 0.0f, 1.0f), far > 1e-6f * whole ? towards / far : normal);
}
