// Whole pictures: draw, average shifted pixel grids, read back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/windowless.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <epoxy/gl.h>

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

Image imageOf(const std::vector<float>& sums, int width, int height, int samples, bool linear)
{
    Image image{width, height, 4, linear ? PixelType::F32 : PixelType::U8, linear ? 32 : 8, linear, {}};
    image.data.resize(sums.size() * bytesOf(image.type));
    const std::size_t rowValues = std::size_t(width) * 4;
    for (std::size_t y = 0; y < std::size_t(height); ++y)
        for (std::size_t i = 0; i < rowValues; ++i) {
            const float value = sums[(std::size_t(height) - 1 - y) * rowValues + i] / float(samples); // OpenGL's row 0 is at the bottom
            const std::size_t at = y * rowValues + i;
            if (linear)
                std::memcpy(image.data.data() + at * 4, &value, 4);
            else
                image.data[at] = std::byte(std::lround(value * 255.f));
        }
    return image;
}

} // namespace

Expected<Image> drawPicture(Renderer& renderer, const State& state, std::size_t pane, const Resources& resources, std::string_view view,
    int width, int height, int samples, bool linear)
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    if (width < 1 || height < 1 || width > limit || height > limit)
        return failure("--size", std::to_string(width) + "x" + std::to_string(height) + " cannot be drawn",
            "1x1 to " + std::to_string(limit) + "x" + std::to_string(limit) + " pixels are possible here");
    Framebuffer framebuffer;
    framebuffer.resize(width, height, linear);
    std::vector<float> sums(std::size_t(width) * std::size_t(height) * 4), values(sums.size());
    for (int i = 0; i < samples; ++i) {
        const glm::vec2 jitter = samples == 1 ? glm::vec2(0.f) : glm::vec2(radicalInverse(i + 1, 2), radicalInverse(i + 1, 3)) - 0.5f;
        if (auto drawn = renderer.draw(state, pane, resources, view, {framebuffer.handle(), width, height, linear, 1.f, jitter}); !drawn)
            return tl::unexpected(drawn.error());
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, values.data());
        std::ranges::transform(sums, values, sums.begin(), std::plus<>());
    }
    return imageOf(sums, width, height, samples, linear);
}

} // namespace relievo
