// No relief: the surface is the polygon.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    return Hit(ray.uv, 0.0f, true, 0);
}
