// Frame of the texture without vertex tangents: the Jacobian of the triangle, solved from the screen's derivatives of position and uv. With
// length, skew and mirroring, which surface/frame_thesis.glsl loses; the smooth normal is the mesh's.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Frame textureFrame()
{
    vec3 px = dFdx(position);
    vec3 py = dFdy(position);
    vec2 tx = dFdx(textureUv);
    vec2 ty = dFdy(textureUv);
    float area = tx.x * ty.y - tx.y * ty.x;
    float inverse = abs(area) > 1e-20f ? 1.0f / area : 0.0f;
    return frameOf(normalize(gl_FrontFacing ? surfaceNormal : -surfaceNormal), (px * ty.y - py * tx.y) * inverse,
        (py * tx.x - px * ty.x) * inverse);
}
