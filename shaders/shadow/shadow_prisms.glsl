// Self-shadow on a mesh as it is: from the point seen the light is followed from prism to prism (view_ray/prisms.glsl) until it leaves the relief. Each
// passage is searched from its far end, as a view ray from there would be.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool lightIsHidden(Surface surface, vec3 toLight)
{
    float depth = gl_FrontFacing ? surface.depth : -surface.depth;
    float room = shadowRoom(surface.hit.uv);
    Entry entry = Entry(seenTriangle, vec3(0.0f));
    float begin = 0.0f; // m along the way, where the light goes into the prism
    float below = surface.hit.t; // its depth there
    bool atPoint = true;
    for (int i = 0; i < kMostPrisms; ++i) {
        Corner corners[3] = prismOf(entry.triangle, depth).corners;
        vec2 uv = i == 0 ? surface.hit.uv : uvBetween(corners, entry.weights);
        Exit exit = exitFrom(corners, surface.point, toLight, begin, depth);
        if (exit.way > begin) {
            vec2 uvThere = uvBetween(corners, exit.weights);
            float fall = (below - exit.below) / kUnfinished;
            Ray ray = Ray(uvThere, (uv - uvThere) / kUnfinished, cosineTo(corners, toLight), kUnfinished);
            curve = vec3(-exit.below, 1.0f - fall, 0.0f);
            if (!endsBeforePoint(ray, room, fall, atPoint) || (ray.end > 0.0f && trace(ray).found))
                return true;
            atPoint = false;
        }
        entry = beyond(entry.triangle, exit);
        if (entry.triangle < 0)
            return exit.side == 3; // through the floor: the light comes from behind
        begin = max(exit.way, begin);
        below = exit.below;
    }
    return false; // nothing hid it on the way that was walked
}
