// No shadows between objects.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightPassing(Surface surface)
{
    return 1.0f;
}
