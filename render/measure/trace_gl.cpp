// Searches on the GPU: rays in a texture, one a pixel, hits in two targets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shader_text/program_text.h"
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "render/gl/driver_limits.h"
#include "render/gl/program.h"
#include "render/uploads/uploads.h"
#include "render/windowless.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace relievo {

namespace {

constexpr int kRow = 1024; // rays a texture row
constexpr int kRows = 1024;

Texture floatTexture(GLint internal, GLenum layout, int height, const float* data)
{
    glActiveTexture(GL_TEXTURE15); // not where the height map is bound
    Texture texture = newTexture();
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, kRow, height, 0, layout, GL_FLOAT, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

// The rays of one pass as texels; those that are not finite are replaced, their answer is known.
struct Pass {
    int height;
    std::vector<float> rays, cosines, hits, fetches;

    explicit Pass(std::span<const SearchRay> part) : height(int((part.size() + kRow - 1) / kRow))
    {
        const std::size_t texels = std::size_t(height) * kRow;
        rays.resize(texels * 4), cosines.resize(texels, 1.f), hits.resize(texels * 4), fetches.resize(texels);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const SearchRay& r = part[i];
            if (!isFiniteInFloat(r))
                continue;
            const glm::vec2 uv = inFloat(r.uv), duv = inFloat(r.duv);
            const float values[] = {uv.x, uv.y, duv.x, duv.y};
            std::ranges::copy(values, rays.begin() + std::ptrdiff_t(i * 4));
            cosines[i] = float(r.cosView);
        }
    }

    void run(const LinkedProgram& program, int unit)
    {
        const Texture rayMap = floatTexture(GL_RGBA32F, GL_RGBA, height, rays.data());
        const Texture cosineMap = floatTexture(GL_R32F, GL_RED, height, cosines.data());
        const Texture hitMap = floatTexture(GL_RGBA32F, GL_RGBA, height, nullptr);
        const Texture fetchMap = floatTexture(GL_R32F, GL_RED, height, nullptr);
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        const FramebufferName framebuffer(name);
        glBindFramebuffer(GL_FRAMEBUFFER, name);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *hitMap, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, *fetchMap, 0);
        const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        glDrawBuffers(2, targets);
        glViewport(0, 0, kRow, height);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        program.bind("rayMap", GL_TEXTURE_2D, *rayMap, unit);
        program.bind("cosineMap", GL_TEXTURE_2D, *cosineMap, unit + 1);
        const VertexArray none = newVertexArray();
        glBindVertexArray(*none);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindVertexArray(0);
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glReadPixels(0, 0, kRow, height, GL_RGBA, GL_FLOAT, hits.data());
        glReadBuffer(GL_COLOR_ATTACHMENT1);
        glReadPixels(0, 0, kRow, height, GL_RED, GL_FLOAT, fetches.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    SearchHit hit(const SearchRay& ray, std::size_t i) const
    {
        if (hits[i * 4] < -0.5f)
            return unfinished(ray, int(fetches[i]));
        return {hits[i * 4] > 0.5f, double(hits[i * 4 + 1]), {double(hits[i * 4 + 2]), double(hits[i * 4 + 3])}, int(fetches[i])};
    }
};

} // namespace

Expected<std::vector<SearchHit>> traceRaysOnGpu(
    std::string_view key, const Parameters& parameters, const HeightField* field, std::span<const SearchRay> rays, Dialect dialect)
{
    if (const auto fits = field ? fitTheDriver(*field) : Expected<void>(); !fits)
        return tl::unexpected(fits.error());
    const auto maps = searchMaps(key, parameters, field);
    if (!maps)
        return tl::unexpected(maps.error());
    const char* folder = std::getenv("RELIEVO_SHADERS");
    const auto text = traceProgram(key, folder && *folder ? folderReader(folder) : embeddedReader(), dialect);
    if (!text)
        return tl::unexpected(text.error());
    const auto program = LinkedProgram::link(*text);
    if (!program)
        return tl::unexpected(program.error());
    program->use();
    const Wrap wrap = field ? field->wrap() : Wrap::Repeat;
    Parameters used = parameters;
    used.wrap = wrap;
    program->set(used);
    Texture heights;
    if (program->reads("heightMap")) {
        heights = uploadHeight(*field, false);
        const GLint mode = wrap == Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode);
        program->bind("heightMap", GL_TEXTURE_2D, *heights, 0);
        program->set("heightUnits", field->storedBits() <= 16 ? 65535.f : 0.f);
    }
    AccelerationUpload acceleration;
    if (maps->acceleration) {
        glActiveTexture(GL_TEXTURE15);
        acceleration = uploadAccelerationMap(*maps->acceleration, wrap);
        bindAccelerationMap(*program, acceleration, 3);
        const PixelType type = maps->acceleration->levels.front().type;
        program->set("boundUnits", type == PixelType::U8 ? 255.f : type == PixelType::U16 ? 65535.f : 0.f);
    }
    std::vector<SearchHit> hits(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += std::size_t(kRow) * kRows) {
        const auto part = rays.subspan(first, std::min(rays.size() - first, std::size_t(kRow) * kRows));
        Pass pass(part);
        pass.run(*program, 1);
        for (std::size_t i = 0; i < part.size(); ++i)
            if (isFiniteInFloat(part[i]))
                hits[first + i] = pass.hit(part[i], i);
    }
    if (const auto sufficed = memorySufficed(); !sufficed)
        return tl::unexpected(sufficed.error());
    return hits;
}

} // namespace relievo
