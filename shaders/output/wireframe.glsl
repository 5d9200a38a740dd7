// Fragment stage of the wireframe overlay.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 fragment;

void main()
{
    fragment = vec4(1.0f, 0.62f, 0.2f, 0.5f);
}
