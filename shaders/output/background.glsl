// Fragment stage of the background: the environment, as far out of focus as a surface of that roughness mirrors it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 direction;
layout(location = 0) out vec4 fragment;

void main()
{
    fragment = vec4(shownColor(reflection(normalize(direction), backgroundBlur) * environmentIntensity, normalize(direction)), 1.0f);
}
