// The surface that a pixel looks at: frame of the texture on the mesh, the search's ray, and where it lands.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 position;
in vec3 surfaceNormal;
in vec2 textureUv;

// The dual of the texture Jacobian: gradU.dPdu = 1, gradU.dPdv = 0 and so on, so that a shift X on the surface is (gradU.X, gradV.X)
// in texture space, also where the texture is stretched, skewed or mirrored. Zero where the UVs are degenerate: relief is flat there.
struct Frame {
    vec3 normal;
    vec3 gradU;
    vec3 gradV;
};
struct Surface {
    Frame start; // where the ray met the polygon
    Frame frame; // where the search landed
    vec3 toEye;
    float depth; // of the relief here, m
    Hit hit; // t is the depth below the surface there
    vec3 point; // of the hit, m
    float footprint; // log2 of the pixel's size in uv, for explicit mip levels
};

Frame frameOf(vec3 normal, vec3 alongU, vec3 alongV)
{
    float area = dot(normal, cross(alongU, alongV));
    float inverse = abs(area) > 1e-20f ? 1.0f / area : 0.0f;
    return Frame(normal, cross(alongV, normal) * inverse, cross(normal, alongU) * inverse);
}

// The search ray that leaves the surface at uv against direction toSource (unit, towards eye or light).
Ray rayInto(Frame frame, vec2 uv, vec3 toSource, float depth)
{
    float cosine = clamp(dot(frame.normal, toSource), 0.002f, 1.0f); // interpolated normals may turn away at the outline
    vec3 travel = toSource * (-depth / cosine);
    return Ray(uv, vec2(dot(travel, frame.gradU), dot(travel, frame.gradV)), cosine, 1.0f);
}

// A pixel's size in uv: the shorter side of its footprint, but at least that share of the longer one which anisotropic filtering has.
float footprintOf(vec2 dx, vec2 dy)
{
    float longer = max(dot(dx, dx), dot(dy, dy));
    float shorter = min(dot(dx, dx), dot(dy, dy));
    return 0.5f * log2(max(max(shorter, longer / (anisotropy * anisotropy)), 1e-20f));
}
