// From a point of the relief towards the light, from prism to prism (view_ray/prisms.glsl), until it leaves the relief. Each passage is searched from
// its far end, as a view ray from there would be.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool isHiddenFrom(int triangle, vec2 uv, float below, vec3 point, vec3 toLight, float floorBelow)
{
    float room = 0.0f;
    Entry entry = Entry(triangle, -1, vec3(0.0f));
    float begin = 0.0f; // m along the way, where the light goes into the prism
    bool atPoint = true;
    for (int i = 0; i < kMostPrisms; ++i) {
        Prism prism = prismOf(entry.triangle, floorBelow);
        if (i > 0)
            uv = uvBetween(prism.corners, entry.weights);
        Exit exit = exitFrom(prism.corners, point, toLight, begin, floorBelow, entry.side);
        if (exit.way > begin) {
            vec2 uvThere = uvBetween(prism.corners, exit.weights);
            float fall = (below - exit.below) / kUnfinished;
            Ray ray = Ray(uvThere, (uv - uvThere) / kUnfinished, cosineTo(prism.corners, toLight), kUnfinished);
            curve = vec3(-exit.below, 1.0f - fall, 0.0f);
            LightEnd end = endBeforePoint(LightWay(ray, fall, atPoint, room));
            ray.end = end.end;
            if (!end.faces || (ray.end > 0.0f && trace(ray).found))
                return true;
            room = end.room;
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
