// The exact reference beside Embree 3 on the same field as triangles: rays a second on one core, time to build, memory.
// Usage: reference_bench [FIELD or SET]...; without any: all fields by formula. Of a SET the height map is taken, in its own size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/exact_search.h"
#include "core/trace/reference.h"
#include "tests/core/image/source_support.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <embree3/rtcore.h>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <tbb/global_control.h>

using namespace relievo;

namespace {

constexpr int kSize = 1024;
constexpr int kRays = 20000;
constexpr int kRounds = 9; // one after the other, medians shown
constexpr double kDepth = 0.08; // of the tile
constexpr double kBands[][2] = {{0., 60.}, {60., 80.}, {80., 88.}};

using Heights = std::function<float(int, int)>;

float brick(int x, int y)
{
    const int row = y / 64, along = (x + row % 2 * 64) % 128, down = y % 64;
    const int edge = std::min(std::min(along, 128 - along), std::min(down, 64 - down));
    const float stone = 0.7f + 0.05f * float((row * 7 + (x + row % 2 * 64) / 128 * 13) % 5);
    return std::clamp(float(edge - 3) / 5.f, 0.f, 1.f) * stone + 0.02f * std::sin(float(x) * 0.9f + float(y) * 0.7f) + 0.03f;
}

struct NamedField {
    std::string name;
    HeightField field;
};

HeightField fieldOf(const Heights& height)
{
    std::vector<float> heights;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            heights.push_back(std::clamp(height(x, y), 0.f, 1.f));
    return {kSize, kSize, std::move(heights)};
}

std::vector<NamedField> fields()
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const float turn = 6.2831853f / kSize;
    return {
        {"needles", fieldOf([&](int, int) { return unit(random) < 0.002f ? 1.f : 0.f; })},
        {"noise", fieldOf([&](int, int) { return unit(random); })},
        {"bricks", fieldOf(brick)},
        {"smooth", fieldOf([&](int x, int y) { return 0.5f + 0.5f * std::sin(float(x) * turn * 6.f) * std::cos(float(y) * turn * 8.f); })},
        {"terraces", fieldOf([&](int x, int y) {
             return std::floor(4.f + 4.f * std::sin(float(x) * turn * 5.f + 2.f * std::cos(float(y) * turn * 3.f))) / 8.f;
         })},
        {"flat", fieldOf([](int, int) { return 0.5f; })},
    };
}

// Of processor time: others may be at work on the machine.
double secondsOf(const std::function<void()>& work)
{
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values)
{
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

// Two triangles a cell between texel centres; u, v and height as x, y, z.
class Triangles {
public:
    explicit Triangles(const HeightField& field)
    {
        rtcSetDeviceMemoryMonitorFunction(
            m_device,
            [](void* self, ssize_t bytes, bool) {
                static_cast<Triangles*>(self)->m_bytes += bytes;
                return true;
            },
            this);
        m_scene = rtcNewScene(m_device);
        const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const int width = field.width(), height = field.height();
        const std::size_t cells = std::size_t(width - 1) * std::size_t(height - 1);
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), std::size_t(width) * std::size_t(height)));
        auto* index = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 2 * cells));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                *vertex++ = (float(x) + 0.5f) / float(width);
                *vertex++ = (float(y) + 0.5f) / float(height);
                *vertex++ = field.texel(x, y);
            }
        for (int y = 0; y + 1 < height; ++y)
            for (int x = 0; x + 1 < width; ++x) {
                const unsigned a = unsigned(y * width + x), b = a + 1, c = a + unsigned(width), d = c + 1;
                for (const unsigned i : {a, b, c, b, d, c})
                    *index++ = i;
            }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(m_scene);
        rtcInitIntersectContext(&m_context);
    }
    ~Triangles()
    {
        rtcReleaseScene(m_scene);
        rtcReleaseDevice(m_device);
    }
    Triangles(const Triangles&) = delete;
    Triangles& operator=(const Triangles&) = delete;

    double hit(const SearchRay& ray)
    {
        constexpr double kAbove = 0.01; // of t, that the ray begins above the top: a hit right at its start would be missed
        const glm::dvec2 from = ray.uv - kAbove * ray.duv;
        RTCRayHit query{};
        query.ray
            = {float(from.x), float(from.y), 1.f + float(kAbove), 0.f, float(ray.duv.x), float(ray.duv.y), -1.f, 0.f, 1.0101f, ~0u, 0, 0};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(m_scene, &m_context, &query);
        return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 2. : double(query.ray.tfar) - kAbove;
    }
    long bytes() const { return m_bytes; }

private:
    std::atomic<long> m_bytes = 0;
    RTCDevice m_device = rtcNewDevice("threads=1");
    RTCScene m_scene = nullptr;
    RTCIntersectContext m_context;
};

// Uniform start and azimuth, uniform angle within the band; those whose hit lies on the triangles, so that both do the same work.
std::vector<SearchRay> rays(const HeightField& field, const ExactSearch& search, double fromDegrees, double toDegrees)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0., 1.);
    std::vector<SearchRay> list;
    const auto inside = [&](glm::dvec2 uv) {
        const glm::dvec2 border(0.5 / field.width(), 0.5 / field.height());
        return uv.x > border.x && uv.y > border.y && uv.x < 1. - border.x && uv.y < 1. - border.y;
    };
    while (list.size() < kRays) {
        const double angle = 6.283185307 * unit(random), theta = (fromDegrees + (toDegrees - fromDegrees) * unit(random)) * 0.01745329252;
        const double travel = kDepth * std::tan(theta);
        const SearchRay ray{{unit(random), unit(random)}, {travel * std::cos(angle), travel * std::sin(angle)}, std::cos(theta)};
        if (inside(ray.uv) && inside(search.hit(ray).uv))
            list.push_back(ray);
    }
    return list;
}

void compare(const std::string& name, const HeightField& field, const ExactSearch& search, Triangles& triangles, const double (&band)[2])
{
    const auto list = rays(field, search, band[0], band[1]);
    std::vector<double> walk, ours, embree, ratio, visits;
    double sum = 0., other = 0.;
    for (int round = 0; round < kRounds; ++round) {
        ours.push_back(kRays / secondsOf([&] {
            for (const SearchRay& ray : list)
                sum += search.hit(ray).t;
        }) / 1e6);
        embree.push_back(kRays / secondsOf([&] {
            for (const SearchRay& ray : list)
                other += triangles.hit(ray);
        }) / 1e6);
        ratio.push_back(ours.back() / embree.back());
    }
    walk.push_back(kRays / secondsOf([&] {
        for (const SearchRay& ray : list)
            sum += exactHit(field, ray).t;
    }) / 1e6);
    double fetches = 0.;
    for (const SearchRay& ray : list)
        fetches += search.hit(ray).fetches;
    std::printf("%-15s %2.0f-%2.0f  %8.3f  %8.3f  %8.3f  %6.2f  %6.1f  %.6f %.6f\n", name.c_str(), band[0], band[1], walk.front(),
        median(ours), median(embree), median(ratio), fetches / kRays, sum / kRays / (kRounds + 1), other / kRays / kRounds);
}

} // namespace

int main(int argc, char** argv)
{
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    std::vector<NamedField> measured = fields();
    if (!wanted.empty()) {
        const std::vector<NamedField> known = std::move(measured);
        measured.clear();
        for (const std::string& name : wanted) {
            const auto field = std::ranges::find(known, name, &NamedField::name);
            if (field != known.end())
                measured.push_back(*field);
            else if (const auto heights = test::heightsOf(name); heights && heights->width() > 1 && heights->height() > 1)
                measured.push_back({std::filesystem::path(name).filename().string().substr(0, 15), *heights});
            else
                return std::fprintf(stderr, "%s\n", heights ? "2 x 2 texels are needed" : message(heights.error()).c_str()), 1;
        }
    }
    std::printf(
        "depth %g of the tile, one core, million rays a second of processor time (medians of %d rounds, interleaved)\n", kDepth, kRounds);
    std::printf("field           degrees   walk    pyramid    Embree   ratio  visits  mean t of both\n");
    for (const NamedField& named : measured) {
        std::optional<ExactSearch> search;
        std::optional<Triangles> triangles;
        const double ours = secondsOf([&] { search.emplace(named.field); });
        const double embree = secondsOf([&] { triangles.emplace(named.field); });
        for (const auto& band : kBands)
            compare(named.name, named.field, *search, *triangles, band);
        std::printf("%-15s %d x %d texels, built in %.4f s, Embree in %.3f s; memory beside the heights %.2f MB, Embree %.1f MB\n",
            named.name.c_str(), named.field.width(), named.field.height(), ours, embree, double(search->bytes()) / 1e6,
            double(triangles->bytes()) / 1e6);
    }
}
