// Frame of the texture from the Jacobian that the vertices carry.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 dPdu;
in vec3 dPdv;

Frame textureFrame()
{
    return frameOf(normalize(gl_FrontFacing ? surfaceNormal : -surfaceNormal), dPdu, dPdv);
}
