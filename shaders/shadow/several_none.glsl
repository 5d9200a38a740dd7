// No self-shadow, of any of several lights.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface, Light light)
{
    return 1.0f;
}
