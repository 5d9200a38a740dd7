// Bump mapping: only the normal knows the relief, the search does not move (Blinn 1978, Simulation of Wrinkled Surfaces).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    return Hit(ray.uv, 0.0f, true, 0);
}
