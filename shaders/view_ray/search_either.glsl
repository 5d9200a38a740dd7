// In prisms the technique searches, and the exact search after it, to be compared.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool searchesExactly = false;

Hit searchInPrism(Ray ray)
{
    if (!searchesExactly)
        return trace(ray);
    float t = exactDepth(ray);
    return Hit(ray.uv + ray.duv * t, t, t < ray.end || endsOnFloor(ray), 0);
}
