// The walk through prisms on the GPU, in both dialects, and on the CPU: one text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/across.h"
#include "core/mesh/edges/prism_texels.h"
#include "core/mesh/shapes/shapes.h"
#include "core/shader_text/program_text.h"
#include "core/trace/prisms.h"
#include "render/gl/buffer_texture.h"
#include "render/gl/program.h"
#include "render/uploads/textures.h"
#include "render/uploads/uploads.h"
#include "render/windowless.h"
#include <cmath>
#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;

namespace {

constexpr int kSide = 64, kRays = kSide * kSide, kTexelRow = 1024; // pixels; texels of prism_texels_image.glsl

struct Rays {
    std::vector<glm::vec4> starts, ways; // as trace_prisms.glsl has them
};

// Into the outer surface of random triangles, from all sides.
Rays raysInto(const Prisms& prisms, std::size_t triangles, float depth)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    Rays rays;
    for (int i = 0; i < kRays; ++i) {
        const int triangle = int(unit(random) * 0.999f * float(triangles));
        const glm::vec3 a = prisms.outerCorner(triangle, 0), b = prisms.outerCorner(triangle, 1), c = prisms.outerCorner(triangle, 2);
        const float u = std::sqrt(unit(random)), v = unit(random);
        const glm::vec3 up = glm::normalize(glm::cross(b - a, c - a));
        const glm::vec3 aside(unit(random) - 0.5f, unit(random) - 0.5f, unit(random) - 0.5f);
        const glm::vec3 way = glm::normalize(aside * 3.f - up);
        rays.starts.emplace_back(a * (1.f - u) + b * (u * (1.f - v)) + c * (u * v), float(triangle));
        rays.ways.emplace_back(way, glm::dot(way, up) < 0.f ? depth : -depth);
    }
    return rays;
}

Texture vectors(int width, std::span<const glm::vec4> values)
{
    glActiveTexture(GL_TEXTURE15); // where nothing else is bound
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    const int height = int((values.size() + std::size_t(width) - 1) / std::size_t(width));
    std::vector<glm::vec4> padded(values.begin(), values.end());
    padded.resize(std::size_t(width) * std::size_t(height));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, padded.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

struct Drawn {
    std::vector<glm::vec4> hits = std::vector<glm::vec4>(kRays), points = std::vector<glm::vec4>(kRays);
};

Drawn drawRays(const LinkedProgram& program, const Rays& rays)
{
    const Texture starts = vectors(kSide, rays.starts), ways = vectors(kSide, rays.ways);
    const Texture hits = vectors(kSide, rays.starts), points = vectors(kSide, rays.starts); // to be drawn over
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    const FramebufferName framebuffer(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *hits, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, *points, 0);
    const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, targets);
    glViewport(0, 0, kSide, kSide);
    glDisable(GL_DEPTH_TEST);
    program.bind("rayMap", GL_TEXTURE_2D, *starts, 1);
    program.bind("wayMap", GL_TEXTURE_2D, *ways, 2);
    const VertexArray none = newVertexArray();
    glBindVertexArray(*none);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    Drawn drawn;
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, drawn.hits.data());
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, drawn.points.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return drawn;
}

Drawn walkedOnGpu(std::string_view technique, Dialect dialect, const Parameters& parameters, const Mesh& mesh, const HeightField& field,
    const SceneUniforms& uniforms, const Rays& rays)
{
    const auto text = prismProgram(technique, embeddedReader(), dialect);
    EXPECT_TRUE(text) << (text ? "" : message(text.error()));
    const auto program = LinkedProgram::link(*text);
    EXPECT_TRUE(program) << technique << int(dialect) << (program ? "" : message(program.error()));
    if (!program)
        return {};
    program->use();
    program->set(parameters), program->set(uniforms);
    program->set("heightUnits", 0.f);
    glActiveTexture(GL_TEXTURE0);
    const Texture heights = uploadHeight(field, false);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT), glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    program->bind("heightMap", GL_TEXTURE_2D, *heights, 0);
    glActiveTexture(GL_TEXTURE15);
    AccelerationUpload acceleration;
    if (const auto maps = searchMaps(technique, parameters, &field); maps->acceleration) {
        acceleration = uploadAccelerationMap(*maps->acceleration, Wrap::Repeat);
        bindAccelerationMap(*program, acceleration, 3);
        const PixelType type = maps->acceleration->levels.front().type;
        program->set("boundUnits", type == PixelType::U8 ? 255.f : type == PixelType::U16 ? 65535.f : 0.f);
    }
    const std::vector<glm::vec4> texels = prismTexels(mesh, edgesAcross(mesh), std::vector<char>(mesh.parts.size(), 0));
    glActiveTexture(GL_TEXTURE15);
    BufferTexture buffer;
    buffer.fill(texels, GL_STATIC_DRAW);
    const Texture image = vectors(kTexelRow, texels);
    program->bind("prismMap", GL_TEXTURE_BUFFER, buffer.texture(), 4);
    program->bind("prismImage", GL_TEXTURE_2D, *image, 5);
    return drawRays(*program, rays);
}

} // namespace

TEST(PrismsGl, AgreeWithTheCpu)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const Mesh mesh = *makeShape("torus");
    Parameters p;
    p.depth = 0.3f, p.tiling = 3.f, p.metresPerUV = 1.f, p.midlevel = 0.8f;
    std::vector<float> waves(64 * 64);
    for (std::size_t i = 0; i < waves.size(); ++i)
        waves[i] = 0.5f + 0.5f * std::sin(float(i % 64) * 0.39f) * std::cos(float(i / 64) * 0.29f);
    const HeightField field(64, 64, std::move(waves), Wrap::Repeat, 32);
    for (const char* technique : {"cell-cone", "relief"}) {
        const auto prisms = Prisms::make(technique, p, mesh, field);
        ASSERT_TRUE(prisms);
        SceneUniforms uniforms = sceneUniforms(p, {}, mesh.metresPerUV);
        uniforms.pushOut = (1.f - p.midlevel) * uniforms.reliefDepth;
        uniforms.lightDirection = glm::normalize(glm::vec3(0.4f, 0.8f, 0.3f));
        const Rays rays = raysInto(*prisms, mesh.indices.size() / 3, uniforms.reliefDepth);
        for (const Dialect dialect : {Dialect::Desktop, Dialect::Es}) {
            const Drawn gpu = walkedOnGpu(technique, dialect, p, mesh, field, uniforms, rays);
            int found = 0, hidden = 0, apart = 0, otherShadow = 0;
            for (std::size_t i = 0; i < kRays; ++i) {
                const PrismRayHit cpu = prisms->hit(int(rays.starts[i].w), glm::vec3(rays.starts[i]), glm::vec3(rays.ways[i]));
                const bool cpuHidden = cpu.found && prisms->isHidden(cpu, uniforms.lightDirection, rays.ways[i].w > 0.f);
                found += cpu.found, hidden += cpuHidden;
                apart
                    += cpu.found != (gpu.hits[i].x > 0.5f) || (cpu.found && !(glm::distance(cpu.point, glm::vec3(gpu.points[i])) < 1e-3f));
                otherShadow += cpuHidden != (gpu.points[i].w > 0.5f);
            }
            EXPECT_GT(found, kRays / 3) << technique;
            EXPECT_GT(hidden, found / 10) << technique;
            EXPECT_LT(apart, kRays / 200) << technique << ' ' << int(dialect);
            EXPECT_LT(otherShadow, kRays / 100) << technique << ' ' << int(dialect);
        }
    }
}
