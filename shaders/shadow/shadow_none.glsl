// No self-shadow.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface)
{
    return 1.0f;
}
