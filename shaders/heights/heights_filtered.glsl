// Heights by the texture unit's own filter, at the mip level of this pixel. Fast; its weights may be coarse (1/256 texel) on some GPUs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float heightLevel = 0.0f;

// footprint: log2 of the pixel's size in uv. Whole levels: each is a height field of its own, bilinear like the first.
void startSearch(float footprint)
{
    heightLevel = heightMips ? clamp(floor(footprint + heightMapLevels + 0.5f), 0.0f, heightMapLast) : 0.0f;
}

int searchLevel()
{
    return int(heightLevel);
}

// Not textureSize of the level: some drivers ask for one pixel's level and take it for its neighbours' too.
vec2 searchSize()
{
    return vec2(max(textureSize(heightMap, 0) >> searchLevel(), ivec2(1)));
}

float heightAt(vec2 uv)
{
    return textureLod(heightMap, uv, heightLevel).r;
}
