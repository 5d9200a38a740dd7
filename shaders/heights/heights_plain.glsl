// Heights of the finest level by the texture unit's own filter, for exported shaders.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "heights/level_base.glsl"

const float heightLevel = 0.0f;

void startSearch(float footprint)
{
}

float heightAt(vec2 uv)
{
    return textureLod(heightMap, uv, 0.0f).r;
}
