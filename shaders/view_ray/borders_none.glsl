// A mesh without borders: the relief goes on wherever a ray leads.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool crossesBorder(vec2 fromUv, vec2 toUv)
{
    return false;
}
