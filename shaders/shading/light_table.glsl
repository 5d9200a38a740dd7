// Where several lights are, or one that is near: what comes of each to a point, told by a table (core/shader_text/scene_uniforms.cpp).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Light {
    vec3 toLight; // unit
    vec3 arriving; // irradiance over pi where a surface faces it and nothing hides it
    float whole; // all channels of it, where no cone cuts it off
    float radius; // of its disc as seen from the point, at distance 1
    bool casts; // shadows of the relief on itself
    bool passes; // it is the light of the shadow map
};

Light lightAt(int number, vec3 point)
{
    mat4 told = lights[number];
    vec3 way = vec3(told[0]) - point * told[0].w; // w: whether it is near
    float squared = dot(way, way);
    vec3 toLight = way * inversesqrt(max(squared, 1e-30f));
    squared = max(squared, told[3].y); // it has some size
    float within = clamp((told[2].w - dot(toLight, vec3(told[2]))) * told[3].x, 0.0f, 1.0f); // the cone, 1 where it does not fade
    vec3 whole = vec3(told[1]) / squared;
    vec3 arriving = whole * (within * within * (3.0f - 2.0f * within));
    return Light(toLight, arriving, whole.r + whole.g + whole.b, told[1].w * inversesqrt(squared), told[3].z > 0.0f, told[3].w > 0.0f);
}
