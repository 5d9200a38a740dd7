// Bricks, cobblestones, planks, scales, hammered metal and terrain by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/samples/sample_patterns.h"
#include "core/image/samples/sample_noise.h"
#include <numbers>

namespace relievo::pattern {

namespace {
template <std::size_t N> glm::vec3 pick(const std::array<glm::vec3, N>& palette, float share)
{
    const float at = share * float(N - 1);
    const auto i = std::min(std::size_t(at), N - 2);
    return glm::mix(palette[i], palette[i + 1], at - float(i));
}

glm::vec2 turned(glm::vec2 p, float angle)
{
    const float c = std::cos(angle), s = std::sin(angle);
    return {p.x * c - p.y * s, p.x * s + p.y * c};
}

// Signed distance to a rectangle with rounded corners, negative inside.
float roundedBox(glm::vec2 p, glm::vec2 half, float radius)
{
    const glm::vec2 d = glm::abs(p) - half + radius;
    return glm::length(glm::max(d, glm::vec2(0.f))) + std::min(std::max(d.x, d.y), 0.f) - radius;
}
} // namespace

Point bricks(glm::vec2 uv)
{
    constexpr int kColumns = 4, kRows = 10;
    const glm::vec2 waver = 0.0032f * glm::vec2(fractal(uv, 10, 3, 1), fractal(uv, 10, 3, 2)); // moulded by hand: no edge is straight
    const glm::vec2 p = uv + waver;
    const float rowPosition = p.y * kRows;
    const int row = wrapIndex(floorOf(rowPosition), kRows, Wrap::Repeat);
    const float columnPosition = p.x * kColumns + ((row & 1) ? 0.5f : 0.f) + 0.05f * (randomOf(row, 3, 5) - 0.5f);
    const int column = wrapIndex(floorOf(columnPosition), kColumns, Wrap::Repeat);
    const std::uint32_t id = hashOf(column, row, 11);
    const glm::vec2 pitch(1.f / kColumns, 1.f / kRows);
    const glm::vec2 cell
        = glm::vec2(columnPosition - std::floor(columnPosition) - 0.5f, rowPosition - std::floor(rowPosition) - 0.5f) * pitch;
    const glm::vec2 local = turned(cell, 0.016f * (randomOf(id, 1) - 0.5f));
    const glm::vec2 half = 0.5f * pitch - 0.0058f - 0.002f * glm::vec2(randomOf(id, 2), randomOf(id, 3));

    const float crumble = fractal(uv, 30, 3, 21);
    const float chips = smooth(0.18f, 0.62f, fractal(uv, 13, 3, 22)) * 0.008f;
    const float inside = -(roundedBox(local, half, 0.006f) + 0.0013f * crumble + chips);
    const float face = smooth(-0.002f, 0.0075f, inside);
    const float body = smooth(-0.0005f, 0.0022f, inside); // where the colour is the brick's

    const float grain = fractal(uv, 48, 3, 23);
    const float lumps = fractal(uv, 9, 3, 24);
    const float pits = smooth(0.34f, 0.62f, fractal(uv, 56, 2, 25));
    const float tilt = glm::dot(local, glm::vec2(randomOf(id, 4) - 0.5f, randomOf(id, 5) - 0.5f)) * 1.4f;
    const float brick = 0.8f + 0.13f * (randomOf(id, 6) - 0.5f) + tilt + 0.05f * lumps + 0.014f * grain - 0.07f * pits;
    const float sand = fractal(uv, 64, 2, 26);
    const float mortar = 0.2f + 0.06f * fractal(uv, 14, 3, 27) + 0.018f * sand;

    constexpr std::array<glm::vec3, 6> kClay = {{{0.38f, 0.215f, 0.175f}, {0.52f, 0.275f, 0.21f}, {0.60f, 0.34f, 0.25f},
        {0.66f, 0.39f, 0.285f}, {0.61f, 0.315f, 0.225f}, {0.76f, 0.49f, 0.35f}}};
    glm::vec3 clay = pick(kClay, randomOf(id, 7));
    clay *= 0.88f + 0.10f * lumps + 0.05f * grain;
    clay = glm::mix(
        clay, glm::vec3(0.30f, 0.17f, 0.14f), 0.55f * smooth(0.15f, 0.6f, fractal(uv, 7, 3, 28)) * randomOf(id, 8)); // kiln marks
    clay = glm::mix(clay, glm::vec3(0.80f, 0.70f, 0.61f), 0.30f * smooth(0.12f, 0.65f, fractal(uv, 6, 3, 29))); // lime bloom
    clay *= 1.f - 0.30f * pits;
    const glm::vec3 lime = glm::vec3(0.66f, 0.615f, 0.55f) * (1.f + 0.08f * sand + 0.09f * fractal(uv, 5, 3, 30));
    return {glm::mix(mortar, brick, face), glm::mix(lime, clay, body), glm::mix(0.95f, 0.80f + 0.05f * grain + 0.08f * pits, body)};
}

Point cobblestones(glm::vec2 uv)
{
    constexpr CellGrid kStones{{7, 8}, 0.55f, 43};
    const glm::vec2 waver = 0.007f * glm::vec2(fractal(uv, 9, 3, 41), fractal(uv, 9, 3, 42));
    const CellPoint cell = cellAt(uv + waver, kStones);
    const float lumps = fractal(uv, 12, 3, 44), grain = fractal(uv, 60, 2, 45), low = fractal(uv, 3, 3, 46);

    const float border = cell.border + 0.012f * lumps;
    const float gap = 0.012f + 0.03f * randomOf(cell.id, 1);
    const float inside = saturate((border - gap) / 0.40f);
    const float dome = std::sqrt(1.f - (1.f - inside) * (1.f - inside)); // a worn, rounded top
    const float body = smooth(gap - 0.015f, gap + 0.035f, border);
    const float tilt = glm::dot(cell.offset, glm::vec2(randomOf(cell.id, 2) - 0.5f, randomOf(cell.id, 3) - 0.5f)) * 0.28f;
    const float wear = smooth(0.3f, 0.7f, fractal(uv, 20, 3, 47));
    const float stone = 0.24f + 0.54f * dome + 0.16f * randomOf(cell.id, 4) + tilt + 0.045f * lumps * dome + 0.008f * grain - 0.035f * wear;

    const float mossMask = smooth(-0.15f, 0.45f, low + 0.35f * fractal(uv, 20, 3, 48));
    const float tufts = fractal(uv, 44, 3, 49);
    const float soil = 0.16f + 0.035f * fractal(uv, 26, 3, 50) + mossMask * (0.07f + 0.05f * tufts);
    const float height = glm::mix(soil, std::max(stone, soil), body);

    constexpr std::array<glm::vec3, 6> kStone = {{{0.36f, 0.35f, 0.35f}, {0.50f, 0.47f, 0.43f}, {0.60f, 0.55f, 0.48f},
        {0.44f, 0.45f, 0.47f}, {0.56f, 0.47f, 0.39f}, {0.66f, 0.62f, 0.56f}}};
    glm::vec3 rock = pick(kStone, randomOf(cell.id, 5));
    rock *= 0.86f + 0.2f * dome + 0.13f * lumps + 0.06f * grain;
    rock = glm::mix(rock, glm::vec3(0.60f, 0.54f, 0.45f), 0.25f * wear); // dust in the hollows
    const float lichen = smooth(0.34f, 0.6f, fractal(uv, 8, 3, 51)) * randomOf(cell.id, 6);
    rock = glm::mix(rock, glm::vec3(0.66f, 0.65f, 0.50f), 0.5f * lichen);
    const glm::vec3 earth = glm::vec3(0.25f, 0.205f, 0.155f) * (1.f + 0.25f * fractal(uv, 40, 2, 52));
    const glm::vec3 moss = glm::mix(glm::vec3(0.19f, 0.235f, 0.08f), glm::vec3(0.42f, 0.46f, 0.17f), saturate(0.5f + 0.7f * tufts));
    const glm::vec3 ground = glm::mix(earth, moss, mossMask);
    const float creep = mossMask * (1.f - smooth(0.02f, 0.30f + 0.12f * tufts, inside)); // moss climbs the edges
    const glm::vec3 color = glm::mix(ground, glm::mix(rock, moss, 0.75f * creep), body);
    const float rough = glm::mix(0.95f, 0.72f - 0.22f * smooth(0.6f, 1.f, dome) + 0.08f * lumps + 0.25f * creep, body);
    return {height, color, saturate(rough)};
}

namespace {
struct Knot {
    glm::vec2 centre; // m along and across the board, tile = 1
    float size;
};

// How far along (0 at the knot, 1 outside) and how strongly a point is in a knot.
float knotAt(glm::vec2 p, const Knot& knot)
{
    const glm::vec2 d = (p - knot.centre) / glm::vec2(1.7f, 1.f) / knot.size;
    return glm::length(d);
}

// A nail head: 1 on it, 0 outside, from its distance in tiles.
float nailAt(glm::vec2 p, glm::vec2 at)
{
    return 1.f - smooth(0.0052f, 0.0068f, glm::length(p - at));
}

constexpr int kBoardRows = 6;

// A board at a point of its own frame, which begins in its middle; tile = 1.
struct BoardPoint {
    std::uint32_t id;
    float length, along, across;
};
BoardPoint boardAt(glm::vec2 uv)
{
    const glm::vec2 p = uv + glm::vec2(0.f, 0.0012f * fractal(uv, 4, 2, 61));
    const int row = wrapIndex(floorOf(p.y * kBoardRows), kBoardRows, Wrap::Repeat);
    const float across = (p.y * kBoardRows - std::floor(p.y * kBoardRows) - 0.5f) * (1.f / kBoardRows);
    // Two boards a row; joints are spread so that neighbours never line up.
    const float start = float((row * 5) % kBoardRows) / float(kBoardRows) * 0.5f + 0.11f * randomOf(row, 0, 62);
    const float split = 0.52f + 0.16f * (randomOf(row, 1, 62) - 0.5f);
    float along = uv.x - start;
    along -= std::floor(along);
    const bool second = along > split;
    const float length = second ? 1.f - split : split;
    along = (second ? along - split : along) - 0.5f * length;
    return {hashOf(row, second, 63), length, along, across};
}
} // namespace

Point planks(glm::vec2 uv)
{
    constexpr float kWidth = 1.f / kBoardRows;
    constexpr glm::ivec2 kFree(509); // boards end at joints: their noise need not repeat
    const auto [id, length, along, across] = boardAt(uv);
    const glm::vec2 local(along, across);
    const glm::vec2 far = local + glm::vec2(2.f + 9.f * randomOf(id, 1), 2.f); // positive and different on every board

    // Rings of a log that runs almost along the board, pushed aside by a knot.
    const Knot knot{
        {(randomOf(id, 2) - 0.5f) * 0.7f * length, (randomOf(id, 3) - 0.5f) * 0.55f * kWidth}, 0.007f + 0.007f * randomOf(id, 4)};
    const bool hasKnot = randomOf(id, 5) < 0.6f;
    const float knotDistance = hasKnot ? knotAt(local, knot) : 9.f;
    const float sway = noise(far * glm::vec2(5.f, 4.f), kFree, id), slow = noise(far * glm::vec2(2.2f, 1.f), kFree, id + 1u);
    const float heart = 0.55f * kWidth * (randomOf(id, 6) - 0.5f);
    const glm::vec2 log(across - heart + 0.012f * sway, 0.05f + 0.19f * (along + 0.3f * (randomOf(id, 7) - 0.5f)) + 0.03f * slow);
    const float radius = glm::length(log) + 0.012f * std::exp(-0.16f * knotDistance * knotDistance)
        + 0.0012f * noise(far * glm::vec2(14.f, 60.f), kFree, id + 2u);
    const float ring = radius * (95.f + 40.f * randomOf(id, 8));
    const float phase = ring - std::floor(ring);
    const float late = smooth(0.15f, 0.78f, phase) * (1.f - smooth(0.82f, 1.f, phase)); // slow to dark, quickly back
    const float fibre = noise(far * glm::vec2(11.f, 230.f), kFree, id + 3u),
                pores = smooth(0.35f, 0.75f, noise(far * glm::vec2(26.f, 330.f), kFree, id + 4u));
    const float inKnot = 1.f - smooth(0.75f, 1.15f, knotDistance);

    const glm::vec2 half(0.5f * length - 0.0016f, 0.5f * kWidth - 0.0022f);
    const float inside = -roundedBox(local, half, 0.0035f) - 0.0009f * noise(far * glm::vec2(40.f, 40.f), kFree, id + 5u);
    const float face = smooth(-0.0008f, 0.0058f, inside), body = smooth(-0.0008f, 0.0012f, inside);
    const float check
        = smooth(0.62f, 0.8f, noise(far * glm::vec2(3.5f, 70.f), kFree, id + 6u)) * smooth(0.1f, 0.5f, slow + 0.3f); // drying cracks
    const float cup = 1.f - 4.f * across * across / (kWidth * kWidth);
    float nail = 0.f;
    for (const float end : {-1.f, 1.f})
        for (const float side : {-1.f, 1.f})
            nail = std::max(nail, nailAt(local, {end * (0.5f * length - 0.021f), side * 0.24f * kWidth}));
    float wood = 0.66f + 0.13f * (randomOf(id, 9) - 0.5f) + 0.05f * cup + 0.25f * along * (randomOf(id, 10) - 0.5f) + 0.045f * late
        + 0.022f * fibre - 0.03f * pores - 0.22f * check + 0.04f * inKnot + 0.02f * slow;
    wood = glm::mix(wood, wood - 0.05f, nail);
    const float height = glm::mix(0.f, wood, face);

    constexpr std::array<glm::vec3, 4> kOak
        = {{{0.60f, 0.43f, 0.28f}, {0.71f, 0.52f, 0.34f}, {0.66f, 0.46f, 0.29f}, {0.76f, 0.59f, 0.41f}}};
    glm::vec3 color = pick(kOak, randomOf(id, 11));
    color *= glm::mix(glm::vec3(1.f), glm::vec3(0.70f, 0.62f, 0.54f), 0.75f * late);
    color *= 1.f + 0.06f * fibre + 0.06f * slow + 0.04f * sway;
    color *= 1.f - 0.24f * pores;
    color = glm::mix(color, glm::vec3(0.30f, 0.175f, 0.10f) * (0.85f + 0.3f * late), 0.85f * inKnot);
    color = glm::mix(
        color, glm::vec3(0.56f, 0.52f, 0.47f), 0.22f * smooth(0.f, 0.7f, fractal(uv, glm::ivec2(3, 10), 3, 64))); // weathered grey
    color *= 1.f - 0.65f * check;
    color = glm::mix(color, glm::vec3(0.24f, 0.215f, 0.20f), nail);
    color = glm::mix(glm::vec3(0.085f, 0.062f, 0.045f), color * (0.8f + 0.2f * face), body);
    const float rough = glm::mix(0.95f, 0.58f + 0.10f * pores - 0.08f * late + 0.06f * fibre - 0.1f * nail, body);
    return {height, color, saturate(rough)};
}

namespace {
// One scale at a point of its own frame: x in [-1/2, 1/2] across, y down from its row's line in rows.
struct ScalePoint {
    float edge; // distance to its rim in rows, positive inside
    float x, y;
};
ScalePoint scaleAt(float x, float y)
{
    const float a = std::abs(2.f * x);
    const float rim = 0.22f + 1.04f * (1.f - std::pow(a, 2.3f)); // how far down the scale reaches here
    const float steep = 1.04f * 2.3f * 2.f * std::pow(a, 1.3f);
    return {(rim - y) / std::sqrt(1.f + steep * steep * 0.45f), x, y};
}
} // namespace

Point scales(glm::vec2 uv)
{
    constexpr int kColumns = 8, kRows = 12;
    const glm::vec2 p = uv + 0.0035f * glm::vec2(fractal(uv, 5, 2, 71), fractal(uv, 5, 2, 72));
    const float y = p.y * kRows;
    const int first = floorOf(y);
    ScalePoint scale{};
    std::uint32_t id = 0;
    for (int line = first - 1; line <= first + 1; ++line) { // upper rows lie on the lower ones
        const int row = wrapIndex(line, kRows, Wrap::Repeat);
        const float x = p.x * kColumns + ((row & 1) ? 0.5f : 0.f);
        const int column = wrapIndex(floorOf(x), kColumns, Wrap::Repeat);
        id = hashOf(column, row, 73);
        scale = scaleAt(x - std::floor(x) - 0.5f, y - float(line) + 0.10f * (randomOf(id, 1) - 0.5f));
        if (scale.edge > 0.f)
            break;
    }
    const float edge = std::max(scale.edge, 0.f);
    const float lift = (scale.y + 1.f) / 2.2f; // 0 under its neighbours, 1 at the tip
    const float rim = smooth(0.f, 0.13f, edge);
    const float keel = std::exp(-scale.x * scale.x / 0.0028f) * smooth(0.05f, 0.4f, edge);
    const float rings
        = std::sin(edge * 44.f + 1.5f * fractal(uv, 16, 2, 74)) * smooth(0.08f, 0.2f, edge) * (1.f - smooth(0.7f, 1.1f, edge));
    const float lumps = fractal(uv, 22, 3, 75), fine = fractal(uv, 60, 2, 76);
    const float height = 0.10f + 0.62f * lift * (0.86f + 0.14f * randomOf(id, 2)) - 0.75f * scale.x * scale.x + 0.075f * keel
        + 0.014f * rings + 0.022f * lumps + 0.006f * fine - 0.22f * (1.f - rim) * (1.f - rim);

    const float patch = saturate(0.5f + 0.8f * fractal(uv, 2, 3, 77));
    glm::vec3 color = glm::mix(glm::vec3(0.055f, 0.22f, 0.235f), glm::vec3(0.125f, 0.37f, 0.27f), patch);
    color *= 0.8f + 0.4f * randomOf(id, 3);
    color = glm::mix(color, glm::vec3(0.20f, 0.50f, 0.38f), 0.5f * smooth(0.35f, 0.9f, lift));
    const float gold = (1.f - smooth(0.05f, 0.30f, edge)) * smooth(0.35f, 0.9f, lift) * (0.65f + 0.35f * randomOf(id, 4));
    color = glm::mix(color, glm::vec3(0.80f, 0.62f, 0.28f), 0.85f * gold);
    color = glm::mix(color, glm::vec3(0.58f, 0.60f, 0.32f), 0.4f * keel);
    color *= 1.f + 0.10f * rings + 0.10f * lumps + 0.06f * fine;
    color *= glm::mix(0.35f, 1.f, smooth(-0.1f, 0.45f, lift)); // dark under the neighbours' rims
    return {
        height, glm::clamp(color, glm::vec3(0.f), glm::vec3(1.f)), saturate(0.36f + 0.10f * lumps + 0.06f * rings + 0.12f * (1.f - rim))};
}

namespace {
// Bowls left by hammer blows: the smooth minimum of paraboloids about jittered centres; 0 deep in a bowl, about 0.5 on its rim.
float blows(glm::vec2 uv, const CellGrid& grid)
{
    constexpr float kSharpness = 22.f;
    const glm::vec2 p = uv * glm::vec2(grid.cells);
    float sum = 0.f;
    for (int j = floorOf(p.y) - 1; j <= floorOf(p.y) + 1; ++j) {
        const int middle = floorOf(p.x - grid.shift(j));
        for (int i = middle - 1; i <= middle + 1; ++i) {
            const glm::vec2 d = p - grid.centre(i, j);
            const float strength = 0.16f * randomOf(grid.id(i, j), 3);
            sum += std::exp(-kSharpness * (glm::dot(d, d) + strength));
        }
    }
    return -std::log(sum + 1e-12f) / kSharpness;
}
} // namespace

Point hammered(glm::vec2 uv)
{
    const glm::vec2 p = uv + 0.006f * glm::vec2(fractal(uv, 8, 2, 81), fractal(uv, 8, 2, 82));
    const float bowls = blows(p, {{12, 14}, 0.5f, 83});
    const float swell = fractal(uv, 3, 2, 85), lumps = fractal(uv, 14, 3, 86);
    const float scratches = noise(uv * glm::vec2(90.f, 12.f), {90, 12}, 87), fine = fractal(uv, 64, 2, 88);
    const float height = 0.95f * bowls + 0.07f * swell + 0.012f * lumps + 0.002f * fine;

    const float ridge = smooth(0.10f, 0.45f, bowls); // rubbed bright, while the bowls keep their tarnish
    const float age = fractal(uv, 3, 5, 89);
    const float tarnish = smooth(-0.45f, 0.55f, age + 0.10f * (0.5f - ridge));
    const float green = smooth(0.16f, 0.40f, fractal(uv, 3, 5, 90) + 0.07f * (0.5f - ridge)) * smooth(-0.2f, 0.3f, age);
    glm::vec3 color = glm::mix(glm::vec3(0.88f, 0.565f, 0.40f), glm::vec3(0.93f, 0.65f, 0.48f), ridge);
    color *= 1.f + 0.05f * lumps + 0.03f * scratches;
    color = glm::mix(color, glm::vec3(0.56f, 0.33f, 0.225f) * (1.f + 0.12f * lumps), 0.75f * tarnish);
    color = glm::mix(color, glm::vec3(0.34f, 0.53f, 0.455f) * (1.f + 0.25f * fine), 0.62f * green);
    const float rough = 0.24f + 0.22f * tarnish + 0.35f * green - 0.07f * ridge + 0.05f * lumps + 0.03f * scratches;
    return {height, glm::clamp(color, glm::vec3(0.f), glm::vec3(1.f)), std::clamp(rough, 0.12f, 0.9f), 1.f - 0.8f * green};
}

namespace {
// One octave as a ridge: sharp-crested but rounded at the texel scale.
float ridgeOf(float n)
{
    return 1.f - std::sqrt(n * n + 0.0012f) * 1.15f;
}
} // namespace

Point terrain(glm::vec2 uv)
{
    const glm::vec2 warp(fractal(uv, 3, 3, 91), fractal(uv, 3, 3, 92));
    const glm::vec2 p = uv + 0.085f * warp;
    // Ridges on ridges (Musgrave's multifractal): detail grows where the ground is high, valleys stay smooth.
    float sum = 0.f, weight = 1.f, amplitude = 0.55f;
    int cells = 3;
    for (std::uint32_t octave = 0; octave < 7; ++octave, cells *= 2, amplitude *= 0.48f) {
        const float r = ridgeOf(noise(p * float(cells), glm::ivec2(cells), 93u + octave));
        const float signal = r * r * weight;
        sum += amplitude * signal;
        weight = saturate(signal * 1.9f);
    }
    const float plain = 0.5f + 0.5f * fractal(uv, 2, 3, 101);
    const float relief = 0.62f * sum + 0.40f * plain;
    constexpr float kLake = 0.245f, kShore = 0.04f; // lakes are level, their shores gentle
    const float above = std::max(relief - kLake, 0.f);
    return {above < kShore ? above * above / (2.f * kShore) : above - 0.5f * kShore, {}, 0.9f};
}

Point terrainColor(glm::vec2 uv, float height, float slope)
{
    const float blend = fractal(uv, 10, 4, 102), fine = fractal(uv, 60, 2, 103);
    const float steep = smooth(3.0f, 6.0f, slope + 1.2f * blend);
    const glm::vec3 meadow = glm::mix(glm::vec3(0.35f, 0.40f, 0.19f), glm::vec3(0.52f, 0.51f, 0.28f), saturate(0.5f + 0.9f * blend));
    const glm::vec3 forest = glm::vec3(0.185f, 0.255f, 0.135f) * (1.f + 0.35f * fine);
    const glm::vec3 alp = glm::vec3(0.47f, 0.45f, 0.31f) * (1.f + 0.10f * fine);
    const glm::vec3 rock
        = glm::mix(glm::vec3(0.37f, 0.335f, 0.31f), glm::vec3(0.50f, 0.455f, 0.41f), saturate(0.5f + 0.9f * blend)) * (1.f + 0.10f * fine);
    const float h = height + 0.06f * blend;
    glm::vec3 color = glm::mix(meadow, forest, smooth(0.10f, 0.20f, h + 0.06f * fine));
    color = glm::mix(color, alp, smooth(0.38f, 0.50f, h));
    color = glm::mix(color, rock, std::max(steep, smooth(0.54f, 0.66f, h)));
    const float snow = smooth(0.62f, 0.72f, h) * (1.f - 0.85f * smooth(5.5f, 10.f, slope));
    color = glm::mix(color, glm::vec3(0.92f, 0.94f, 0.965f), snow);
    color = glm::mix(color, glm::vec3(0.66f, 0.60f, 0.46f), 0.8f * (1.f - smooth(0.004f, 0.02f, height))); // beaches
    const float water = 1.f - smooth(0.0004f, 0.003f, height);
    color = glm::mix(color, glm::vec3(0.13f, 0.30f, 0.33f), water);
    return {height, color, saturate(glm::mix(0.92f - 0.35f * snow - 0.12f * steep, 0.08f, water))};
}

} // namespace relievo::pattern
