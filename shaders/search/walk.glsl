// A ray on its way over the cells of a height field. Where it is counts from the cell's corner and its height is counted down, so that
// its place is right to a small part of a texel however many tiles and steps it crosses.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Walk {
    vec2 cell; // whole numbers; in [0, size) when the tile repeats
    vec2 p; // in the cell, [0, 1)
    float z; // height, 1 at the polygon, in whole 1024ths from where the walk began ...
    float below; // ... and how far below that the ray is: kept apart, so that nothing is lost when small steps are added up
};

// Of a search, over all its loops. Mesa's rasteriser ends the loops of a pixel after 65535 rounds together, so that with more the answers would
// not be the same everywhere.
const int kMostRounds = 65000;

float heightOf(Walk walk)
{
    return walk.z - walk.below;
}

// perTexel: 1 / size.
vec2 wrappedCell(vec2 cell, vec2 size, vec2 perTexel)
{
    if (clamped())
        return clamp(cell, vec2(-1e7f), vec2(1e7f));
    return clamp(cell - size * floor((cell + 0.5f) * perTexel), vec2(0.0f), size - 1.0f);
}

Walk moved(Walk walk, vec2 slope, vec2 size, vec2 perTexel, float dt)
{
    vec2 at = walk.p + slope * dt;
    vec2 cells = floor(at);
    walk.p = min(at - cells, vec2(0.99999994f)); // a hair below a wall must not be rounded to it: that would be the next cell's
    walk.cell = wrappedCell(walk.cell + cells, size, perTexel);
    walk.below += dt;
    float whole = floor(walk.below * 1024.0f) * 0.0009765625f;
    walk.below -= whole;
    walk.z -= whole;
    return walk;
}

Walk walkFrom(Ray ray, vec2 slope, vec2 size, vec2 perTexel, float t)
{
    vec2 at = ray.uv * size - 0.5f;
    at = vec2(abs(at.x) < 1e30f ? at.x : 0.0f, abs(at.y) < 1e30f ? at.y : 0.0f); // so far out that texels are no numbers any more
    vec2 cells = floor(at);
    return moved(Walk(wrappedCell(cells, size, perTexel), at - cells, 1.0f, 0.0f), slope, size, perTexel, t);
}

// Texels to a unit of depth. What is next to nothing is 0, so that no rounding of it (which machines do differently) moves a ray over a wall
// that it runs along.
vec2 slopeOf(Ray ray, vec2 size)
{
    vec2 slope = ray.duv * size;
    return vec2(abs(slope.x) > 1e-30f ? slope.x : 0.0f, abs(slope.y) > 1e-30f ? slope.y : 0.0f);
}

// One over the slope; where that is next to 0, a wall is never reached.
vec2 inverseOf(vec2 slope)
{
    return vec2(abs(slope.x) > 1e-30f ? 1.0f / slope.x : 1e30f, abs(slope.y) > 1e-30f ? 1.0f / slope.y : 1e30f);
}
