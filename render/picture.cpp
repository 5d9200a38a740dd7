// Whole pictures: tile by tile, shifted pixel grids averaged, read back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/windowless.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <epoxy/gl.h>
#include <functional>
#include <glm/trigonometric.hpp>
#include <new>
#include <numbers>
#include <type_traits>

namespace relievo {

namespace {

// Radical inverse of i: the k-th shift of the pixel grid is (base 2, base 3), in [0, 1).
float radicalInverse(int i, int base)
{
    float value = 0.f, digit = 1.f;
    for (; i > 0; i /= base) {
        digit /= float(base);
        value += digit * float(i % base);
    }
    return value;
}

// Sums of `samples` pictures, OpenGL's row 0 at the bottom. T: what one picture's values are, Sum: what holds kMaxSamples of them.
template <class T, class Sum>
Expected<std::vector<Sum>> summed(GLenum type, int samples, const std::function<Expected<void>(int)>& draw, int width, int height)
{
    const std::size_t count = std::size_t(width) * std::size_t(height) * 4;
    std::vector<Sum> sums(count);
    std::vector<T> values(samples > 1 || !std::is_same_v<T, Sum> ? count : 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int i = 0; i < samples; ++i) {
        if (auto drawn = draw(i); !drawn)
            return tl::unexpected(drawn.error());
        if constexpr (std::is_same_v<T, Sum>) {
            if (samples == 1) {
                glReadPixels(0, 0, width, height, GL_RGBA, type, sums.data());
                break;
            }
        }
        glReadPixels(0, 0, width, height, GL_RGBA, type, values.data());
        std::ranges::transform(sums, values, sums.begin(), [](Sum a, T b) { return Sum(a + b); });
    }
    return sums;
}

// A part of a picture: its left upper corner, row 0 at the top.
struct Tile {
    int left, top, width, height;
};

template <class T> void put(Image& image, const Tile& tile, int x, int y, int channel, T value)
{
    const std::size_t at = (std::size_t(tile.top + y) * std::size_t(image.width) + std::size_t(tile.left + x)) * 4 + std::size_t(channel);
    std::memcpy(image.data.data() + at * sizeof(T), &value, sizeof(T));
}

// Display values as shares of `white`. Colour was averaged with the black of pixels that nothing covers; PNG wants it without that.
template <class T, class Sum> void putDisplay(Image& image, const Tile& tile, const std::vector<Sum>& sums, float white, int samples)
{
    constexpr float most = float(std::numeric_limits<T>::max());
    const auto stored = [](float share) { return T(std::lround(std::clamp(share, 0.f, 1.f) * most)); };
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const Sum* from = &sums[(std::size_t(tile.height - 1 - y) * std::size_t(tile.width) + std::size_t(x)) * 4];
            const float alpha = float(from[3]) / (white * float(samples));
            for (int c = 0; c < 3; ++c)
                put(image, tile, x, y, c, stored(alpha > 0.f ? float(from[c]) / float(samples) / alpha / white : 0.f));
            put(image, tile, x, y, 3, stored(alpha));
        }
}

void putLinear(Image& image, const Tile& tile, const std::vector<float>& sums, int samples)
{
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x)
            for (int c = 0; c < 4; ++c)
                put(image, tile, x, y, c,
                    sums[(std::size_t(tile.height - 1 - y) * std::size_t(tile.width) + std::size_t(x)) * 4 + std::size_t(c)]
                        / float(samples));
}

Expected<void> drawTile(Image& image, const Tile& tile, const Still& still, const std::function<Expected<void>(int)>& draw)
{
    const auto sums = [&]<class T, class Sum>(GLenum type) { return summed<T, Sum>(type, still.samples, draw, tile.width, tile.height); };
    if (still.type == PixelType::U8)
        return sums.operator()<std::uint8_t, std::uint16_t>(GL_UNSIGNED_BYTE).map([&](const auto& all) {
            putDisplay<std::uint8_t>(image, tile, all, 255.f, still.samples);
        });
    return sums.operator()<float, float>(GL_FLOAT).map([&](const auto& all) {
        still.type == PixelType::F32 ? putLinear(image, tile, all, still.samples)
                                     : putDisplay<std::uint16_t>(image, tile, all, 1.f, still.samples);
    });
}

Expected<Image> blank(const Still& still)
{
    const std::string size = std::to_string(still.width) + "x" + std::to_string(still.height);
    if (still.width < 1 || still.height < 1 || still.width > kMaxPictureSide || still.height > kMaxPictureSide)
        return failure("--size", size + " cannot be drawn", "Up to " + std::to_string(kMaxPictureSide) + " pixels a side are possible");
    Image image{still.width, still.height, 4, still.type, int(8 * bytesOf(still.type)), still.type == PixelType::F32, {}};
    try {
        image.data.resize(image.texelCount() * 4 * bytesOf(still.type));
    } catch (const std::bad_alloc&) {
        return failure(ErrorCode::NoMemory, "--size", "there is not enough memory for " + size + " pixels", "Draw a smaller picture");
    }
    return image;
}

int largestTile(const Still& still)
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    return still.exact ? limit : std::min(limit, still.tile);
}

} // namespace

glm::vec2 pixelShift(int k)
{
    return glm::vec2(radicalInverse(k + 1, 2), radicalInverse(k + 1, 3)) - 0.5f;
}

glm::vec2 lensPoint(int k)
{
    const float angle = 2.f * std::numbers::pi_v<float> * radicalInverse(k + 1, 7);
    return std::sqrt(radicalInverse(k + 1, 5)) * glm::vec2(std::cos(angle), std::sin(angle));
}

Expected<Image> drawStill(
    Renderer& renderer, const State& state, std::size_t pane, Resources& resources, const Still& still, const Progress& progress)
{
    Expected<Image> image = blank(still);
    if (!image)
        return image;
    if (const TechniqueRow* technique = pane < state.panes.size() ? findTechnique(state.panes[pane].technique) : nullptr)
        if (const auto made = resources.accelerationMaps.make(*technique, effectiveParameters(state, pane), *resources.material); !made)
            return tl::unexpected(made.error());
    const int side = largestTile(still);
    Framebuffer framebuffer;
    for (int top = 0; top < still.height; top += side)
        for (int left = 0; left < still.width; left += side) {
            if (progress.cancelled())
                return cancelled("the picture");
            const Tile tile{left, top, std::min(side, still.width - left), std::min(side, still.height - top)};
            if (const auto made = framebuffer.resize(tile.width, tile.height, still.type != PixelType::U8); !made)
                return tl::unexpected(made.error());
            const bool isWhole = tile.width == still.width && tile.height == still.height;
            const auto draw = [&](int i) {
                DrawRequest request(state, pane, resources,
                    {.framebuffer = framebuffer.handle(),
                        .width = tile.width,
                        .height = tile.height,
                        .linear = still.type == PixelType::F32,
                        .jitter = still.samples == 1 ? glm::vec2(0.f) : pixelShift(i),
                        .lens = still.samples == 1 ? glm::vec2(0.f) : lensPoint(i),
                        .wholeWidth = isWhole ? 0 : still.width,
                        .wholeHeight = isWhole ? 0 : still.height,
                        .left = tile.left,
                        .below = still.height - tile.top - tile.height},
                    still.view);
                request.compareWith(still.exact);
                return renderer.draw(request);
            };
            if (const auto drawn = drawTile(*image, tile, still, draw); !drawn)
                return tl::unexpected(drawn.error());
            progress.at(float(double(top) + double(tile.height) * double(left + tile.width) / double(still.width)) / float(still.height));
        }
    return image;
}

Expected<Image> drawPicture(Renderer& renderer, const State& state, std::size_t pane, Resources& resources, std::string_view view,
    int width, int height, int samples, bool linear, const std::shared_ptr<const ExactDistances>& exact)
{
    return drawStill(renderer, state, pane, resources,
        {.view = view,
            .width = width,
            .height = height,
            .samples = samples,
            .type = linear ? PixelType::F32 : PixelType::U8,
            .exact = exact});
}

} // namespace relievo
