// The height that a search compares its ray with at t.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float heightOn(Ray ray, float t)
{
    return heightAt(ray.uv + ray.duv * t) - bendFrom(t).x;
}
