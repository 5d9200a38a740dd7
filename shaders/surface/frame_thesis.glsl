// Frame of the texture as the thesis on derivative-based relief mapping has it (section on texture coordinate derivatives, and its
// appendix): unit vectors along the screen's derivatives of position, taken for a right-angled pair. Where the picture of the surface is
// skewed they are not, and the relief slides; to be compared with surface/frame_derivatives.glsl.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Frame textureFrame()
{
    vec3 px = dFdx(position);
    vec3 py = dFdy(position);
    float lengthX = max(length(px), 1e-20f);
    float lengthY = max(length(py), 1e-20f);
    vec2 tx = dFdx(textureUv) / lengthX;
    vec2 ty = dFdy(textureUv) / lengthY;
    vec3 t = px / lengthX;
    vec3 b = py / lengthY;
    return Frame(normalize(gl_FrontFacing ? surfaceNormal : -surfaceNormal), t * tx.x + b * ty.x, t * tx.y + b * ty.y);
}
