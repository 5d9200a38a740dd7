// From a request to a picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"
#include "core/state/views.h"
#include "render/clear_target.h"
#include "render/frame.h"
#include "render/gl/driver_limits.h"
#include "render/glowing.h"
#include "render/pane_values.h"
#include "render/passes.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace relievo {

struct Renderer::Impl {
    DrawContext context;
    Framebuffer measuring;
    std::vector<float> pixels;
    GlowingPictures glowing;
};

Renderer::Renderer() : m(std::make_unique<Impl>()) { }
Renderer::~Renderer() = default;
bool Renderer::shadersChanged() const
{
    return m->context.programs.changed();
}
int Renderer::textureCount() const
{
    return m->context.uploads.textureCount();
}

Expected<void> Renderer::draw(const DrawRequest& request)
{
    const auto passes = [this](const DrawRequest& into) { return drawPasses(into); };
    if (hasGlow(request))
        return m->glowing.draw(request, passes, m->context.programs);
    const auto drawn = passes(request);
    if (!drawn)
        return tl::unexpected(drawn.error());
    return drawn->error ? tl::unexpected(*drawn->error) : Expected<void>();
}

Expected<DrawnFrame> Renderer::drawPasses(const DrawRequest& request)
{
    const Target& target = request.target();
    const ViewRow* view = findView(request.view());
    clearTarget(effectiveParameters(request.state(), request.pane()), target, view && view->isHeat);
    if (const auto drawable = canBeDrawnTo(target.width, target.height); !drawable)
        return tl::unexpected(drawable.error());
    const Expected<float> exposure = meteredExposure(request);
    if (!exposure)
        return tl::unexpected(exposure.error());
    auto frame = prepareFrame(m->context, request);
    if (!frame)
        return tl::unexpected(frame.error());
    frame->uniforms.exposureFactor *= *exposure;
    if (frame->features.glows)
        LightPicture::clear();
    for (const PassRow& pass : kPasses)
        if (pass.isWanted(*frame))
            pass.draw(m->context, *frame);
    glDisable(GL_SCISSOR_TEST);
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(0);
    if (const auto sufficed = memorySufficed(); !sufficed) {
        m->context.forgetUploads();
        return tl::unexpected(sufficed.error());
    }
    return DrawnFrame{frame->parameters, frame->features, frame->uniforms, frame->error};
}

// The whole picture's, however small a part of it is drawn, and of the mesh alone.
Expected<float> Renderer::meteredExposure(const DrawRequest& request)
{
    constexpr int kSide = 64;
    constexpr float kMiddleGrey = 0.18f, kDarkest = 1e-4f; // what is darker counts as this
    const ViewRow* view = findView(request.view());
    const Target& target = request.target();
    if (!view || !view->isColor || view->light == ViewLight::None || target.linear || request.pane() >= request.state().panes.size())
        return 1.f;
    const Parameters parameters = effectiveParameters(request.state(), request.pane());
    if (!parameters.autoExposure)
        return 1.f;
    State state = request.state();
    state.parameters = parameters;
    state.panes[request.pane()].overrides.clear();
    state.parameters.background = Backdrop::Transparent;
    state.parameters.wireframe = state.parameters.ground = false;
    state.parameters.bloom = 0.f;
    const float aspect = aspectOf(target);
    const int width = std::max(1, int(std::min(1.f, aspect) * kSide)), height = std::max(1, int(std::min(1.f, 1.f / aspect) * kSide));
    if (const auto made = m->measuring.resize(width, height, true); !made)
        return tl::unexpected(made.error());
    const Target measured{.framebuffer = m->measuring.handle(), .width = width, .height = height, .linear = true, .isPassing = true};
    if (const auto drawn = draw({state, request.pane(), request.resources(), measured, view->key}); !drawn)
        return tl::unexpected(drawn.error());
    m->pixels.resize(std::size_t(width) * std::size_t(height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, m->pixels.data());
    bindTarget(target);
    double sum = 0., covered = 0.;
    for (std::size_t i = 0; i < m->pixels.size(); i += 4) {
        const float light = 0.2126f * m->pixels[i] + 0.7152f * m->pixels[i + 1] + 0.0722f * m->pixels[i + 2];
        if (m->pixels[i + 3] > 0.5f && std::isfinite(light))
            sum += double(std::log2(std::max(light, kDarkest))), covered += 1.;
    }
    return covered > 0. ? kMiddleGrey / std::exp2(float(sum / covered)) : 1.f;
}

Expected<Measurement> Renderer::measure(const State& state, std::size_t pane, const Resources& resources, float aspect)
{
    const int width = aspect >= 1.6f ? 320 : std::max(1, int(200.f * aspect));
    const int height = aspect >= 1.6f ? std::max(1, int(320.f / aspect)) : 200;
    if (const auto made = m->measuring.resize(width, height, true); !made)
        return tl::unexpected(made.error());
    State counted = state;
    counted.parameters.wireframe = false;
    const Target target{.framebuffer = m->measuring.handle(), .width = width, .height = height, .linear = true};
    if (const auto drawn = draw({counted, pane, resources, target, knownView("fetches").key}); !drawn)
        return tl::unexpected(drawn.error());
    m->pixels.resize(std::size_t(width) * std::size_t(height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, m->pixels.data());
    Measurement result;
    double covered = 0.;
    for (std::size_t i = 0; i < m->pixels.size(); i += 4) {
        covered += double(m->pixels[i + 3]);
        result.meanFetches += double(m->pixels[i] * m->pixels[i + 3]);
        result.maxFetches = std::max(result.maxFetches, double(m->pixels[i]));
    }
    result.meanFetches /= std::max(covered, 1.);
    result.covered = covered / double(width * height);
    return result;
}

namespace {
HeatNumbers heatNumbers(std::vector<float>& values, double range)
{
    HeatNumbers numbers;
    if (values.empty())
        return numbers;
    const double share = 1. / double(values.size());
    for (const float value : values) {
        numbers.mean += double(value) * share;
        numbers.most = std::max(numbers.most, double(value));
        const double bin = double(value) / range * double(numbers.histogram.size());
        numbers.histogram[std::size_t(std::clamp(bin, 0., double(numbers.histogram.size() - 1)))] += float(share);
    }
    const auto p99 = values.begin() + std::ptrdiff_t((values.size() - 1) * 99 / 100);
    std::ranges::nth_element(values, p99);
    numbers.p99 = double(*p99);
    return numbers;
}
} // namespace

Expected<ViewNumbers> Renderer::measureView(const DrawRequest& asked)
{
    const int width = asked.target().width, height = asked.target().height;
    if (const auto made = m->measuring.resize(width, height, true); !made)
        return tl::unexpected(made.error());
    State state = asked.state();
    state.parameters.wireframe = false;
    DrawRequest request(state, asked.pane(), asked.resources(),
        {.framebuffer = m->measuring.handle(), .width = width, .height = height, .linear = true}, asked.view());
    request.compareWith(asked.exact());
    if (const auto drawn = draw(request); !drawn)
        return tl::unexpected(drawn.error());
    m->pixels.resize(std::size_t(width) * std::size_t(height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, m->pixels.data());
    const ViewRow& view = *findView(request.view());
    ViewNumbers numbers;
    ErrorNumbers& error = numbers.error;
    std::vector<float> values;
    double all = 0.;
    float most = 0.f;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* pixel = &m->pixels[(std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x)) * 4];
            const bool covered = pixel[3] > 0.5f, isMissed = !covered && request.exact() && std::isfinite(request.exact()->pixels.at(x, y));
            if (!covered && !isMissed)
                continue;
            all += 1.;
            if (isMissed ? request.exact()->pixels.isUncertain(x, y) : pixel[0] < 0.f) {
                error.uncertain += 1.;
                continue;
            }
            const float off = isMissed ? 1.f : pixel[0];
            if (values.empty() || off > most)
                most = off, numbers.mostAt = {(float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height)};
            values.push_back(off);
            error.rmse += double(off) * double(off), error.wrong += off > view.wrongFrom;
        }
    const double sure = std::max(double(values.size()), 1.);
    error.rmse = std::sqrt(error.rmse / sure), error.wrong /= sure;
    error.uncertain /= std::max(all, 1.);
    numbers.heat = heatNumbers(values, double(heatRange(effectiveParameters(state, request.pane()), view)));
    return numbers;
}

} // namespace relievo
