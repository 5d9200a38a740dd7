// Whole pictures: draw, average shifted pixel grids, read back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/windowless.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <epoxy/gl.h>
#include <functional>
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

// Sums of `samples` pictures, OpenGL's row 0 at the bottom. T: what one picture's values are, Sum: what holds 64 of them.
template <class T, class Sum>
Expected<std::vector<Sum>> summed(
    GLenum type, std::size_t count, int samples, const std::function<Expected<void>(int)>& draw, int width, int height)
{
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

// Display values. Colour was averaged with the black of pixels that nothing covers; PNG wants it without that.
Image displayImage(const std::vector<std::uint16_t>& sums, int width, int height, int samples)
{
    Image image{width, height, 4, PixelType::U8, 8, false, {}};
    image.data.resize(sums.size());
    const std::size_t rowValues = std::size_t(width) * 4;
    for (std::size_t y = 0; y < std::size_t(height); ++y)
        for (std::size_t x = 0; x < rowValues; x += 4) {
            const std::uint16_t* from = &sums[(std::size_t(height) - 1 - y) * rowValues + x];
            std::byte* to = &image.data[y * rowValues + x];
            const float alpha = float(from[3]) / float(255 * samples);
            for (int c = 0; c < 3; ++c)
                to[c] = std::byte(alpha > 0.f ? std::lround(std::min(float(from[c]) / float(samples) / alpha, 255.f)) : 0);
            to[3] = std::byte(std::lround(alpha * 255.f));
        }
    return image;
}

Image linearImage(const std::vector<float>& sums, int width, int height, int samples)
{
    Image image{width, height, 4, PixelType::F32, 32, true, {}};
    image.data.resize(sums.size() * 4);
    const std::size_t rowValues = std::size_t(width) * 4;
    for (std::size_t y = 0; y < std::size_t(height); ++y)
        for (std::size_t x = 0; x < rowValues; ++x) {
            const float value = sums[(std::size_t(height) - 1 - y) * rowValues + x] / float(samples);
            std::memcpy(image.data.data() + (y * rowValues + x) * 4, &value, 4);
        }
    return image;
}

} // namespace

glm::vec2 pixelShift(int k)
{
    return glm::vec2(radicalInverse(k + 1, 2), radicalInverse(k + 1, 3)) - 0.5f;
}

Expected<Image> drawPicture(Renderer& renderer, const State& state, std::size_t pane, Resources& resources, std::string_view view,
    int width, int height, int samples, bool linear, const std::shared_ptr<const ExactDistances>& exact)
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    if (width < 1 || height < 1 || width > limit || height > limit || std::size_t(width) * std::size_t(height) > kMaxPicturePixels)
        return failure("--size", std::to_string(width) + "x" + std::to_string(height) + " cannot be drawn",
            "Up to " + std::to_string(limit) + " pixels a side and " + std::to_string(kMaxPicturePixels / 1'000'000)
                + " million in all are possible here");
    if (const TechniqueRow* technique = pane < state.panes.size() ? findTechnique(state.panes[pane].technique) : nullptr)
        if (const auto made = resources.accelerationMaps.make(*technique, effectiveParameters(state, pane), *resources.material); !made)
            return tl::unexpected(made.error());
    Framebuffer framebuffer;
    if (const auto made = framebuffer.resize(width, height, linear); !made)
        return tl::unexpected(made.error());
    const std::size_t count = std::size_t(width) * std::size_t(height) * 4;
    const auto draw = [&](int i) {
        DrawRequest request(state, pane, resources,
            {.framebuffer = framebuffer.handle(),
                .width = width,
                .height = height,
                .linear = linear,
                .jitter = samples == 1 ? glm::vec2(0.f) : pixelShift(i)},
            view);
        request.compareWith(exact);
        return renderer.draw(request);
    };
    if (linear)
        return summed<float, float>(GL_FLOAT, count, samples, draw, width, height).map([&](const auto& sums) {
            return linearImage(sums, width, height, samples);
        });
    return summed<std::uint8_t, std::uint16_t>(GL_UNSIGNED_BYTE, count, samples, draw, width, height).map([&](const auto& sums) {
        return displayImage(sums, width, height, samples);
    });
}

} // namespace relievo
