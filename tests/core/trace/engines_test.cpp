// What engines draw: each technique of an engine against that engine's formula, evaluated here once more in double precision and in its
// own numbers (view vector, scale, ray height), over fields that slope and over edges.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/trace/bilinear.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

using namespace relievo;

namespace {

constexpr double kDegrees[] = {0., 30., 45., 60., 70., 80., 89.9};

// A pixel of the engine: where its mesh is seen, the unit vector to the eye in its tangent space (+u, +v, normal), the depth in UV.
struct Pixel {
    glm::dvec2 uv;
    glm::dvec3 v;
    double depth;
    const HeightField& field;

    double height(glm::dvec2 at) const { return heightAt(field, at); }
    glm::dvec2 aside() const { return {v.x, v.y}; }
};

glm::dvec2 godotDeep(const Pixel& p, double least, double most)
{
    const double layers = most + (least - most) * std::abs(p.v.z), scale = 100. * p.depth;
    const glm::dvec2 delta = p.aside() * (scale * 0.01) / layers;
    glm::dvec2 at = p.uv;
    double layer = 0., depth = 1. - p.height(at);
    while (layer < depth - 1e-12) {
        at -= delta;
        depth = 1. - p.height(at);
        layer += 1. / layers;
    }
    const double after = depth - layer, before = 1. - p.height(at + delta) - layer + 1. / layers;
    const double weight = after / (after - before);
    return at * (1. - weight) + (at + delta) * weight;
}

glm::dvec2 godotSimple(const Pixel& p)
{
    return p.uv - p.aside() * ((1. - p.height(p.uv)) * 100. * p.depth * 0.01);
}

glm::dvec2 unity(const Pixel& p)
{
    const double parallax = std::clamp(p.depth, 0.005, 0.08);
    return p.uv + (p.height(p.uv) * parallax - parallax / 2.) * p.aside() / (p.v.z + 0.42);
}

glm::dvec2 hdrp(const Pixel& p, double least, double most)
{
    const glm::dvec3 inUv = glm::normalize(glm::dvec3(p.aside() * p.depth, p.v.z));
    const int steps = int(least + (most - least) * std::acos(inUv.z) * 2. / std::numbers::pi);
    const double size = 1. / steps;
    const glm::dvec2 step = -glm::dvec2(inUv.x, inUv.y) / inUv.z * size;
    glm::dvec2 offset = step;
    double before = p.height(p.uv), now = p.height(p.uv + offset), ray = 1. - size;
    for (int i = 0; i < steps && !(now > ray); ++i) {
        before = now, ray -= size, offset += step;
        now = p.height(p.uv + offset);
    }
    double pt0 = ray + size, pt1 = ray, delta0 = pt0 - before, delta1 = pt1 - now;
    for (int i = 0; i < 3; ++i) {
        const double crossing = (pt0 * delta1 - pt1 * delta0) / (delta1 - delta0);
        offset = (1. - crossing) * step * double(steps);
        const double delta = crossing - p.height(p.uv + offset);
        if (std::abs(delta) <= 0.01)
            break;
        (delta < 0. ? delta1 : delta0) = delta;
        (delta < 0. ? pt1 : pt0) = crossing;
    }
    return p.uv + offset;
}

glm::dvec2 unreal(const Pixel& p, double least, double most)
{
    const double steps = most + (least - most) * std::abs(p.v.z), size = 1. / steps;
    const glm::dvec2 step = -p.aside() / p.v.z * p.depth * size;
    glm::dvec2 offset(0.);
    double ray = 1., oldRay = 1., oldHeight = 1.;
    for (int i = 0; i < int(std::floor(steps)) + 2; ++i) {
        const double height = p.height(p.uv + offset);
        if (ray < height) {
            offset -= step * ((height - ray) / (oldRay - oldHeight + height - ray));
            break;
        }
        oldRay = ray, oldHeight = height;
        ray -= size, offset += step;
    }
    return p.uv + offset;
}

glm::dvec2 o3de(const Pixel& p, int steps)
{
    const glm::dvec2 delta = -p.aside() * p.depth / p.v.z / double(steps);
    glm::dvec2 offset(0.);
    double at = 0., sample = 1. - p.height(p.uv), before = sample;
    while (sample > at + 1e-12) {
        at += 1. / steps, offset += delta;
        before = sample;
        sample = 1. - p.height(p.uv + offset);
    }
    if (at > 0.) {
        const double behind = at - sample, ahead = before - (at - 1. / steps);
        offset -= delta * (1. - ahead / (ahead + behind));
    }
    return p.uv + offset;
}

glm::dvec2 bevy(const Pixel& p, double most)
{
    const double layers = most + (1. - most) * std::abs(p.v.z), thick = 1. / layers;
    const glm::dvec2 delta = -p.depth * thick * p.aside() / std::abs(p.v.z);
    glm::dvec2 at = p.uv;
    double layer = 0., depth = 1. - p.height(at);
    for (int i = 0; depth > layer + 1e-12 && i <= int(layers); ++i) {
        layer += thick, at += delta;
        depth = 1. - p.height(at);
    }
    const double next = depth - layer, previous = 1. - p.height(at - delta) - layer + thick;
    const double weight = next / (next - previous);
    return at * (1. - weight) + (at - delta) * weight;
}

glm::dvec2 babylon(const Pixel& p)
{
    const glm::dvec2 span = -p.aside() / p.v.z * p.depth;
    const double samples = 15. + 11. * p.v.z, size = 1. / samples;
    glm::dvec2 now(0.), last(0.);
    double ray = 1., lastHeight = 1.;
    for (int i = 0; i < 15; ++i) {
        const double height = p.height(p.uv + now);
        if (height > ray) {
            const double inside = height - ray, outside = ray + size - lastHeight, ratio = inside / (inside + outside);
            return p.uv + ratio * last + (1. - ratio) * now;
        }
        ray -= size, last = now, now += size * span;
        lastHeight = height;
    }
    return p.uv + now;
}

glm::dvec2 playcanvas(const Pixel& p)
{
    const double scale = p.depth, base = 1.; // heightMapFactor is 10 times that, heightMapBase as exported
    const glm::dvec2 march = -scale * p.aside() / std::max(p.v.z, 1e-4);
    const double length = glm::length(march);
    const glm::dvec2 span = march * std::min(1., length > 0. ? 5. * scale / length : 1.);
    const double walked = glm::length(span * glm::dvec2(p.field.width(), p.field.height()));
    const double fade = std::clamp((walked - 1.) / 2., 0., 1.), steps = std::clamp(walked / 2., 1., 16.);
    const glm::dvec2 entry = p.uv - span * (1. - base);
    double ray = 0., before = 0., surface = 1. - p.height(entry);
    for (int i = 0; i < steps && ray < surface - 1e-12; ++i) {
        before = ray, ray += 1. / steps;
        surface = 1. - p.height(entry + span * ray);
    }
    double half = (ray - before) / 2., hit = ray - half;
    for (int i = 0; i < 5; ++i) {
        half /= 2.;
        hit += hit >= 1. - p.height(entry + span * hit) ? -half : half;
    }
    return p.uv + span * ((std::clamp(hit, 0., 1.) - (1. - base)) * fade);
}

using Formula = glm::dvec2 (*)(const Pixel&);
const std::map<std::string_view, Formula> kFormulas = {{"as-godot4", [](const Pixel& p) { return godotDeep(p, 8., 32.); }},
    {"as-godot3", [](const Pixel& p) { return godotDeep(p, 8., 32.); }}, {"as-godot4-simple", godotSimple}, {"as-unity-urp", unity},
    {"as-unity-builtin", unity}, {"as-unity-hdrp", [](const Pixel& p) { return hdrp(p, 8., 32.); }},
    {"as-unreal", [](const Pixel& p) { return unreal(p, 8., 32.); }}, {"as-o3de", [](const Pixel& p) { return o3de(p, 32); }},
    {"as-bevy", [](const Pixel& p) { return bevy(p, 32.); }}, {"as-babylon", babylon}, {"as-playcanvas", playcanvas}};

// The ray that Relievo has of a pixel: duv is what the view moves by over the whole depth.
SearchRay rayOf(const Pixel& p)
{
    return {p.uv, -p.aside() / p.v.z * p.depth, p.v.z};
}

HeightField squareField(int size, float (*height)(int, int, int))
{
    std::vector<float> heights;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            heights.push_back(height(x, y, size));
    return {size, size, std::move(heights), Wrap::Repeat, 32};
}

// Waves from 0.05 to 0.95, a ramp along u that falls off at the border, one height.
const HeightField kFields[] = {squareField(64,
                                   [](int x, int y, int size) {
                                       const float turn = 2.f * std::numbers::pi_v<float> / float(size);
                                       return 0.5f + 0.45f * std::sin(2.f * turn * float(x)) * std::cos(turn * float(y));
                                   }),
    squareField(32, [](int x, int, int size) { return (float(x) + 0.5f) / float(size); }),
    squareField(4, [](int, int, int) { return 0.3f; })};

SearchHit hitOf(std::string_view key, const Pixel& p, const Parameters& parameters = {})
{
    const SearchRay rays[] = {rayOf(p)};
    return traceRays(key, parameters, &p.field, rays)->front();
}

Pixel pixelAt(double degrees, double turn, glm::dvec2 uv, double depth, const HeightField& field)
{
    const double angle = degrees * std::numbers::pi / 180.;
    return {uv, {std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)}, depth, field};
}

} // namespace

TEST(EngineTechniques, EachHasAFormula)
{
    for (const TechniqueRow& row : kTechniques) {
        EXPECT_EQ(row.isEngine(), kFormulas.contains(row.key)) << row.key;
        EXPECT_EQ(row.isEngine(), row.key.starts_with("as-")) << row.key;
        if (row.isEngine()) { // no silhouettes, no shadows, the finest level
            EXPECT_FALSE(row.hasShadowsAndOutlines() || row.canMiss || row.isExact) << row.key;
            EXPECT_FALSE(row.parameters.contains(&Parameters::heightMips)) << row.key;
        }
    }
}

// What an export tells an engine of the zero is what the technique draws by.
TEST(EngineTechniques, HaveTheZeroOfTheirExports)
{
    int found = 0;
    for (const ExportRow& target : kExports)
        if (!target.engine.technique.empty()) {
            const TechniqueRow* technique = findTechnique(target.engine.technique);
            ASSERT_TRUE(technique && technique->isEngine()) << target.key;
            EXPECT_EQ(technique->displaces, target.engine.zeroIsFree) << target.key;
            EXPECT_EQ(technique->zero, target.engine.zero) << target.key;
            ++found;
        }
    EXPECT_EQ(found, 10); // all but Godot 4's simple one
}

// A crossing is at times found a layer earlier or later where single and double precision part: 1 ray in 500. Over many tiles precision
// decides all, in the engine too: those rays are left out.
TEST(EngineTechniques, DrawWhatTheirFormulasSay)
{
    for (const auto& [key, formula] : kFormulas)
        for (const HeightField& field : kFields)
            for (const double degrees : kDegrees) {
                int apart = 0, count = 0;
                for (int i = 0; i < 1500; ++i) {
                    const Pixel pixel
                        = pixelAt(degrees, 0.37 + 2.399963 * i, {std::fmod(0.11 + 0.754878 * i, 1.), std::fmod(0.23 + 0.569840 * i, 1.)},
                            i % 3 == 0       ? 0.003
                                : i % 3 == 1 ? 0.05
                                             : 0.2,
                            field);
                    const double way = glm::length(rayOf(pixel).duv);
                    if (way > 5.)
                        continue;
                    const SearchHit hit = hitOf(key, pixel);
                    ASSERT_TRUE(hit.found) << key;
                    apart += !(glm::length(hit.uv - formula(pixel)) < 2e-6 + 2e-5 * way);
                    ++count;
                }
                ASSERT_GE(count, 500);
                EXPECT_LE(apart, count / 500) << key << ' ' << degrees << ' ' << field.width();
            }
}

// t is where the eye sees what is drawn: the ray has its uv there, counted from where white would lie.
TEST(EngineTechniques, DepthIsWhereTheViewRayMeetsWhatIsDrawn)
{
    for (const auto& [key, formula] : kFormulas) {
        const TechniqueRow& row = *findTechnique(key);
        for (int i = 0; i < 100; ++i) {
            const Pixel pixel = pixelAt(20. + 0.6 * i, 2.399963 * i, {0.37 * i, 0.61 * i}, 0.06, kFields[0]);
            const SearchHit hit = hitOf(key, pixel);
            const SearchRay ray = rayOf(pixel);
            EXPECT_LT(glm::length(ray.uv + ray.duv * (hit.t - double(row.meshDepth())) - hit.uv), 1e-5) << key;
        }
    }
}

// Of one height everywhere: the share of the depth that each engine's formula leaves, by hand.
TEST(EngineTechniques, DrawTheDepthThatTheyLeave)
{
    const double h = 0.3, cosine = std::cos(70. * std::numbers::pi / 180.);
    const Pixel pixel = pixelAt(70., 1., {0.2, 0.7}, 0.05, kFields[2]);
    for (const char* key : {"as-godot4", "as-godot3", "as-godot4-simple"})
        EXPECT_NEAR(hitOf(key, pixel).t, (1. - h) * cosine, 1e-6) << key;
    for (const char* key : {"as-unity-urp", "as-unity-builtin"})
        EXPECT_NEAR(hitOf(key, pixel).t, 0.5 + (0.5 - h) * cosine / (cosine + 0.42), 1e-6) << key;
    for (const char* key : {"as-unity-hdrp", "as-unreal", "as-o3de", "as-bevy", "as-babylon"})
        EXPECT_NEAR(hitOf(key, pixel).t, 1. - h, 1e-6) << key;
    const HeightField ground(1, 1, {0.f});
    EXPECT_NEAR(hitOf("as-babylon", pixelAt(0., 0., {0.5, 0.5}, 0.05, ground)).t, 15. / 26., 1e-6); // cut off flat
    EXPECT_NEAR(hitOf("as-babylon", pixelAt(70., 0., {0.5, 0.5}, 0.05, ground)).t, 15. / (15. + 11. * cosine), 1e-6);
    const HeightField fine = squareField(512, [](int, int, int) { return 0.f; });
    const double steep = std::cos(85. * std::numbers::pi / 180.), slope = std::tan(85. * std::numbers::pi / 180.);
    EXPECT_GT(slope, 5.); // PlayCanvas caps the ray at 5 over its whole length
    EXPECT_NEAR(hitOf("as-playcanvas", pixelAt(85., 0., {0.5, 0.5}, 0.05, fine)).t, 5. * steep / std::sqrt(1. - steep * steep), 0.02);
}

TEST(EngineTechniques, UnityHoldsTheDepthInItsRange)
{
    const auto drawn = [](double depth) {
        const Pixel pixel = pixelAt(45., 0., {0.1, 0.1}, depth, kFields[2]);
        return glm::length(hitOf("as-unity-urp", pixel).uv - pixel.uv);
    };
    EXPECT_NEAR(drawn(0.001), drawn(0.005), 1e-7);
    EXPECT_NEAR(drawn(0.3), drawn(0.08), 1e-7);
    EXPECT_NEAR(drawn(0.04) / drawn(0.01), 4., 1e-3);
}

TEST(EngineTechniques, StepsAreThoseThatAnExportWrites)
{
    const HeightField ground(1, 1, {0.f});
    const auto fetches = [&](const char* key, double degrees, int least, int most) {
        Parameters parameters;
        parameters.minSteps = least, parameters.maxSteps = most;
        return hitOf(key, pixelAt(degrees, 0., {0.5, 0.5}, 0.05, ground), parameters).fetches;
    };
    EXPECT_EQ(fetches("as-godot4", 0., 8, 32), 8 + 2); // one at the surface, one read again
    EXPECT_EQ(fetches("as-godot4", 60., 8, 32), 20 + 2);
    EXPECT_EQ(fetches("as-godot4", 60., 16, 64), 40 + 2);
    EXPECT_EQ(fetches("as-o3de", 60., 8, 32), 32 + 1);
    EXPECT_EQ(fetches("as-o3de", 0., 1, 500), 32 + 1); // Medium, as exported
    EXPECT_EQ(fetches("as-unity-hdrp", 0., 5, 15), 5 + 3); // to a layer below the ground, and where the secant lands
    EXPECT_EQ(fetches("as-babylon", 60., 1, 1), 15);
    EXPECT_EQ(fetches("as-bevy", 0., 8, 32), 1 + 2);
    EXPECT_EQ(fetches("as-bevy", 60., 8, 31), 16 + 2);
}
