// The tile repeats.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool clamped()
{
    return false;
}
