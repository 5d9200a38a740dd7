// Thumbnails by sparse sampling, so that a large map costs no more than a small one.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/thumbnails.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>

namespace relievo {
namespace {
constexpr int kSamples = 4; // along each side of a pixel

struct Source {
    int width, height;
    std::function<glm::vec3(int, int)> texel; // display values in [0, 1]
};

float display(float v, bool encode)
{
    v = std::isfinite(v) ? std::clamp(v, 0.f, 1.f) : 0.f;
    return encode ? std::pow(v, 1.f / 2.2f) : v;
}

QImage shrink(const Source& source, int size)
{
    const double scale = double(size) / std::max(source.width, source.height);
    QImage picture(std::max(1, int(source.width * scale)), std::max(1, int(source.height * scale)), QImage::Format_RGB32);
    const auto at = [](int pixel, int sample, int pixels, int texels) {
        return std::min(texels - 1, int((pixel + (sample + 0.5) / kSamples) * texels / pixels));
    };
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            glm::vec3 sum(0.f);
            for (int k = 0; k < kSamples * kSamples; ++k)
                sum += source.texel(
                    at(x, k % kSamples, picture.width(), source.width), at(y, k / kSamples, picture.height(), source.height));
            sum *= 255.f / float(kSamples * kSamples);
            picture.setPixel(x, y, qRgb(int(sum.x), int(sum.y), int(sum.z)));
        }
    return picture;
}
} // namespace

QImage thumbnail(const Material& material, MapKind kind, int size)
{
    if (kind == MapKind::Height) {
        if (!material.height)
            return {};
        const HeightField& field = *material.height;
        return shrink({field.width(), field.height(), [&](int x, int y) { return glm::vec3(field.texel(x, y)); }}, size);
    }
    const Image* image = material.map(kind);
    if (!image)
        return {};
    const bool encode = row(kind).isColor && image->type == PixelType::F32;
    return shrink({image->width, image->height,
                      [&](int x, int y) {
                          const auto channel = [&](int c) { return display(image->value(x, y, std::min(c, image->channels - 1)), encode); };
                          return glm::vec3(channel(0), channel(1), channel(2));
                      }},
        size);
}

QString mapFacts(const Material& material, MapKind kind)
{
    const auto facts = [](int width, int height, int bits, bool isFloat) {
        return QString("%1 \u00d7 %2   %3 bit%4").arg(width).arg(height).arg(bits).arg(isFloat ? " float" : "");
    };
    if (kind == MapKind::Height)
        return material.height ? facts(material.height->width(), material.height->height(), material.height->storedBits(), false)
                               : QString();
    const Image* image = material.map(kind);
    return image ? facts(image->width, image->height, image->storedBits, image->storedFloat) : QString();
}

} // namespace relievo
