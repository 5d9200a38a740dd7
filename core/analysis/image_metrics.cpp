// PSNR, and FLIP as its paper describes it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/image_metrics.h"
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace relievo {

namespace flip { // what Flip::Parts holds
using Plane = std::vector<float>;

struct Picture {
    int width = 0, height = 0;
    std::array<Plane, 3> planes;
    explicit Picture(int w, int h) : width(w), height(h) { planes.fill(Plane(std::size_t(w) * std::size_t(h))); }
    glm::vec3 at(std::size_t i) const { return {planes[0][i], planes[1][i], planes[2][i]}; }
    void set(std::size_t i, glm::vec3 v)
    {
        for (std::size_t c = 0; c < 3; ++c)
            planes[c][i] = v[int(c)];
    }
};

struct Features {
    Plane edges, points; // strengths
};
} // namespace flip

namespace {

using flip::Features, flip::Picture, flip::Plane;
using Kernel = std::vector<float>; // odd length, centre in the middle
constexpr double kPi = std::numbers::pi;

// Constants of the paper: section 4.1.1 (contrast sensitivity), 4.1.3 and 4.2 (colour), 4.3 (features), 4.4 (combination).
constexpr float kColorPower = 0.7f, kColorKnee = 0.4f, kColorKneeValue = 0.95f;
constexpr double kFeatureWidth = 0.082; // degrees
constexpr double kWidestSensitivity = 0.04; // largest b of the tables below

struct Gaussian { // a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees
    double a, b;
};

const glm::mat3 kXyzFromRgb
    = glm::transpose(glm::mat3(0.4123908f, 0.3575843f, 0.1804808f, 0.2126390f, 0.7151687f, 0.0721923f, 0.0193308f, 0.1191948f, 0.9505322f));
const glm::vec3 kWhite = kXyzFromRgb * glm::vec3(1.f);

float linearOf(float srgb)
{
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

// Luminance and two chromatic differences, linear in light (YCxCz).
glm::vec3 opponentOf(glm::vec3 linear)
{
    const glm::vec3 n = kXyzFromRgb * linear / kWhite;
    return {116.f * n.y - 16.f, 500.f * (n.x - n.y), 200.f * (n.y - n.z)};
}

glm::vec3 linearOf(glm::vec3 opponent)
{
    static const glm::mat3 rgbFromXyz = glm::inverse(kXyzFromRgb);
    const float y = (opponent.x + 16.f) / 116.f;
    return rgbFromXyz * (glm::vec3(y + opponent.y / 500.f, y, y - opponent.z / 200.f) * kWhite);
}

// CIELAB whose chroma fades with the lightness (Hunt effect).
glm::vec3 huntLabOf(glm::vec3 linear)
{
    const auto f = [](float t) { return t > 0.008856452f ? std::cbrt(t) : t * 7.787037f + 4.f / 29.f; };
    const glm::vec3 n = kXyzFromRgb * linear / kWhite;
    const float y = f(n.y), lightness = 116.f * y - 16.f;
    return {lightness, 0.01f * lightness * 500.f * (f(n.x) - y), 0.01f * lightness * 200.f * (y - f(n.z))};
}

float hybridDistance(glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// each(i) of all pixels, on all threads.
void forEach(std::size_t count, const auto& each)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            each(i);
    });
}

Picture opponentPicture(const Image& image)
{
    Picture out(image.width, image.height);
    std::array<float, 256> linear;
    for (int i = 0; i < 256; ++i)
        linear[std::size_t(i)] = linearOf(float(i) / 255.f);
    const std::size_t channels = std::size_t(image.channels);
    forEach(image.texelCount(), [&](std::size_t i) {
        const auto value = [&](std::size_t c) { return linear[std::to_integer<std::size_t>(image.data[i * channels + c])]; };
        out.set(i, opponentOf({value(0), value(1), value(2)}));
    });
    return out;
}

Kernel kernelOf(int radius, auto weight)
{
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i)
        kernel.push_back(float(weight(double(i))));
    return kernel;
}
// Positive weights sum to 1, negative ones to -1.
Kernel balanced(Kernel kernel)
{
    float positive = 0.f, negative = 0.f;
    for (const float w : kernel)
        (w > 0.f ? positive : negative) += w;
    for (float& w : kernel)
        w /= w > 0.f ? positive : -negative;
    return kernel;
}

// to[i] += weight * from[i]
void add(float* to, const float* from, float weight, int count)
{
    for (int i = 0; i < count; ++i)
        to[i] += weight * from[i];
}

// Outside the picture its border goes on.
Plane filteredRows(const Plane& plane, int width, int height, const Kernel& kernel)
{
    Plane out(plane.size());
    const int radius = int(kernel.size()) / 2;
    tbb::parallel_for(0, height, [&](int y) {
        const float* row = &plane[std::size_t(y) * std::size_t(width)];
        std::vector<float> padded(std::size_t(radius), row[0]);
        padded.insert(padded.end(), row, row + width);
        padded.insert(padded.end(), std::size_t(radius), row[width - 1]);
        for (std::size_t k = 0; k < kernel.size(); ++k)
            add(&out[std::size_t(y) * std::size_t(width)], &padded[k], kernel[k], width);
    });
    return out;
}
Plane filteredColumns(const Plane& plane, int width, int height, const Kernel& kernel)
{
    Plane out(plane.size());
    const int radius = int(kernel.size()) / 2;
    tbb::parallel_for(0, height, [&](int y) {
        for (int k = -radius; k <= radius; ++k) {
            const int from = std::clamp(y + k, 0, height - 1);
            add(&out[std::size_t(y) * std::size_t(width)], &plane[std::size_t(from) * std::size_t(width)], kernel[std::size_t(k + radius)],
                width);
        }
    });
    return out;
}
Plane filtered(const Plane& plane, int width, int height, const Kernel& alongX, const Kernel& alongY)
{
    return filteredColumns(filteredRows(plane, width, height, alongX), width, height, alongY);
}

// What the eye's contrast sensitivity leaves of a channel: a sum of two Gaussians whose weights make the whole kernel sum to 1.
Plane seen(const Plane& plane, int width, int height, std::array<Gaussian, 2> sensitivity, double perDegree)
{
    const int radius = int(std::ceil(3. * std::sqrt(kWidestSensitivity / (2. * kPi * kPi)) * perDegree));
    Plane sum(plane.size());
    std::array<Kernel, 2> kernels;
    std::array<double, 2> weights{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double a = sensitivity[i].a, b = sensitivity[i].b;
        kernels[i] = kernelOf(radius, [&](double x) { return std::exp(-kPi * kPi * x * x / (perDegree * perDegree * b)); });
        const double one = std::accumulate(kernels[i].begin(), kernels[i].end(), 0.);
        weights[i] = a * std::sqrt(kPi / b) * one * one;
        for (float& w : kernels[i])
            w = float(w / one);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (weights[i] == 0.)
            continue;
        const float weight = float(weights[i] / (weights[0] + weights[1]));
        const Plane part = filtered(plane, width, height, kernels[i], kernels[i]);
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += weight * part[k];
    }
    return sum;
}

// Section 4.1: what is left after the eye's blur, in the space where distances are perceived.
Picture perceived(const Picture& opponent, double perDegree)
{
    constexpr std::array<std::array<Gaussian, 2>, 3> kSensitivity
        = {{{{{1., 0.0047}, {0., 1e-5}}}, {{{1., 0.0053}, {0., 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};
    Picture out(opponent.width, opponent.height);
    for (std::size_t c = 0; c < 3; ++c)
        out.planes[c] = seen(opponent.planes[c], opponent.width, opponent.height, kSensitivity[c], perDegree);
    forEach(out.planes[0].size(), [&](std::size_t i) { out.set(i, huntLabOf(glm::clamp(linearOf(out.at(i)), 0.f, 1.f))); });
    return out;
}

// Section 4.2: the distance compressed, and bent so that large ones do not drown the small.
float colorDifference(glm::vec3 a, glm::vec3 b)
{
    static const float most
        = std::pow(hybridDistance(huntLabOf({0.f, 1.f, 0.f}), huntLabOf({0.f, 0.f, 1.f})), kColorPower); // green against blue
    const float d = std::pow(hybridDistance(a, b), kColorPower), knee = kColorKnee * most;
    return d < knee ? kColorKneeValue * d / knee : kColorKneeValue + (d - knee) / (most - knee) * (1.f - kColorKneeValue);
}

// Section 4.3: strengths of edges (first derivative) and points (second derivative) of the lightness.
Features featuresOf(const Picture& opponent, double perDegree)
{
    Plane lightness = opponent.planes[0];
    for (float& v : lightness)
        v = (v + 16.f) / 116.f;
    const double deviation = 0.5 * kFeatureWidth * perDegree, square = deviation * deviation;
    const int radius = int(std::ceil(3. * deviation));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2. * square)); };
    const Kernel flat = balanced(kernelOf(radius, gauss));
    const Kernel edge = balanced(kernelOf(radius, [&](double x) { return -x * gauss(x); }));
    const Kernel point = balanced(kernelOf(radius, [&](double x) { return (x * x / square - 1.) * gauss(x); }));
    const auto strength = [&](const Kernel& kernel) {
        Plane x = filtered(lightness, opponent.width, opponent.height, kernel, flat);
        const Plane y = filtered(lightness, opponent.width, opponent.height, flat, kernel);
        forEach(x.size(), [&](std::size_t i) { x[i] = std::hypot(x[i], y[i]); });
        return x;
    };
    return {strength(edge), strength(point)};
}

} // namespace

double psnr(const Image& a, const Image& b)
{
    assert(a.width == b.width && a.height == b.height && a.type == PixelType::U8 && b.type == PixelType::U8);
    double squares = 0.;
    for (std::size_t i = 0; i < a.texelCount(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = double(std::to_integer<int>(a.data[i * std::size_t(a.channels) + c]))
                - double(std::to_integer<int>(b.data[i * std::size_t(b.channels) + c]));
            squares += d * d;
        }
    if (squares == 0.)
        return std::numeric_limits<double>::infinity();
    return 10. * std::log10(255. * 255. * 3. * double(a.texelCount()) / squares);
}

struct Flip::Parts {
    Picture lab;
    Features features;
    Parts(const Picture& opponent, double perDegree) : lab(perceived(opponent, perDegree)), features(featuresOf(opponent, perDegree)) { }
};

Flip::Flip(const Image& reference, double pixelsPerDegree)
    : m_reference(std::make_shared<const Parts>(opponentPicture(reference), pixelsPerDegree))
    , m_pixelsPerDegree(pixelsPerDegree)
{
    assert(reference.type == PixelType::U8 && reference.channels >= 3);
}

std::vector<float> Flip::map(const Image& test) const
{
    assert(test.width == m_reference->lab.width && test.height == m_reference->lab.height);
    assert(test.type == PixelType::U8 && test.channels >= 3);
    const Parts& a = *m_reference;
    const Parts b(opponentPicture(test), m_pixelsPerDegree);
    std::vector<float> map(test.texelCount());
    forEach(map.size(), [&](std::size_t i) {
        const float edge = std::abs(a.features.edges[i] - b.features.edges[i]);
        const float point = std::abs(a.features.points[i] - b.features.points[i]);
        const float feature = std::sqrt(std::clamp(std::max(edge, point) / std::numbers::sqrt2_v<float>, 0.f, 1.f));
        map[i] = std::pow(colorDifference(a.lab.at(i), b.lab.at(i)), 1.f - feature);
    });
    return map;
}

double Flip::mean(const Image& test) const
{
    const std::vector<float> all = map(test);
    return all.empty() ? 0. : std::accumulate(all.begin(), all.end(), 0.) / double(all.size());
}

} // namespace relievo
