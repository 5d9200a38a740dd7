// Height fields by formula that are hard for one map or another, for the tests and the benchmark of bakes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

namespace relievo::test {

// height(x, y), clamped to [0, 1].
inline HeightField fieldOf(int width, int height, const std::function<float(int, int)>& at, Wrap wrap = Wrap::Repeat)
{
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(std::clamp(at(x, y), 0.f, 1.f));
    return {width, height, std::move(heights), wrap};
}

struct HardField {
    const char* name;
    float (*at)(float u, float v, int x, int y, float random); // uv in [0, 1), random in [0, 1)
};

inline float domeAt(float u, float v, float crest)
{
    const float x = u * 4.f - std::floor(u * 4.f) - 0.5f, y = v * 4.f - std::floor(v * 4.f) - 0.5f;
    return crest * std::sqrt(std::max(0.f, 1.f - (x * x + y * y) * 5.f));
}

inline constexpr std::array<HardField, 17> kHardFields = {{
    {"waves",
        [](float u, float v, int, int, float) { return 0.5f + 0.25f * (std::sin(6.2831853f * 6 * u) + std::cos(6.2831853f * 8 * v)); }},
    {"one wave", [](float u, float v, int, int, float) { return 0.5f + 0.25f * (std::sin(6.2831853f * u) + std::cos(6.2831853f * v)); }},
    {"noise", [](float, float, int, int, float random) { return random; }},
    {"needles", [](float, float, int, int, float random) { return random < 0.002f ? 1.f : 0.f; }},
    {"uneven needles", [](float, float, int, int, float random) { return random < 0.002f ? random * 500.f : 0.f; }},
    {"one needle", [](float, float, int x, int y, float) { return x == 3 && y == 5 ? 1.f : 0.f; }},
    {"checkerboard", [](float, float, int x, int y, float) { return float((x + y) % 2); }},
    {"domes", [](float u, float v, int, int, float) { return domeAt(u, v, 1.f); }},
    {"low domes", [](float u, float v, int, int, float) { return domeAt(u, v, 0.6f); }},
    {"bowl", [](float u, float v, int, int, float) { return 1.41f * std::hypot(u - 0.5f, v - 0.5f); }},
    {"crater",
        [](float u, float v, int, int, float) {
            const float r = std::hypot(u - 0.5f, v - 0.5f);
            return r < 0.4f ? 0.f : 1.f - (r - 0.4f);
        }},
    {"ramp", [](float u, float, int, int, float) { return u; }},
    {"terraces",
        [](float u, float v, int, int, float) { return std::floor(5.f * (0.5f + 0.5f * std::sin(6.2831853f * (u + 2 * v)))) / 5.f; }},
    {"holes", [](float, float, int x, int y, float) { return x % 16 == 0 && y % 16 == 0 ? 0.f : 1.f; }},
    {"nearly flat", [](float u, float v, int, int, float random) { return 0.5f + 0.0005f * std::sin(20.f * (u - v)) + 0.0005f * random; }},
    {"rough hills",
        [](float u, float v, int, int, float random) {
            return 0.5f + 0.2f * (std::sin(6.2831853f * 3 * u) + std::cos(6.2831853f * 2 * v)) + 0.05f * random;
        }},
    {"flat", [](float, float, int, int, float) { return 0.5f; }},
}};

inline HeightField hardField(const HardField& hard, int width, int height, Wrap wrap = Wrap::Repeat)
{
    std::mt19937 random(7);
    return fieldOf(
        width, height,
        [&](int x, int y) {
            const float r = float(random() >> 8) / float(1 << 24);
            return hard.at((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height), x, y, r);
        },
        wrap);
}

} // namespace relievo::test
