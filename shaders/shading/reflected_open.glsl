// Reflections of the surroundings are not hidden by the relief.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float reflectedShare(Sky sky, float nv, float rough)
{
    return 1.0f;
}
