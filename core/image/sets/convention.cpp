// Correlating normals with slopes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/convention.h"
#include "core/image/pixels.h"
#include <array>
#include <cmath>

namespace relievo {
namespace {
constexpr int kFine = 512, kCoarsening = 4; // cells along a side, and fine cells in a coarse one
constexpr int kFewest = 4; // cells below which nothing is measured
constexpr int kProbe = 256; // cells along a side where single texels are judged
constexpr double kUnitTolerance = 0.12; // of a vector's length: 8 bits, compression and filtering

// Running sums of Pearson's correlation.
class Correlation {
public:
    void add(double a, double b)
    {
        ++m_count;
        m_a += a;
        m_b += b;
        m_aa += a * a;
        m_bb += b * b;
        m_ab += a * b;
    }
    double value() const
    {
        const double n = std::max(m_count, 1.0);
        const double varA = m_aa / n - m_a / n * (m_a / n), varB = m_bb / n - m_b / n * (m_b / n);
        if (varA < 1e-12 || varB < 1e-12)
            return 0;
        return (m_ab / n - m_a / n * (m_b / n)) / std::sqrt(varA * varB);
    }

private:
    double m_count = 0, m_a = 0, m_b = 0, m_aa = 0, m_bb = 0, m_ab = 0;
};

Plane coarser(const Plane& fine)
{
    Plane plane{fine.width / kCoarsening, fine.height / kCoarsening, {}};
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            float sum = 0;
            for (int j = 0; j < kCoarsening; ++j)
                for (int i = 0; i < kCoarsening; ++i)
                    sum += fine.at(x * kCoarsening + i, y * kCoarsening + j);
            plane.values.push_back(sum / float(kCoarsening * kCoarsening));
        }
    return plane;
}

float slopeX(const Plane& p, int x, int y)
{
    return p.at(x + 1, y) - p.at(x - 1, y);
}
float slopeY(const Plane& p, int x, int y)
{
    return p.at(x, y + 1) - p.at(x, y - 1);
}

// The border is left out: not every texture tiles.
Agreement agreementOf(const Plane& red, const Plane& green, const Plane& height)
{
    Correlation alongX, alongY;
    for (int y = 1; y + 1 < height.height; ++y)
        for (int x = 1; x + 1 < height.width; ++x) {
            alongX.add(double(red.at(x, y)), double(slopeX(height, x, y)));
            alongY.add(double(green.at(x, y)), double(slopeY(height, x, y)));
        }
    return {alongX.value(), alongY.value()};
}

Channel channelOfX(NormalLayout layout)
{
    return layout == NormalLayout::AlphaGreen ? Channel::A : Channel::R;
}

double handednessOf(const Plane& red, const Plane& green)
{
    Correlation mixed;
    for (int y = 1; y + 1 < red.height; ++y)
        for (int x = 1; x + 1 < red.width; ++x)
            mixed.add(double(slopeY(red, x, y)), double(slopeX(green, x, y)));
    return -mixed.value(); // red = -dh/dx, green = +dh/dy in OpenGL style
}

// Counts texels of a sampled grid that `judge` accepts; judge gets the four channels (missing ones are 1).
template <class Judge> double share(const Image& image, Judge judge)
{
    const int stepX = std::max(1, image.width / kProbe), stepY = std::max(1, image.height / kProbe);
    int accepted = 0, count = 0;
    for (int y = 0; y < image.height; y += stepY)
        for (int x = 0; x < image.width; x += stepX, ++count) {
            std::array<float, 4> texel = {1.f, 1.f, 1.f, 1.f};
            for (int c = 0; c < image.channels; ++c)
                texel[std::size_t(c)] = image.value(x, y, c);
            accepted += judge(texel);
        }
    return count > 0 ? double(accepted) / count : 0.0;
}

bool isSigned(const Image& image)
{
    return image.type == PixelType::F32 && rangeOf(image, Channel::Rgb).first < -0.01;
}

bool constant(const Image& image, Channel channel)
{
    const auto [low, high] = rangeOf(image, channel);
    return high - low < 2.0 / 255;
}
} // namespace

double clarity(const Agreement& agreement)
{
    const double red = std::abs(agreement.red), green = std::abs(agreement.green);
    return red == 0 || green == 0 ? std::max(red, green) : std::sqrt(red * green);
}

double unitShare(const Image& image)
{
    if (image.channels < 3)
        return 0;
    const bool alreadySigned = isSigned(image);
    return share(image, [&](const std::array<float, 4>& texel) {
        const auto component = [&](std::size_t c) { return double(alreadySigned ? texel[c] : 2 * texel[c] - 1); };
        const double x = component(0), y = component(1), z = component(2);
        return z > -0.02 && std::abs(std::sqrt(x * x + y * y + z * z) - 1) < kUnitTolerance;
    });
}

NormalLayout normalLayout(const Image& image, bool namedRelief)
{
    if (image.channels == 2)
        return NormalLayout::Xy;
    if (image.channels < 3)
        return NormalLayout::Xyz;
    const double blue = rangeOf(image, Channel::B).second;
    if (constant(image, Channel::B) && (blue < 0.02 || unitShare(image) < 0.5)) {
        const bool swizzled = image.channels == 4 && constant(image, Channel::R) && alphaVaries(image);
        return swizzled ? NormalLayout::AlphaGreen : NormalLayout::Xy;
    }
    if (image.channels == 4 && constant(image, Channel::R) && !constant(image, Channel::G) && alphaVaries(image))
        return NormalLayout::AlphaGreen;
    return image.channels == 4 && reliefForm(image, namedRelief) == ReliefForm::Dual ? NormalLayout::Xy : NormalLayout::Xyz;
}

Agreement slopeAgreement(const Image& normal, const Image& height, Channel heightChannel)
{
    const int width = std::min({kFine, normal.width, height.width}), rows = std::min({kFine, normal.height, height.height});
    if (width < kFewest || rows < kFewest || normal.channels < 2)
        return {};
    const Channel x = normal.channels >= 4 ? channelOfX(normalLayout(normal)) : Channel::R;
    const Channel y = normal.channels == 2 ? Channel::A : Channel::G;
    const Plane red = coarse(normal, x, width, rows), green = coarse(normal, y, width, rows),
                heights = coarse(height, heightChannel, width, rows);
    const Agreement fine = agreementOf(red, green, heights);
    if (width < kFewest * kCoarsening || rows < kFewest * kCoarsening)
        return fine;
    const Agreement wide = agreementOf(coarser(red), coarser(green), coarser(heights));
    return clarity(wide) > clarity(fine) ? wide : fine;
}

double handedness(const Image& normal)
{
    const int width = std::min(kFine, normal.width), rows = std::min(kFine, normal.height);
    if (width < kFewest || rows < kFewest || normal.channels < 2)
        return 0;
    const Channel x = normal.channels >= 4 ? channelOfX(normalLayout(normal)) : Channel::R;
    const Channel y = normal.channels == 2 ? Channel::A : Channel::G;
    return handednessOf(coarse(normal, x, width, rows), coarse(normal, y, width, rows));
}

namespace {
// Correlation of red and green with the slopes of another channel of the same image; no layout is asked.
double ownAgreement(const Image& image, Channel height)
{
    const int width = std::min(kFine, image.width), rows = std::min(kFine, image.height);
    if (width < kFewest || rows < kFewest)
        return 0;
    const Agreement a
        = agreementOf(coarse(image, Channel::R, width, rows), coarse(image, Channel::G, width, rows), coarse(image, height, width, rows));
    return std::min(std::abs(a.red), std::abs(a.green));
}

bool looksDual(const Image& image)
{
    return share(image, [](const std::array<float, 4>& texel) {
        const float x = 2 * texel[0] - 1, y = 2 * texel[1] - 1;
        return texel[2] >= texel[3] - 1.f / 128 && x * x + y * y <= 1.05f;
    }) > 0.95;
}
} // namespace

ReliefForm reliefForm(const Image& image, bool named)
{
    if (image.channels != 4 || !alphaVaries(image))
        return ReliefForm::None;
    const bool unit = unitShare(image) > 0.8;
    if (!named && ownAgreement(image, Channel::A) < kClearAgreement)
        return ReliefForm::None;
    if (unit)
        return ReliefForm::NormalAndDepth;
    if (looksDual(image))
        return ReliefForm::Dual;
    return named && unitShare(image) > 0.4 ? ReliefForm::NormalAndDepth : ReliefForm::None;
}

} // namespace relievo
