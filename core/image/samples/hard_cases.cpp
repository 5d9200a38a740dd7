// The formulas of the hard height fields.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/samples/hard_cases.h"
#include "core/image/samples/sample_noise.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace relievo {

namespace {
using pattern::randomOf;
constexpr float kTau = 2.f * std::numbers::pi_v<float>;

struct Texel {
    int x, y; // texel
    int width, height; // of the field, texels
    std::uint32_t seed;
    glm::vec2 uv; // its centre, in [0, 1]

    // A random number of the cell that the texel lies in, when `cells` lie along each side.
    float random(std::uint32_t salt = 0) const { return randomOf(x, y, seed * 7919u + salt); }
};

using CaseFormula = float (*)(const Texel&);

HeightField fieldBy(CaseFormula formula, int width, int height, std::uint32_t seed)
{
    assert(width >= 1 && height >= 1);
    std::vector<float> heights;
    heights.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 uv((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
            heights.push_back(std::clamp(formula({x, y, width, height, seed, uv}), 0.f, 1.f));
        }
    return {width, height, std::move(heights), Wrap::Repeat, 32};
}
template <CaseFormula formula> HeightField square(int size, std::uint32_t seed)
{
    return fieldBy(formula, size, size, seed);
}

float waves(const Texel& p)
{
    return 0.5f + 0.25f * std::sin(kTau * 3.f * p.uv.x) + 0.25f * std::cos(kTau * (2.f * p.uv.y + p.uv.x));
}

float needles(const Texel& p)
{
    return p.random() < 0.002f ? 1.f : 0.1f * p.random(1);
}

// Walls one texel thick every 16 texels (at least two a side when the field allows), with gaps.
float walls(const Texel& p)
{
    const bool alongX = p.y % 16 == 3 && p.x % 16 > 2, alongY = p.x % 16 == 3 && p.y % 16 > 4;
    return alongX || alongY ? 1.f : 0.f;
}

float edge(const Texel& p)
{
    return p.x == p.width / 2 ? 1.f : 0.f;
}
float dot(const Texel& p)
{
    return p.x == p.width / 2 && p.y == p.height / 2 ? 1.f : 0.f;
}
float checker(const Texel& p)
{
    return float((p.x + p.y) % 2);
}
float noise(const Texel& p)
{
    return p.random();
}

float terraces(const Texel& p)
{
    return std::round(waves(p) * 6.f) / 6.f;
}

// Round wells with vertical walls in a flat top, a third of the cells without.
float holes(const Texel& p)
{
    const int cells = std::max(1, p.width / 32);
    const glm::vec2 at = p.uv * float(cells);
    const int i = std::min(int(at.x), cells - 1), j = std::min(int(at.y), cells - 1);
    const float radius = 0.15f + 0.25f * randomOf(i, j, p.seed);
    const bool inside = glm::length(at - glm::vec2(i, j) - 0.5f) < radius;
    return inside && randomOf(i, j, p.seed + 1) > 0.33f ? 0.f : 1.f;
}

// Blocks of 2 x 2 texels whose diagonals are high and low: each cell between them is a saddle.
float saddles(const Texel& p)
{
    const int i = p.x / 2, j = p.y / 2;
    return (i + j) % 2 ? 0.9f + 0.1f * p.random() : 0.1f * p.random();
}

float hemispheres(const Texel& p)
{
    const float cells = float(std::max(1, p.width / 64));
    const glm::vec2 at = p.uv * cells - glm::floor(p.uv * cells) - 0.5f;
    return std::sqrt(std::max(0.f, 0.2f - glm::dot(at, at))) / std::sqrt(0.2f);
}

// Running bond, eight courses a tile; joints at the floor, noisy tops of differing height.
float bricks(const Texel& p)
{
    constexpr int kCourses = 8, kBricks = 4;
    const float row = p.uv.y * kCourses;
    const int course = std::min(int(row), kCourses - 1);
    float along = p.uv.x * kBricks + 0.5f * float(course % 2);
    along -= along >= float(kBricks) ? float(kBricks) : 0.f;
    const float joint = 0.1f, inRow = row - float(course), inBrick = along - std::floor(along);
    if (inRow < joint || inBrick < joint * 0.5f)
        return 0.f;
    return 0.7f + 0.15f * randomOf(int(along), course, p.seed) + 0.15f * p.random(1);
}

// Sharp crests along the diagonal, twelve a tile.
float ridges(const Texel& p)
{
    const float phase = 12.f * (p.uv.x + p.uv.y);
    return 1.f - std::abs(2.f * (phase - std::floor(phase)) - 1.f);
}

float fbm(const Texel& p)
{
    float sum = 0.f, weight = 0.5f;
    for (int octave = 0, period = 4; octave < 7; ++octave, period *= 2, weight *= 0.5f) {
        const glm::vec2 at = p.uv * float(period);
        const int i = int(at.x), j = int(at.y);
        const float fx = pattern::smooth(0.f, 1.f, at.x - float(i)), fy = pattern::smooth(0.f, 1.f, at.y - float(j));
        const auto corner = [&](int dx, int dy) { return randomOf((i + dx) % period, (j + dy) % period, p.seed + std::uint32_t(octave)); };
        sum += weight * glm::mix(glm::mix(corner(0, 0), corner(1, 0), fx), glm::mix(corner(0, 1), corner(1, 1), fx), fy);
    }
    return (sum - 0.2f) / 0.6f;
}

float nearFlat(const Texel& p)
{
    return 0.5f + 0.001f * (waves(p) - 0.5f);
}
float low(const Texel&)
{
    return 0.f;
}
float high(const Texel&)
{
    return 1.f;
}

// A gentle slope stored in 8 bits: long flats, steps of 1 / 255.
float stairs(const Texel& p)
{
    return std::round((1.f - std::abs(2.f * p.uv.x - 1.f)) * 0.25f * 255.f) / 255.f;
}

// Rises over the whole tile and falls within one texel, across the seam.
float seam(const Texel& p)
{
    return p.uv.x;
}

// Three quarters as high as wide and no power of two, with fine and coarse features.
HeightField oblong(int size, std::uint32_t seed)
{
    const int width = size % 2 ? size : std::max(1, size - 1), height = std::max(1, width * 3 / 4);
    return fieldBy([](const Texel& p) { return p.random() < 0.004f ? 1.f : 0.7f * waves(p); }, width, height, seed);
}

} // namespace

const std::array<HardCaseRow, 20> kHardCases = {{
    {"needles", "Needles", square<needles>, true, "0.2 % of the texels stand alone at full height: easily stepped over."},
    {"walls", "One-texel walls", square<walls>, false, "A grid of walls one texel thick with gaps."},
    {"edge", "One edge", square<edge>, false, "A single wall one texel thick on flat ground."},
    {"dot", "One dot", square<dot>, false, "A single texel at full height on flat ground."},
    {"checker", "Checkerboard", square<checker>, false, "Neighbouring texels at 0 and 1: every cell is a steep saddle."},
    {"noise", "White noise", square<noise>, false, "Every texel random."},
    {"terraces", "Terraces", square<terraces>, true, "Flat steps with edges one texel wide."},
    {"holes", "Holes", square<holes>, false, "Wells with vertical walls in a flat top."},
    {"saddles", "Saddles", square<saddles>, false, "Cells that a ray may enter and leave through the surface."},
    {"hemispheres", "Hemispheres", square<hemispheres>, false, "Smooth domes with vertical feet."},
    {"bricks", "Rough bricks", square<bricks>, true, "Vertical walls and noisy tops."},
    {"waves", "Smooth waves", square<waves>, true, "Gentle everywhere: what every search should do well."},
    {"ridges", "Diagonal ridges", square<ridges>, false, "Sharp crests that lie across the grid."},
    {"fbm", "Fractal noise", square<fbm>, false, "Seven octaves, down to the texel."},
    {"near-flat", "Near-flat", square<nearFlat>, false, "Waves of a thousandth of the depth: steep bounds where nothing is steep."},
    {"low", "All black", square<low>, false, "Constant 0: every ray runs to the floor."},
    {"high", "All white", square<high>, false, "Constant 1: every ray ends at once."},
    {"stairs", "8-bit ramp", square<stairs>, false, "A gentle slope in steps of 1 / 255."},
    {"seam", "Ramp over the seam", square<seam>, false, "Falls from 1 to 0 across the border of the tile."},
    {"oblong", "Oblong", oblong, false, "Not square and no power of two."},
}};

const HardCaseRow* findHardCase(std::string_view key)
{
    const auto found = std::ranges::find(kHardCases, key, &HardCaseRow::key);
    return found == kHardCases.end() ? nullptr : &*found;
}

MapSlots hardCaseSlots(std::string_view key, int size)
{
    MapSlots slots;
    for (const MapKind kind : {MapKind::Height, MapKind::Color})
        slots[std::size_t(kind)].file = "sample:hard-" + std::string(key) + '@' + std::to_string(size);
    return slots;
}

Sample hardCaseSample(const HardCaseRow& row, int size)
{
    const HeightField field = row.make(size, 1);
    const std::span<const float> texels = field.texels();
    Sample sample;
    sample.height = {field.width(), field.height(), 1, PixelType::F32, 32, true, {}};
    const auto bytes = std::as_bytes(texels);
    sample.height.data.assign(bytes.begin(), bytes.end());
    sample.color = {field.width(), field.height(), 3, PixelType::U8, 8, false, {}};
    sample.color.data.reserve(texels.size() * 3);
    for (const float h : texels)
        sample.color.data.insert(sample.color.data.end(), 3, std::byte(std::lround(120.f + 100.f * h)));
    return sample;
}

} // namespace relievo
