// Drawing panes into pictures and pictures onto the screen.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/pane_pictures.h"
#include "app/window/viewport/gl_calls.h"
#include "app/window/viewport/mesh_reference.h"
#include "app/window/viewport/overlays.h"
#include "core/state/views.h"
#include "render/windowless.h"
#include <QElapsedTimer>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace relievo {

namespace {
constexpr int kMeasuredWidth = 480; // pixels

int scaled(int pixels, double scale)
{
    return std::max(1, int(std::lround(pixels * scale)));
}
} // namespace

PanePictures::Picture& PanePictures::picture(std::size_t pane)
{
    while (m_pictures.size() <= pane)
        m_pictures.emplace_back();
    return *std::next(m_pictures.begin(), std::ptrdiff_t(pane));
}

Expected<void> PanePictures::draw(const ShownScene& scene, std::size_t pane, const PaneArea& area, double scale)
{
    Framebuffer& drawn = *picture(pane).drawn;
    drawn.resize(scaled(area.width, scale), scaled(area.height, scale));
    DrawRequest request(scene.state, pane, scene.resources,
        {.framebuffer = drawn.handle(),
            .width = drawn.width(),
            .height = drawn.height(),
            .lineWidth = float(std::max(1., scene.pixelRatio * scale)),
            .isPassing = scale < 1.});
    if (scale >= 1.)
        request.compareWith(scene.reference.exactOf(pane));
    return m_renderer.draw(request);
}

std::vector<Error> PanePictures::draw(const ShownScene& scene, const std::vector<PaneArea>& areas, double scale)
{
    while (m_pictures.size() > areas.size()) // of panes that are gone
        m_pictures.pop_back();
    m_slices.pane = 0, m_slices.row = 0;
    std::vector<Error> troubles;
    for (std::size_t pane = 0; pane < areas.size(); ++pane) {
        picture(pane).mean.restart();
        picture(pane).ms = 0.;
        if (areas[pane].isEmpty())
            continue;
        const auto drawn = draw(scene, pane, areas[pane], scale);
        if (!drawn)
            troubles.push_back(drawn.error());
        if (!drawn && areas.size() > 1) // say in which
            troubles.back().where = paneLetter(pane).toStdString() + ", " + troubles.back().where;
    }
    return troubles;
}

bool PanePictures::drawSlice(const ShownScene& scene, const PaneArea& area, Picture& own, int rows, bool shifted)
{
    (void)own.sampled->resize(area.width, area.height); // drawing tells
    DrawRequest request(scene.state, m_slices.pane, scene.resources,
        {.framebuffer = own.sampled->handle(),
            .width = area.width,
            .height = area.height,
            .lineWidth = float(std::max(1., scene.pixelRatio)),
            .jitter = shifted ? own.mean.nextShift() : glm::vec2(0.f),
            .lens = shifted ? own.mean.nextLens() : glm::vec2(0.f),
            .firstRow = m_slices.row,
            .rows = rows});
    if (scene.reference.isShown(m_slices.pane))
        request.compareWith(scene.reference.exactOf(m_slices.pane));
    const bool drawn = m_renderer.draw(request).has_value();
    finishDrawing();
    return drawn;
}

PanePictures::Slice PanePictures::nextSlice(const ShownScene& scene, const PaneArea& area, double ms, bool wanted, bool shifted)
{
    Picture& own = picture(m_slices.pane);
    const int rows = std::clamp(int(ms * m_slices.rowsPerMs), 1, std::max(area.height - m_slices.row, 1));
    QElapsedTimer clock;
    clock.start();
    if (area.isEmpty() || !wanted || !drawSlice(scene, area, own, rows, shifted))
        return {true, false};
    m_slices.row += rows;
    m_slices.rowsPerMs = rows / std::max(0.01, double(clock.nsecsElapsed()) * 1e-6);
    return {m_slices.row >= area.height, true};
}

bool PanePictures::nextPane(const std::vector<PaneArea>& areas)
{
    m_slices.row = 0;
    m_slices.pane = m_slices.pane + 1 < areas.size() ? m_slices.pane + 1 : 0;
    return m_slices.pane == 0;
}

bool PanePictures::fillSlice(const ShownScene& scene, const std::vector<PaneArea>& areas, double ms)
{
    QElapsedTimer clock;
    clock.start();
    const Slice slice = nextSlice(scene, areas[m_slices.pane], ms, true, false);
    picture(m_slices.pane).ms += double(clock.nsecsElapsed()) * 1e-6;
    if (!slice.isWhole)
        return false;
    if (slice.isDrawn)
        std::swap(picture(m_slices.pane).drawn, picture(m_slices.pane).sampled);
    return nextPane(areas);
}

bool PanePictures::addSlice(const ShownScene& scene, const std::vector<PaneArea>& areas, double ms)
{
    const Slice slice = nextSlice(scene, areas[m_slices.pane], ms, !scene.reference.isShown(m_slices.pane), true);
    if (!slice.isWhole)
        return false;
    if (slice.isDrawn)
        picture(m_slices.pane).mean.add(*picture(m_slices.pane).sampled);
    return nextPane(areas);
}

int PanePictures::samples() const
{
    int most = 0;
    for (const Picture& picture : m_pictures)
        most = std::max(most, picture.mean.count());
    return most;
}

void PanePictures::show(unsigned framebuffer, const Arrangement& arrangement, int height)
{
    const std::vector<PaneArea>& areas = arrangement.areas;
    if (areas.size() > 1)
        clearTo(framebuffer, 0.1f, 0.1f, 0.1f); // the gaps between them
    if (arrangement.pair || arrangement.composition.zoom > 1.f)
        return compose(framebuffer, arrangement, height);
    for (std::size_t pane = 0; pane < areas.size(); ++pane) {
        PaneArea to = areas[pane];
        to.y = height - to.y - to.height; // OpenGL counts from below
        Picture& own = picture(pane);
        if (own.mean.count() > 0)
            own.mean.copyTo(framebuffer, to);
        else
            copyTo(*own.drawn, framebuffer, to);
    }
}

void PanePictures::compose(unsigned framebuffer, const Arrangement& arrangement, int height)
{
    const auto textureOf = [this](std::size_t pane) {
        Picture& own = picture(pane);
        return own.mean.count() > 0 ? own.mean.texture() : own.drawn->texture();
    };
    const auto put = [&](std::size_t at, unsigned first, unsigned second, const Composition& composition) {
        const PaneArea& to = arrangement.areas[at];
        (void)m_composer.draw({framebuffer, to.x, height - to.y - to.height, to.width, to.height}, first, second, composition);
    };
    if (!arrangement.pair) {
        for (std::size_t pane = 0; pane < arrangement.areas.size(); ++pane) {
            const unsigned own = textureOf(pane);
            put(pane, own, own, {.zoom = arrangement.composition.zoom, .corner = arrangement.composition.corner});
        }
        return;
    }
    const auto [first, second] = *arrangement.pair;
    put(first, arrangement.first ? m_composer.upload(*arrangement.first) : textureOf(first), textureOf(second), arrangement.composition);
}

Image PanePictures::pixels(std::size_t pane)
{
    const Picture& own = picture(pane);
    return pixels(pane, {0, 0, own.drawn->width(), own.drawn->height()});
}

Image PanePictures::around(std::size_t pane, glm::vec2 share, int radius)
{
    const Picture& own = picture(pane);
    const int x = int(std::floor(share.x * float(own.drawn->width()))), y = int(std::floor(share.y * float(own.drawn->height())));
    return pixels(pane, {x - radius, y - radius, 2 * radius + 1, 2 * radius + 1});
}

Image PanePictures::pixels(std::size_t pane, const PaneArea& of)
{
    Picture& own = picture(pane);
    return own.mean.count() > 0 ? readPixels(own.mean.framebuffer(), own.drawn->width(), own.drawn->height(), of)
                                : readPixels(own.drawn->handle(), own.drawn->width(), own.drawn->height(), of);
}

// Of heat views; of errors against the displaced mesh when that has been traced.
std::optional<ViewNumbers> PanePictures::numbersOf(const ShownScene& scene, std::size_t pane, const PaneArea& area, const ViewRow& view)
{
    const bool isTraced = scene.reference.isShown(pane) && !view.fileOnMesh.empty();
    const double scale = isTraced ? 1. : std::min(1., double(kMeasuredWidth) / area.width);
    DrawRequest request(
        scene.state, pane, scene.resources, {.width = scaled(area.width, scale), .height = scaled(area.height, scale)}, view.key);
    if (isTraced && !request.compareWith(scene.reference.exactOf(pane)))
        return {};
    const auto numbers = m_renderer.measureView(request);
    return numbers ? std::optional(*numbers) : std::nullopt;
}

std::optional<glm::vec2> PanePictures::worst(const ShownScene& scene, std::size_t pane, const PaneArea& area)
{
    const auto numbers = numbersOf(scene, pane, area, knownView("error"));
    return numbers && numbers->heat.most > 0. ? std::optional(numbers->mostAt) : std::nullopt;
}

std::optional<Measurement> PanePictures::measure(const ShownScene& scene, std::size_t pane, const PaneArea& area)
{
    if (area.isEmpty())
        return {};
    auto measured = m_renderer.measure(scene.state, pane, scene.resources, area.aspect());
    if (!measured)
        return {};
    if (picture(pane).ms == 0.) { // it was drawn in one go, so that it may be once more
        QElapsedTimer clock;
        clock.start();
        m_slices = {.pane = pane, .row = 0, .rowsPerMs = m_slices.rowsPerMs};
        if (drawSlice(scene, area, picture(pane), area.height, false))
            picture(pane).ms = double(clock.nsecsElapsed()) * 1e-6;
        m_slices.pane = 0;
    }
    measured->ms = picture(pane).ms;
    if (const ViewRow* view = findView(scene.state.panes[pane].view); view && view->isHeat)
        measured->shown = numbersOf(scene, pane, area, *view);
    return *measured;
}

QImage PanePictures::sheet(const ShownScene& scene, const std::vector<PaneArea>& areas, int samples)
{
    Resources resources = scene.resources;
    if (!resources.accelerationMaps.missingFor(scene.state, *resources.material).empty())
        return {}; // they are not made here: the window would stand still
    QImage sheet(areas.back().x + areas.back().width, areas.back().y + areas.back().height, QImage::Format_RGBA8888);
    sheet.fill(Qt::transparent);
    QPainter painter(&sheet);
    for (std::size_t pane = 0; pane < areas.size(); ++pane) {
        const PaneArea& area = areas[pane];
        const int each = scene.reference.isShown(pane) ? 1 : samples; // the exact answer is of the unshifted picture
        const auto drawn = drawPicture(
            m_renderer, scene.state, pane, resources, {}, area.width, area.height, each, false, scene.reference.exactOf(pane));
        if (!drawn)
            return {}; // the message line says why
        const QImage part(reinterpret_cast<const uchar*>(drawn->data.data()), drawn->width, drawn->height, QImage::Format_RGBA8888);
        painter.drawImage(area.x, area.y, part);
    }
    return sheet;
}

} // namespace relievo
