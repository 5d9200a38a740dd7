// The surface that a pixel looks at: frame of the texture on the mesh, the search's ray, and the maps where it lands.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 position;
in vec3 surfaceNormal;
in vec2 textureUv;
in vec3 dPdu;
in vec3 dPdv;

// The dual of the texture Jacobian: gradU.dPdu = 1, gradU.dPdv = 0 and so on, so that a shift X on the surface is (gradU.X, gradV.X)
// in texture space, also where the texture is stretched, skewed or mirrored. Zero where the UVs are degenerate: relief is flat there.
struct Frame {
    vec3 normal;
    vec3 gradU;
    vec3 gradV;
};
struct Surface {
    Frame frame;
    vec3 toEye;
    Hit hit;
    float footprint; // log2 of the pixel's size in uv, for explicit mip levels
};

Frame textureFrame()
{
    Frame frame;
    frame.normal = normalize(gl_FrontFacing ? surfaceNormal : -surfaceNormal);
    float area = dot(frame.normal, cross(dPdu, dPdv));
    float inverse = abs(area) > 1e-20f ? 1.0f / area : 0.0f;
    frame.gradU = cross(dPdv, frame.normal) * inverse;
    frame.gradV = cross(frame.normal, dPdu) * inverse;
    return frame;
}

// The search ray that leaves the surface at uv against direction toSource (unit, towards eye or light).
Ray rayInto(Frame frame, vec2 uv, vec3 toSource)
{
    float cosine = clamp(dot(frame.normal, toSource), 0.002f, 1.0f); // interpolated normals may turn away at the outline
    vec3 travel = toSource * (-reliefDepth / cosine);
    return Ray(uv, vec2(dot(travel, frame.gradU), dot(travel, frame.gradV)), cosine, 1.0f);
}

// A pixel's size in uv: the shorter side of its footprint, but at least a quarter of the longer one (as 4 x anisotropy would).
float footprintOf(vec2 dx, vec2 dy)
{
    float longer = max(dot(dx, dx), dot(dy, dy));
    float shorter = min(dot(dx, dx), dot(dy, dy));
    return 0.5f * log2(max(max(shorter, longer * 0.0625f), 1e-20f));
}
