// As Godot 4 draws a StandardMaterial3D without deep parallax: one step, uv - V.xy (1 - h) heightmap_scale / 100, not divided by V.z.
// Godot 4.6, run.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    float t = (1.0f - heightAt(ray.uv)) * ray.cosView;
    record(kOffset, t);
    return Hit(ray.uv + ray.duv * t, t, true, 1);
}
