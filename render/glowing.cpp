// Drawing pictures with a glow.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/glowing.h"
#include "core/state/views.h"
#include "render/clear_target.h"
#include "render/gl/driver_limits.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
constexpr int kWholeSide = 1024; // pixels of the longer side of a picture that only tells what glows around its tiles

Target wholeOf(const Target& tile)
{
    const float share = std::min(1.f, float(kWholeSide) / float(std::max(tile.wholeWidth, tile.wholeHeight)));
    Target whole = tile;
    whole.width = std::max(1, int(std::lround(float(tile.wholeWidth) * share)));
    whole.height = std::max(1, int(std::lround(float(tile.wholeHeight) * share)));
    whole.jitter = tile.jitter * share;
    whole.wholeWidth = whole.wholeHeight = whole.left = whole.below = whole.firstRow = whole.rows = 0;
    return whole;
}
// Whether the target that is bound holds more than bytes.
bool holdsFloats(const Target& target)
{
    GLint bits = 0;
    glGetFramebufferAttachmentParameteriv(
        GL_FRAMEBUFFER, target.framebuffer ? GL_COLOR_ATTACHMENT0 : GL_BACK_LEFT, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &bits);
    return bits > 8;
}
} // namespace

bool hasGlow(const DrawRequest& request)
{
    const ViewRow* view = findView(request.view());
    return view && view->isColor && view->light == ViewLight::All && request.pane() < request.state().panes.size()
        && effectiveParameters(request.state(), request.pane()).bloom > 0.f;
}

Expected<void> GlowingPictures::draw(
    const DrawRequest& request, const std::function<Expected<DrawnFrame>(const DrawRequest&)>& passes, ProgramCache& programs)
{
    const Target& target = request.target();
    clearTarget(effectiveParameters(request.state(), request.pane()), target, false);
    if (const auto drawable = canBeDrawnTo(target.width, target.height); !drawable)
        return drawable;
    const bool floats = holdsFloats(target);
    const auto drawInto = [&](LightPicture& picture, Target into) -> Expected<DrawnFrame> {
        if (const auto made = picture.resize(into.width, into.height, floats); !made)
            return tl::unexpected(made.error());
        into.framebuffer = picture.framebuffer();
        return passes({request.state(), request.pane(), request.resources(), into, request.view()});
    };
    const bool isTile = target.wholeWidth > 0;
    if (const auto whole = isTile ? drawInto(m_whole, wholeOf(target)) : DrawnFrame(); !whole)
        return tl::unexpected(whole.error());
    const auto drawn = drawInto(m_picture, target);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const bool isLast = target.rows == 0 || target.firstRow + target.rows >= target.height;
    const auto glowing = isLast
        ? m_glow.draw(m_picture, isTile ? m_whole : m_picture, target, drawn->features, drawn->parameters, drawn->uniforms, programs)
        : Expected<void>();
    glUseProgram(0);
    if (const auto sufficed = memorySufficed(); !sufficed)
        return sufficed;
    return drawn->error ? tl::unexpected(*drawn->error) : glowing;
}

} // namespace relievo
