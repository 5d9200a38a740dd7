// The built-in materials: from formulas to maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/samples/samples.h"
#include "core/image/samples/sample_patterns.h"
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {
using pattern::Point;
using Grid = std::vector<float>; // size x size

template <class Work> void forEachTexel(int size, Work work)
{
    tbb::parallel_for(0, size, [&](int y) {
        for (int x = 0; x < size; ++x)
            work(x, y, glm::vec2((float(x) + 0.5f) / float(size), (float(y) + 0.5f) / float(size)));
    });
}

// Mean over a square of 2 radius + 1 texels of the repeated grid.
Grid blurred(const Grid& from, int size, int radius)
{
    const auto pass = [&](const Grid& in, int step, int lineStep) {
        Grid out(in.size());
        tbb::parallel_for(0, size, [&](int line) {
            const auto at = [&](int i) { return std::size_t(wrapIndex(i, size, Wrap::Repeat) * step + line * lineStep); };
            double sum = 0;
            for (int i = -radius; i <= radius; ++i)
                sum += double(in[at(i)]);
            for (int i = 0; i < size; ++i) {
                out[at(i)] = float(sum / double(2 * radius + 1));
                sum += double(in[at(i + radius + 1)]) - double(in[at(i - radius)]);
            }
        });
        return out;
    };
    return pass(pass(from, 1, size), size, 1);
}

// Stretches the heights to the whole of [0, 1].
void normalize(Grid& heights)
{
    const auto [low, high] = std::ranges::minmax(heights);
    const float range = high - low;
    for (float& h : heights)
        h = range > 0.f ? (h - low) / range : 0.5f;
}

Image emptyImage(int size, int channels, PixelType type)
{
    Image image{size, size, channels, type, int(bytesOf(type)) * 8, false, {}};
    image.data.resize(image.texelCount() * std::size_t(channels) * bytesOf(type));
    return image;
}

void store(Image& image, std::size_t at, float value)
{
    const float v = std::clamp(value, 0.f, 1.f);
    if (image.type == PixelType::U8) {
        image.data[at] = std::byte(std::lround(v * 255.f));
        return;
    }
    const auto wide = std::uint16_t(std::lround(v * 65535.f));
    std::memcpy(image.data.data() + at * 2, &wide, 2);
}

// Height gained over one tile's width along the steepest way.
float slopeAt(const Grid& heights, int size, int x, int y)
{
    const auto at
        = [&](int i, int j) { return heights[std::size_t(wrapIndex(j, size, Wrap::Repeat) * size + wrapIndex(i, size, Wrap::Repeat))]; };
    const float dx = at(x + 1, y) - at(x - 1, y), dy = at(x, y + 1) - at(x, y - 1);
    return 0.5f * float(size) * std::sqrt(dx * dx + dy * dy);
}

using Formula = Point (*)(glm::vec2 uv);
using Recolor = Point (*)(glm::vec2 uv, float height, float slope);

// formula: the sample; recolor: colours that need the slopes, or nullptr. cavity: how much hollows are darkened and crests
// lightened, as dirt and wear do.
Sample makeSample(int size, Formula formula, Recolor recolor, float cavity, bool metal)
{
    assert(size >= 1);
    std::vector<Point> points(std::size_t(size) * std::size_t(size));
    Grid heights(points.size());
    forEachTexel(size, [&](int x, int y, glm::vec2 uv) {
        const std::size_t at = std::size_t(y * size + x);
        points[at] = formula(uv);
        heights[at] = points[at].height;
    });
    normalize(heights);
    const Grid near = blurred(heights, size, std::max(1, size / 110)), wide = blurred(near, size, std::max(1, size / 36));

    Sample sample{emptyImage(size, 1, PixelType::U16), emptyImage(size, 3, PixelType::U8), emptyImage(size, 1, PixelType::U16),
        metal ? emptyImage(size, 1, PixelType::U8) : Image{}};
    forEachTexel(size, [&](int x, int y, glm::vec2 uv) {
        const std::size_t at = std::size_t(y * size + x);
        if (recolor)
            points[at] = recolor(uv, heights[at], slopeAt(heights, size, x, y));
        const float relative = 0.6f * (heights[at] - near[at]) + 0.4f * (heights[at] - wide[at]);
        const glm::vec3 color = points[at].color * (1.f + cavity * std::clamp(relative, -0.3f, 0.15f));
        for (std::size_t k = 0; k < 3; ++k)
            store(sample.color, at * 3 + k, color[int(k)]);
        store(sample.height, at, heights[at]);
        store(sample.roughness, at, points[at].roughness);
        if (metal)
            store(sample.metallic, at, points[at].metallic);
    });
    return sample;
}
} // namespace

const std::array<SampleRow, 6> kSamples = {{
    {"bricks", "Bricks", 0.028f, [](int size) { return makeSample(size, pattern::bricks, nullptr, 1.0f, false); },
        "Hand-moulded bricks in lime mortar."},
    {"cobblestones", "Cobblestones", 0.09f, [](int size) { return makeSample(size, pattern::cobblestones, nullptr, 1.0f, false); },
        "Worn stones with moss in the joints."},
    {"planks", "Planks", 0.03f, [](int size) { return makeSample(size, pattern::planks, nullptr, 0.8f, false); },
        "Oak boards with knots, cracks and nails."},
    {"scales", "Scales", 0.07f, [](int size) { return makeSample(size, pattern::scales, nullptr, 1.2f, false); },
        "Overlapping keeled scales with golden rims."},
    {"hammered", "Hammered metal", 0.02f, [](int size) { return makeSample(size, pattern::hammered, nullptr, 0.3f, true); },
        "Copper beaten by hand, with tarnish and verdigris."},
    {"terrain", "Terrain", 0.14f, [](int size) { return makeSample(size, pattern::terrain, pattern::terrainColor, 1.0f, false); },
        "Mountains, meadows and snow from above."},
}};

const SampleRow* findSample(std::string_view key)
{
    for (const SampleRow& row : kSamples)
        if (row.key == key)
            return &row;
    return nullptr;
}

MapSlots sampleSlots(std::string_view key, int size)
{
    MapSlots slots;
    const SampleRow* row = findSample(key);
    if (!row)
        return slots;
    std::string name = "sample:" + std::string(key);
    if (size != kSampleSize)
        name += '@' + std::to_string(size);
    for (const MapKind kind : {MapKind::Height, MapKind::Color, MapKind::Roughness})
        slots[std::size_t(kind)].file = name;
    if (key == "hammered")
        slots[std::size_t(MapKind::Metallic)].file = name;
    return slots;
}

} // namespace relievo
