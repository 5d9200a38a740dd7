// The depth buffer gets the depth of the point seen (Policarpo, Oliveira, Comba 2005, section 4), so that surfaces meet where their relief
// does. Never less than the polygon's, which lets drivers that know conservative depth still reject what is hidden.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#ifdef GL_ARB_conservative_depth
layout(depth_greater) out float gl_FragDepth;
#endif

void writeDepth(vec3 point)
{
    vec4 clip = clipFromWorld * vec4(point, 1.0f);
    gl_FragDepth = max(gl_FragCoord.z, clamp(0.5f * clip.z / clip.w + 0.5f, 0.0f, 1.0f));
}
