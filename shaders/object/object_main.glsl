// Fragment stage of a relief object's box: search, then show. writeView() is the view's: a colour, or a measured value.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 fragment;

void main()
{
    Surface surface;
    surface.toEye = normalize(eye - position);
    float spread = max(length(dFdx(surface.toEye)), length(dFdy(surface.toEye)));
    surface.start = Frame(surfaceNormal, vec3(0.0f), vec3(0.0f));
    surface.frame = surface.start;
    surface.depth = 0.0f; // there is no relief below the box's faces
    surface = searched(surface, spread);
    if (isHole(surface))
        discard;
    vec4 clip = clipFromWorld * vec4(surface.point, 1.0f);
    gl_FragDepth = clamp(0.5f * clip.z / clip.w + 0.5f, 0.0f, 1.0f);
    fragment = vec4(writeView(surface), 1.0f);
}
