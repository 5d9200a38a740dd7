// The nearest and the furthest crossing of each ray, shaded and averaged over texels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/side_pictures.h"
#include "core/ground/srgb.h"
#include "core/object/bake/columns.h"
#include "core/object/bake/dilate.h"
#include <atomic>
#include <glm/geometric.hpp>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {

namespace {
constexpr std::uint32_t kNone = ~std::uint32_t(0);

struct First {
    float depth = 0.f;
    std::uint32_t triangle = kNone;
    glm::vec2 weights{0.f}; // of the first two corners
};

// Of a side, while it is made: colours and coverage, normals and roughness.
struct Side {
    std::vector<glm::vec4> color, look;
    std::vector<float> filled; // share of rays
    glm::dvec3 outwards{0.};
};

class Baker {
public:
    Baker(const MeshSurface& surface, const ObjectBox& box, std::size_t axis, const ObjectOptions& options)
        : m_surface(surface)
        , m_box(box)
        , m_axis(axis)
        , m_size(options.size)
        , m_times(options.supersample)
        , m_bands(
              surface.mesh().indices.size() / 3, [this](std::size_t t) { return corners(t); }, options.size)
    {
        const auto texels = std::size_t(m_size) * std::size_t(m_size);
        for (Side& side : m_sides) {
            side.color.resize(texels, glm::vec4(0.f));
            side.look.resize(texels, glm::vec4(0.f));
            side.filled.resize(texels, 0.f);
        }
        m_sides[0].outwards = -kAxisFrames[axis].depth;
        m_sides[1].outwards = kAxisFrames[axis].depth;
    }

    bool bake(const Progress& progress)
    {
        std::atomic<int> done = 0;
        oneapi::tbb::parallel_for(0, m_bands.count(), [&](int band) {
            if (progress.cancelled())
                return;
            bakeBand(band);
            progress.at(0.8f * float(++done) / float(m_bands.count()));
        });
        return !progress.cancelled();
    }

    SidePictures pictures(std::size_t number)
    {
        Side& side = m_sides[number];
        dilate(side.color, side.filled, m_size, m_size);
        dilate(side.look, side.filled, m_size, m_size);
        SidePictures out{empty(4), empty(3), empty(1)};
        oneapi::tbb::parallel_for(std::size_t(0), side.filled.size(), [&](std::size_t i) {
            const glm::vec4 color = side.color[i], look = side.look[i];
            const glm::vec3 normal(look), up = glm::dot(normal, normal) > 1e-12f ? glm::normalize(normal) : glm::vec3(0.f, 0.f, 1.f);
            for (int c = 0; c < 3; ++c) {
                put(out.color, 4 * i + std::size_t(c), srgbOf(color[c]));
                put(out.normal, 3 * i + std::size_t(c), 0.5f + 0.5f * up[c]);
            }
            put(out.color, 4 * i + 3, side.filled[i]);
            put(out.roughness, i, look.w);
        });
        side = {};
        return out;
    }

private:
    Winding::Triangle corners(std::size_t triangle) const
    {
        auto c = cornersOf(m_surface.mesh(), triangle);
        for (glm::dvec3& corner : c)
            corner = m_box.onAxis(m_axis, corner);
        return c;
    }
    Image empty(int channels) const
    {
        Image image{m_size, m_size, channels, PixelType::U16, 16, false, {}};
        image.data.resize(image.texelCount() * std::size_t(channels) * sizeof(std::uint16_t));
        return image;
    }
    static void put(Image& image, std::size_t at, float value)
    {
        reinterpret_cast<std::uint16_t*>(image.data.data())[at] = std::uint16_t(std::lround(std::clamp(value, 0.f, 1.f) * 65535.f));
    }

    void bakeBand(int band)
    {
        const int width = m_size * m_times, firstTexel = band * kBandRows, rows = std::min(kBandRows, m_size - firstTexel);
        const RayGrid grid{width, width, firstTexel * m_times, (firstTexel + rows) * m_times};
        std::array<std::vector<First>, 2> first;
        first.fill(std::vector<First>(std::size_t(width) * std::size_t(rows * m_times)));
        for (const std::uint32_t triangle : m_bands.of(band)) {
            const auto c = corners(triangle);
            forCrossings(grid, {glm::dvec2(c[0]), glm::dvec2(c[1]), glm::dvec2(c[2])}, [&](const RayCrossing& at) {
                const auto depth = float(c[0].z * at.weights.x + c[1].z * at.weights.y + c[2].z * at.weights.z);
                const std::size_t ray = std::size_t(at.y - grid.rowFrom) * std::size_t(width) + std::size_t(at.x);
                First &near = first[0][ray], &far = first[1][ray];
                const bool isNearest = near.triangle == kNone || depth < near.depth,
                           isFurthest = far.triangle == kNone || depth > far.depth;
                if ((!isNearest && !isFurthest) || !m_surface.isOpaque(triangle, at.weights))
                    return;
                const First found{depth, triangle, glm::vec2(at.weights)};
                if (isNearest)
                    near = found;
                if (isFurthest)
                    far = found;
            });
        }
        for (std::size_t s = 0; s < 2; ++s)
            for (std::size_t ray = 0; ray < first[s].size(); ++ray)
                if (first[s][ray].triangle != kNone) {
                    const std::size_t x = ray % std::size_t(width) / std::size_t(m_times);
                    const std::size_t y = std::size_t(firstTexel) + ray / std::size_t(width) / std::size_t(m_times);
                    add(m_sides[s], y * std::size_t(m_size) + x, first[s][ray]);
                }
        for (Side& side : m_sides)
            for (auto i = std::size_t(firstTexel) * std::size_t(m_size), end = i + std::size_t(rows) * std::size_t(m_size); i < end; ++i)
                if (side.filled[i] > 0.f) {
                    side.color[i] /= side.filled[i];
                    side.look[i] /= side.filled[i];
                    side.filled[i] /= float(m_times * m_times);
                }
    }

    void add(Side& side, std::size_t texel, const First& first)
    {
        const SurfacePoint point = m_surface.at(first.triangle, {first.weights, 1.f - first.weights.x - first.weights.y});
        const AxisFrame& frame = kAxisFrames[m_axis];
        const glm::dvec3 normal(point.normal);
        const double out = glm::dot(normal, side.outwards);
        const double turn = out < 0. && isSeenFromBehind(first.triangle, side) ? -1. : 1.;
        side.color[texel] += glm::vec4(point.color, 0.f);
        side.look[texel]
            += glm::vec4(turn * glm::dvec3(glm::dot(normal, frame.u), -glm::dot(normal, frame.v), out), double(point.roughness));
        side.filled[texel] += 1.f;
    }

    bool isSeenFromBehind(std::uint32_t triangle, const Side& side) const
    {
        const auto c = cornersOf(m_surface.mesh(), triangle);
        return glm::dot(glm::cross(c[1] - c[0], c[2] - c[0]), side.outwards) < 0.;
    }

    const MeshSurface& m_surface;
    const ObjectBox m_box;
    const std::size_t m_axis;
    const int m_size, m_times;
    const Bands m_bands;
    std::array<Side, 2> m_sides; // front, back
};
} // namespace

Expected<AxisPictures> bakePictures(
    const MeshSurface& surface, const ObjectBox& box, std::size_t axis, const ObjectOptions& options, const Progress& progress)
{
    Baker baker(surface, box, axis, options);
    if (!baker.bake(progress))
        return cancelled(surface.mesh().name);
    AxisPictures pictures{baker.pictures(0), baker.pictures(1)};
    progress.at(1.f);
    return pictures;
}

} // namespace relievo
