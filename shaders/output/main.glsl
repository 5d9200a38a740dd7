// Fragment stage of the mesh: search, then show. writeView() is the view's: a colour, or a measured value.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 fragment;

void main()
{
    Surface surface;
    surface.footprint = footprintOf(dFdx(textureUv), dFdy(textureUv)); // before any branch: derivatives are undefined after
    surface.start = textureFrame();
    surface.frame = surface.start;
    surface.toEye = normalize(eye - position);
    startSearch(surface.footprint);
    surface.depth = depthSeen(dot(surface.frame.normal, surface.toEye));
    surface = searched(surface);
    if (isHole(surface))
        discard;
    writeDepth(surface.point);
    fragment = vec4(writeView(surface), 1.0f);
}
