// Fragment stage of the background: the environment, a little out of focus.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 direction;
layout(location = 0) out vec4 fragment;

void main()
{
    fragment = vec4(shownColor(reflection(normalize(direction), 0.3f) * environmentIntensity, normalize(direction)), 1.0f);
}
