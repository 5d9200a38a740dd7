// Normals that differ within a pixel do not widen its highlight.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float spreadRoughness(float rough, Surface surface)
{
    return rough;
}
