// The light itself, kept beside what is shown of it; alpha tells that there is some, where else the background is shown as it is.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 1) out vec4 lightSeen;

void keepLight(vec3 color)
{
    lightSeen = vec4(clamp(color, vec3(0.0f), vec3(60000.0f)), 1.0f); // what half floats hold
}
