// Environments from panoramas.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment/environment.h"
#include "core/ground/srgb.h"
#include "core/image/environment/directions.h"
#include "core/image/environment/prefilter.h"
#include "core/image/files/image_file.h"
#include "core/state/environments.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {
constexpr float kBrightest = 65504.f; // the largest half float

// An equirectangular picture, twice as wide as high.
struct Panorama {
    int width;
    std::vector<glm::vec3> pixels;

    int height() const { return width / 2; }
    const glm::vec3& at(int x, int y) const
    {
        return pixels[std::size_t(std::clamp(y, 0, height() - 1)) * std::size_t(width) + std::size_t((x + width) % width)];
    }
    // Bilinear.
    glm::vec3 from(glm::vec3 direction) const
    {
        const float x = (std::atan2(direction.x, -direction.z) / (2.f * kPi) + 0.5f) * float(width) - 0.5f;
        const float y = std::acos(std::clamp(direction.y, -1.f, 1.f)) / kPi * float(height()) - 0.5f;
        const int i = int(std::floor(x)), j = int(std::floor(y));
        const float fx = x - float(i), fy = y - float(j);
        return (1.f - fy) * ((1.f - fx) * at(i, j) + fx * at(i + 1, j)) + fy * ((1.f - fx) * at(i, j + 1) + fx * at(i + 1, j + 1));
    }
};

// One texel as linear, finite radiance; what is none counts as black, or as the brightest that can be held.
glm::vec3 radianceAt(const Image& image, int x, int y)
{
    glm::vec3 c;
    for (int k = 0; k < 3; ++k) {
        const float v = image.value(x, y, image.channels >= 3 ? k : 0);
        c[k] = std::isnan(v) ? 0.f : std::clamp(image.type == PixelType::F32 ? v : linearOf(v), 0.f, kBrightest);
    }
    return c;
}

// Box-reduces (or repeats). Every source texel counts once: a small sun keeps its energy.
Panorama resampled(const Image& image, int width)
{
    Panorama out{width, std::vector<glm::vec3>(std::size_t(width) * std::size_t(width / 2))};
    const auto span = [](int i, int from, int to) {
        const int first = int(std::int64_t(i) * from / to), end = int((std::int64_t(i) + 1) * from / to);
        return std::pair{first, std::max(end, first + 1)};
    };
    tbb::parallel_for(0, out.height(), [&](int row) {
        const auto [top, bottom] = span(row, image.height, out.height());
        for (int column = 0; column < width; ++column) {
            const auto [left, right] = span(column, image.width, width);
            glm::dvec3 sum(0.0);
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x)
                    sum += glm::dvec3(radianceAt(image, x, y));
            out.pixels[std::size_t(row) * std::size_t(width) + std::size_t(column)]
                = glm::vec3(sum / double((bottom - top) * (right - left)));
        }
    });
    return out;
}

// How many numbers no light has.
std::size_t oddNumbers(const Image& image)
{
    std::size_t odd = 0;
    for (int y = 0; y < image.height && image.type == PixelType::F32; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int k = 0; k < std::min(image.channels, 3); ++k)
                odd += !(image.value(x, y, k) >= 0.f && image.value(x, y, k) <= kBrightest);
    return odd;
}

// What the shape of a picture that is no panorama may mean.
std::string_view shapeMeaning(double aspect)
{
    const auto is = [aspect](double other) { return std::abs(aspect / other - 1.) < 0.02; };
    return is(6.) || is(1. / 6.)     ? "It may be the six faces of a cube in a row, which are not read as such. "
        : is(4. / 3.) || is(3. / 4.) ? "It may be a cube unfolded to a cross, which is not read as such. "
        : is(1.)                     ? "It may be a fish-eye picture or a mirror ball, which are not read as such. "
                                     : "";
}

Warnings doubtsOf(const std::string& name, const Image& image)
{
    Warnings doubts;
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height);
    const double aspect = double(image.width) / double(image.height);
    if (image.width < 16)
        doubts.push_back({"panorama-tiny", name + ": " + size + " texels are hardly a panorama; they light from all around."});
    else if (std::abs(aspect - 2.) > 0.05)
        doubts.push_back({"panorama-shape",
            name + " is " + size + ", and a panorama is twice as wide as high; it is stretched. " + std::string(shapeMeaning(aspect))
                + "Choose an equirectangular picture."});
    if (image.type != PixelType::F32)
        doubts.push_back({"panorama-dim",
            name + " has no light brighter than white, so that lamps and the sun are too weak. Choose an HDR or EXR file for true light."});
    if (const std::size_t odd = oddNumbers(image); odd > 0)
        doubts.push_back({"panorama-numbers",
            name + ": " + std::to_string(odd)
                + " of its numbers are negative, infinite, above 65504 or none at all; they count as 0 or 65504."});
    return doubts;
}

} // namespace

Expected<Environment> openEnvironment(const std::string& nameOrFile, const Progress& progress)
{
    if (isBuiltInEnvironment(nameOrFile))
        return builtInEnvironment(nameOrFile);
    const std::filesystem::path file(nameOrFile);
    const Expected<ImageRead> read = readImage(file, progress);
    if (!read)
        return tl::unexpected(read.error());
    const Image& image = read->image;
    if (image.width < 1 || image.height < 1 || image.channels < 1)
        return failure(nameOrFile, "the picture is empty", "Choose another environment");
    if (progress.cancelled())
        return cancelled(nameOrFile);
    const int side = std::clamp(int(std::bit_ceil(unsigned(image.width / 4))), kLeastEnvironmentSide, kMostEnvironmentSide);
    const Panorama panorama = resampled(image, 4 * side);
    Environment environment{file.stem().string(), prefiltered(cubeOf(side, [&](glm::vec3 towards) { return panorama.from(towards); })),
        doubtsOf(file.filename().string(), image)};
    environment.warnings.insert(environment.warnings.begin(), read->warnings.begin(), read->warnings.end());
    return environment;
}

} // namespace relievo
