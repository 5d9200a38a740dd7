// The studio by formula, environments from pictures, and their prefiltering for rough surfaces.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment.h"
#include "core/ground/srgb.h"
#include "core/image/files/image_file.h"
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {
constexpr float kPi = std::numbers::pi_v<float>;
using Pixels = std::vector<glm::vec3>;

// An equirectangular picture, twice as wide as high.
struct Panorama {
    int width = 0;
    Pixels pixels;
    int height() const { return width / 2; }
};

// Direction of the centre of a texel (environment.h: u = 0.5 is -z, u grows towards +x, row 0 is up).
glm::vec3 directionOf(float column, float row, int width)
{
    const float yaw = 2.f * kPi * ((column + 0.5f) / float(width) - 0.5f);
    const int height = width / 2;
    const float polar = kPi * (row + 0.5f) / float(height);
    return {std::sin(yaw) * std::sin(polar), std::cos(polar), -std::cos(yaw) * std::sin(polar)};
}

Panorama halved(const Panorama& from)
{
    Panorama to{from.width / 2, Pixels(from.pixels.size() / 4)};
    for (int y = 0; y < to.height(); ++y) {
        const glm::vec3* above = &from.pixels[std::size_t(2 * y * from.width)];
        const glm::vec3* below = above + from.width;
        for (int x = 0; x < to.width; ++x)
            to.pixels[std::size_t(y * to.width + x)] = 0.25f * (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1]);
    }
    return to;
}

// What a lobe gives to light that arrives at an angle (its cosine) to the middle of the lobe.
// Rough reflections, with view and normal along the lobe (Karis 2013, Real Shading in Unreal Engine 4, eq. 10): D(h) (n.l).
float glossyWeight(float cosine, float roughness)
{
    if (cosine <= 0.f)
        return 0.f;
    const float alpha2 = roughness * roughness * roughness * roughness;
    const float cosHalf2 = 0.5f * (1.f + cosine); // the half vector lies at half the angle
    const float k = cosHalf2 * (alpha2 - 1.f) + 1.f;
    return alpha2 * alpha2 / (k * k) < 1e-3f ? 0.f : cosine * alpha2 / (k * k);
}

// Convolves `from` with a lobe, to `width` texels. Weights depend on two rows and a difference of columns only, so each
// pair of rows computes them once. from.width must be a multiple of width.
template <class Weight> Pixels convolved(const Panorama& from, int width, Weight weight)
{
    const int ratio = from.width / width;
    Pixels out(std::size_t(width * width / 2));
    tbb::parallel_for(0, width / 2, [&](int row) {
        const glm::vec3 middle = directionOf(0.f, float(row), width);
        std::vector<glm::vec3> sums(std::size_t(width), glm::vec3(0.f));
        std::vector<std::pair<int, float>> lobe; // column and weight for output column 0
        float total = 0.f;
        for (int y = 0; y < from.height(); ++y) {
            lobe.clear();
            const float area = std::sin(kPi * (float(y) + 0.5f) / float(from.height()));
            for (int x = 0; x < from.width; ++x) {
                const float w = weight(glm::dot(middle, directionOf(float(x), float(y), from.width))) * area;
                if (w > 0.f)
                    lobe.emplace_back(x, w);
                total += w;
            }
            const glm::vec3* source = &from.pixels[std::size_t(y * from.width)];
            for (int x = 0; x < width; ++x)
                for (const auto& [column, w] : lobe)
                    sums[std::size_t(x)] += w * source[(column + x * ratio) % from.width];
        }
        for (int x = 0; x < width; ++x)
            out[std::size_t(row * width + x)] = sums[std::size_t(x)] / total;
    });
    return out;
}

Environment prefiltered(std::string name, Panorama sharp)
{
    Environment environment{std::move(name), {}};
    const Panorama half = halved(sharp), quarter = halved(half);
    environment.levels.push_back(std::move(sharp.pixels));
    for (int level = 1; level < kEnvironmentLevels - 1; ++level) {
        const float roughness = float(level) / float(kEnvironmentLevels - 2);
        environment.levels.push_back(convolved(level == 1 ? half : quarter, kEnvironmentWidth >> level,
            [roughness](float cosine) { return glossyWeight(cosine, roughness); }));
    }
    environment.levels.push_back(
        convolved(quarter, kEnvironmentWidth >> (kEnvironmentLevels - 1), [](float cosine) { return std::max(cosine, 0.f); }));
    return environment;
}

float smooth(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3.f - 2.f * t);
}

// A lamp with soft edges: a rectangle in the plane at distance 1 along `towards`, right and up half-sizes as tangents.
struct SoftBox {
    glm::vec3 towards;
    float halfWidth, halfHeight, softness;
    glm::vec3 radiance;
};

glm::vec3 lampLight(const SoftBox& lamp, glm::vec3 direction)
{
    const glm::vec3 axis = glm::normalize(lamp.towards);
    const float along = glm::dot(direction, axis);
    if (along <= 0.05f)
        return glm::vec3(0.f);
    const glm::vec3 right = glm::normalize(glm::cross(axis, glm::vec3(0.f, 1.f, 0.f))), up = glm::cross(right, axis);
    const float x = std::abs(glm::dot(direction, right)) / along, y = std::abs(glm::dot(direction, up)) / along;
    const float inside
        = smooth(lamp.halfWidth, lamp.halfWidth - lamp.softness, x) * smooth(lamp.halfHeight, lamp.halfHeight - lamp.softness, y);
    const float falloff
        = 1.f - 0.35f * std::min((x * x + y * y) / (lamp.halfWidth * lamp.halfWidth + lamp.halfHeight * lamp.halfHeight), 1.f);
    return lamp.radiance * inside * falloff;
}

// The camera looks from +z: left is -x, behind the camera is +z.
constexpr std::array<SoftBox, 4> kLamps = {{
    {{-0.75f, 0.85f, 0.45f}, 0.62f, 0.5f, 0.1f, {7.2f, 6.75f, 6.1f}}, // key, warm, above left
    {{0.9f, 0.25f, 0.6f}, 0.42f, 0.75f, 0.3f, {1.5f, 1.75f, 2.1f}}, // fill, cool, right
    {{0.55f, 0.45f, -0.8f}, 0.14f, 0.8f, 0.07f, {6.2f, 6.4f, 6.8f}}, // rim strip, behind right
    {{-0.8f, 0.12f, -0.75f}, 0.1f, 0.6f, 0.07f, {2.6f, 2.4f, 2.2f}}, // faint strip, behind left
}};

glm::vec3 studioLight(glm::vec3 direction)
{
    // Floor, a soft bend, the wall and a slightly lit ceiling.
    const glm::vec3 floor(0.42f, 0.405f, 0.39f), wall(0.62f, 0.63f, 0.645f), ceiling(0.85f, 0.86f, 0.88f);
    glm::vec3 light = glm::mix(floor, wall, smooth(-0.35f, 0.15f, direction.y));
    light = glm::mix(light, ceiling, smooth(0.2f, 0.95f, direction.y));
    light *= 0.75f + 0.25f * smooth(-0.9f, 0.5f, -direction.x * 0.6f + direction.z * 0.5f); // brighter beside the key
    light *= 1.f - 0.35f * smooth(-0.5f, -1.f, direction.y); // darker under the object
    for (const SoftBox& lamp : kLamps)
        light += lampLight(lamp, direction);
    return light;
}

// Average over the sphere of the brightness.
float meanBrightness(const Panorama& panorama)
{
    double sum = 0, area = 0;
    for (int y = 0; y < panorama.height(); ++y) {
        const double rowArea = std::sin(double(kPi) * (y + 0.5) / panorama.height());
        for (int x = 0; x < panorama.width; ++x) {
            const glm::vec3 c = panorama.pixels[std::size_t(y * panorama.width + x)];
            sum += rowArea * double(c.x + c.y + c.z) / 3.0;
            area += rowArea;
        }
    }
    return float(sum / area);
}

// One texel as linear, finite, non-negative radiance; the largest half float bounds a sun.
glm::vec3 radianceAt(const Image& image, int x, int y)
{
    glm::vec3 c;
    for (int k = 0; k < 3; ++k) {
        const float v = image.value(x, y, image.channels >= 3 ? k : 0);
        c[k] = std::isfinite(v) ? std::clamp(image.type == PixelType::F32 ? v : linearOf(v), 0.f, 65504.f) : 0.f;
    }
    return c;
}

// Box-reduces (or repeats) to the size of level 0. Every source texel counts once: a small sun keeps its energy.
Panorama resampled(const Image& image)
{
    Panorama out{kEnvironmentWidth, Pixels(std::size_t(kEnvironmentWidth * kEnvironmentWidth / 2))};
    const auto span = [](int i, int from, int to) {
        const int first = int(std::int64_t(i) * from / to), end = int((std::int64_t(i) + 1) * from / to);
        return std::pair{first, std::max(end, first + 1)};
    };
    tbb::parallel_for(0, out.height(), [&](int row) {
        const auto [top, bottom] = span(row, image.height, out.height());
        for (int column = 0; column < out.width; ++column) {
            const auto [left, right] = span(column, image.width, out.width);
            glm::dvec3 sum(0.0);
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x)
                    sum += glm::dvec3(radianceAt(image, x, y));
            out.pixels[std::size_t(row * out.width + column)] = glm::vec3(sum / double((bottom - top) * (right - left)));
        }
    });
    return out;
}
} // namespace

Environment studioEnvironment()
{
    Panorama studio{kEnvironmentWidth, Pixels(std::size_t(kEnvironmentWidth * kEnvironmentWidth / 2))};
    tbb::parallel_for(0, studio.height(), [&](int row) {
        for (int x = 0; x < studio.width; ++x)
            studio.pixels[std::size_t(row * studio.width + x)] = studioLight(directionOf(float(x), float(row), studio.width));
    });
    const float scale = 1.f / meanBrightness(studio);
    for (glm::vec3& pixel : studio.pixels)
        pixel *= scale;
    return prefiltered("Studio", std::move(studio));
}

Expected<Environment> openEnvironment(const std::string& nameOrFile, const Progress& progress)
{
    if (nameOrFile == "studio")
        return studioEnvironment();
    const std::filesystem::path file(nameOrFile);
    const Expected<ImageRead> read = readImage(file, progress);
    if (!read)
        return tl::unexpected(read.error());
    if (read->image.width < 1 || read->image.height < 1 || read->image.channels < 1)
        return failure(nameOrFile, "the picture is empty", "Choose another environment");
    if (progress.cancelled())
        return cancelled(nameOrFile);
    return prefiltered(file.stem().string(), resampled(read->image));
}

} // namespace relievo
