// Prefiltering by importance sampling.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment/prefilter.h"
#include "core/image/environment/directions.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {
constexpr int kSideOfRough = 16, kSideOfMatt = 8;

int sharpLevels(int side) // before that of roughness 1
{
    int levels = 0;
    while (side >> levels > kSideOfRough)
        ++levels;
    return levels;
}

// One direction of the lobe about +z, and from which of the halved cubes it reads.
struct LobeSample {
    glm::vec3 towards;
    float weight;
    std::size_t source;
};

std::vector<LobeSample> lobeSamples(float roughness, int count, int sourceSide, std::size_t sources)
{
    const float alpha2 = roughness * roughness * roughness * roughness;
    std::vector<LobeSample> samples;
    float total = 0.f;
    for (int i = 0; i < count; ++i) {
        const float u = (float(i) + 0.5f) / float(count), turn = 2.f * kPi * std::fmod(float(i) * 0.618034f, 1.f);
        const float cosHalf2 = (1.f - u) / (1.f + (alpha2 - 1.f) * u), cosine = 2.f * cosHalf2 - 1.f;
        if (cosine <= 0.f)
            continue;
        const float sine = std::sqrt(std::max(0.f, 1.f - cosine * cosine)), d = cosHalf2 * (alpha2 - 1.f) + 1.f;
        const float density = alpha2 / (kPi * d * d) / 4.f; // of the reflected direction: D(h) (n . h) / (4 v . h), and n = v
        const float texel = 4.f * kPi / (6.f * float(sourceSide) * float(sourceSide));
        const float level = 0.5f * std::log2(1.f / (float(count) * density) / texel) + 0.5f; // half a level of overlap
        samples.push_back({{sine * std::cos(turn), sine * std::sin(turn), cosine}, cosine,
            std::size_t(std::clamp(std::lround(level), 0L, long(sources) - 1))});
        total += cosine;
    }
    for (LobeSample& sample : samples)
        sample.weight /= total;
    return samples;
}

// A cube as it is seen with each of its faces in the place of the first: what is asked of one face's directions is answered for all six.
struct SixFold {
    explicit SixFold(const Cube& cube) : side(cube.side), texels(cube.texels.size())
    {
        for (int first = 0; first < 6; ++first) {
            const glm::vec3 middle = cubeDirection({first, 0.f, 0.f});
            const glm::vec3 right = cubeDirection({first, 1.f, 0.f}) - middle, down = cubeDirection({first, 0.f, 1.f}) - middle;
            const auto index = [&](int face, int x, int y) {
                const glm::vec3 d = cubeDirection({face, texelPlace(x, side), texelPlace(y, side)});
                return std::ptrdiff_t(texelIndex(side, d.x * middle - d.z * right - d.y * down));
            };
            tbb::parallel_for(0, 6 * side, [&](int row) { // a turned face is its rows or columns in some order
                const std::ptrdiff_t start = index(row / side, 0, row % side), step = index(row / side, 1, row % side) - start;
                for (int x = 0; x < side; ++x)
                    texels[std::size_t(row * side + x)][std::size_t(first)] = cube.texels[std::size_t(start + x * step)];
            });
        }
    }
    int side;
    std::vector<std::array<glm::vec3, 6>> texels;
};

Cube reflected(const std::vector<SixFold>& halves, int side, float roughness, int count)
{
    const std::vector<LobeSample> samples = lobeSamples(roughness, count, halves.front().side, halves.size());
    Cube cube{side, std::vector<glm::vec3>(6 * std::size_t(side) * std::size_t(side))};
    tbb::parallel_for(0, side * side, [&](int i) {
        const glm::vec3 n = glm::normalize(cubeDirection({0, texelPlace(i % side, side), texelPlace(i / side, side)}));
        const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.f, 1.f, 0.f), n)), up = glm::cross(n, right);
        std::array<glm::vec3, 6> sums{};
        for (const LobeSample& sample : samples) {
            const SixFold& source = halves[sample.source];
            const auto& seen
                = source.texels[texelIndex(source.side, sample.towards.x * right + sample.towards.y * up + sample.towards.z * n)];
            for (std::size_t face = 0; face < 6; ++face)
                sums[face] += sample.weight * seen[face];
        }
        for (std::size_t face = 0; face < 6; ++face)
            cube.texels[face * std::size_t(side * side) + std::size_t(i)] = sums[face];
    });
    return cube;
}

// Irradiance / pi, by the sum over all texels.
Cube matt(const Cube& cube, int side)
{
    struct Source {
        glm::vec3 towards;
        float share;
    };
    std::vector<Source> sources;
    for (int i = 0; i < 6 * cube.side * cube.side; ++i) {
        const float a = texelPlace(i % cube.side, cube.side), b = texelPlace(i / cube.side % cube.side, cube.side);
        sources.push_back({glm::normalize(cubeDirection({i / (cube.side * cube.side), a, b})), texelShare(a, b)});
    }
    return cubeOf(side, [&](glm::vec3 n) {
        glm::vec3 sum(0.f);
        float total = 0.f;
        for (std::size_t i = 0; i < sources.size(); ++i) {
            const float weight = std::max(glm::dot(n, sources[i].towards), 0.f) * sources[i].share;
            sum += weight * cube.texels[i];
            total += weight;
        }
        return sum / total;
    });
}
} // namespace

int levelCount(int side)
{
    return sharpLevels(side) + 2;
}

// The other way round than in the shader, which goes to level x sharp levels with x = roughness (2 - roughness).
float roughnessOfLevel(int level, int side)
{
    return 1.f - std::sqrt(1.f - float(level) / float(sharpLevels(side)));
}

std::vector<Cube> prefiltered(Cube sharp)
{
    std::vector<SixFold> halves;
    Cube half = halved(sharp), small = half;
    for (; half.side >= 2; half = halved(half)) {
        halves.emplace_back(half);
        if (half.side >= kSideOfRough)
            small = half;
    }
    const int side = sharp.side, rough = sharpLevels(side);
    std::vector<Cube> levels = {std::move(sharp)};
    for (int level = 1; level < rough; ++level)
        levels.push_back(reflected(halves, side >> level, roughnessOfLevel(level, side), std::clamp(16 << 2 * level, 64, 2048)));
    for (const int last : {kSideOfRough, kSideOfMatt}) // the lobe of roughness 1 is the cosine, seen from above
        levels.push_back(matt(small, last));
    return levels;
}

} // namespace relievo
