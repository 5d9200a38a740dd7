// Drawing the panes: when, how finely, and what stands over them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/viewport.h"
#include "app/window/viewport/gl_calls.h"
#include "app/window/viewport/overlays.h"
#include "render/windowless.h"
#include <QPainter>
#include <QScopeGuard>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr int kRestDelay = 100; // ms without a move until the full picture
constexpr int kMeasureDelay = 60; // ms from the full picture to the counting of fetches
constexpr int kSmoothLimit = 400; // ms that one more picture may keep the hand waiting
constexpr int kGap = 2; // pixels between two panes

int scaled(int pixels, double scale)
{
    return std::max(1, int(std::lround(pixels * scale)));
}
} // namespace

Viewport::Viewport(Document& document, Assets& assets, Messages& messages, QWidget* parent)
    : QOpenGLWidget(parent)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
    , m_reference(new MeshReference(document, assets, messages, this)) // hears of changes before the picture does
    , m_legends{new HeatLegend(this), new HeatLegend(this)}
    , m_hint(new Hint(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    setUpdateBehavior(QOpenGLWidget::PartialUpdate);
    for (int i = 0; i < 2; ++i) {
        m_captions[std::size_t(i)] = new PaneCaption(this);
        connect(m_captions[std::size_t(i)], &PaneCaption::clicked, this, [this, i] { chooseTechnique(i); });
    }
    for (QTimer* timer : {&m_rest, &m_measuring, &m_smoothing})
        timer->setSingleShot(true);
    connect(&m_smoothing, &QTimer::timeout, this, &Viewport::smooth);
    connect(&m_rest, &QTimer::timeout, this, [this] { refresh(false); });
    connect(&m_measuring, &QTimer::timeout, this, &Viewport::measure);
    connect(&m_flying, &QTimer::timeout, this, &Viewport::fly);
    connect(&m_shaderWatch, &QTimer::timeout, this, [this] {
        if (m_renderer && m_renderer->shadersChanged())
            refresh(false);
    });
    if (qEnvironmentVariableIsSet("RELIEVO_SHADERS"))
        m_shaderWatch.start(500);
    connect(&document, &Document::changed, this, &Viewport::documentChanged);
    connect(&document, &Document::gestureEnded, this, [this] { refresh(false); });
    connect(&assets, &Assets::resourcesChanged, this, [this] { refresh(false); });
    connect(m_reference, &MeshReference::made, this, [this] { refresh(false); });
    updateOverlays();
}

Viewport::~Viewport()
{
    makeCurrent();
    m_renderer.reset();
    m_pictures.reset();
    doneCurrent();
}

void Viewport::initializeGL()
{
    const int version = openGLVersion();
    if (version < 41)
        return m_messages.set("picture",
            Error{"OpenGL 4.1 is needed", QString("OpenGL %1.%2").arg(version / 10).arg(version % 10).toStdString(),
                "Update the graphics driver"});
    m_renderer = std::make_unique<Renderer>();
    m_pictures = std::make_unique<Pictures>();
}

void Viewport::resizeGL(int, int)
{
    placeOverlays();
    refresh(m_shownScale > 0.); // coarse while the window is pulled larger
}

Viewport::PaneArea Viewport::area(int pane) const
{
    const int width = scaled(this->width(), devicePixelRatioF()), height = scaled(this->height(), devicePixelRatioF());
    if (paneCount() == 1)
        return {0, width, height};
    const int half = (width - kGap) / 2;
    return {pane == 0 ? 0 : width - half, half, height};
}

CameraView Viewport::sight() const
{
    const PaneArea size = area(0);
    const Mesh& mesh = *m_assets.resources().mesh;
    return cameraView(m_document.state().camera, mesh.boundsMin, mesh.boundsMax, float(size.width) / float(std::max(size.height, 1)));
}

void Viewport::documentChanged(Changes what)
{
    if (what & Change::Panes) {
        m_measured = {};
        if (m_activePane >= paneCount())
            setActivePane(0);
        placeOverlays();
    }
    if (what & ~Changes(Change::Name)) // a moment is soon followed by the next
        refresh(m_drag.has_value() || m_document.inGesture() || what == Changes(Change::Moment));
    if (what & ~(Changes(Change::Camera) | Change::Moment))
        updateOverlays();
}

void Viewport::refresh(bool moving)
{
    m_stale = true;
    m_moving = moving;
    m_measuring.stop();
    m_smoothing.stop();
    if (moving)
        m_rest.start(kRestDelay);
    else
        m_rest.stop();
    update();
}

void Viewport::paintGL()
{
    if (!m_renderer || !m_assets.ready())
        return clearTo(defaultFramebufferObject(), 0.2f, 0.2f, 0.2f);
    if (m_stale)
        drawPanes(m_moving ? m_pacer.scale() : 1.);
    showPanes();
    Q_EMIT painted(m_shownScale >= 1.);
}

Expected<void> Viewport::drawPane(int pane, double scale, glm::vec2 shift)
{
    const PaneArea size = area(pane);
    Framebuffer& picture = m_pictures->drawn[std::size_t(pane)];
    picture.resize(scaled(size.width, scale), scaled(size.height, scale));
    const Target target{picture.handle(), picture.width(), picture.height(), false, float(std::max(1., devicePixelRatioF() * scale)), shift,
        scale < 1., false};
    return m_renderer->draw(m_document.state(), std::size_t(pane), m_reference->resourcesOf(pane), m_document.state().view, target);
}

void Viewport::drawPanes(double scale)
{
    QElapsedTimer clock;
    clock.start();
    QList<Message> troubles;
    for (int pane = 0; pane < paneCount(); ++pane) {
        m_pictures->smooth[std::size_t(pane)].restart();
        if (const auto drawn = drawPane(pane, scale, {}); !drawn)
            troubles.append({true, QString::fromStdString(message(drawn.error()))});
    }
    finishDrawing();
    m_pacer.took(double(clock.nsecsElapsed()) * 1e-6, scale);
    m_stale = false;
    m_shownScale = scale;
    // Later: what hears of it may change the layout, which must not happen while painting.
    QMetaObject::invokeMethod(
        this, [this, troubles] { drawn(troubles); }, Qt::QueuedConnection);
    if (scale >= 1. && troubles.isEmpty())
        m_measuring.start(kMeasureDelay);
}

void Viewport::drawn(const QList<Message>& troubles)
{
    // Maps that are being made, or were stopped, are told by Assets.
    m_messages.set("picture", missingBounds(m_document.state(), m_assets.resources()).empty() ? troubles : QList<Message>());
    if (troubles.isEmpty())
        return;
    m_measured = {}; // it was of another picture
    updateOverlays();
}

// One more shifted picture; the hand is heard between any two.
void Viewport::smooth()
{
    if (m_stale || !m_pictures)
        return;
    QElapsedTimer clock;
    clock.start();
    makeCurrent();
    for (int pane = 0; pane < paneCount(); ++pane) {
        Smoother& mean = m_pictures->smooth[std::size_t(pane)];
        if (drawPane(pane, 1., mean.nextShift()))
            mean.add(m_pictures->drawn[std::size_t(pane)]);
    }
    doneCurrent();
    if (smoothSamples() == 0)
        return;
    if (smoothSamples() < kSmoothSamples && clock.elapsed() < kSmoothLimit)
        m_smoothing.start(0);
    update();
}

void Viewport::showPanes()
{
    const unsigned screen = defaultFramebufferObject();
    if (paneCount() > 1)
        clearTo(screen, 0.1f, 0.1f, 0.1f); // the gap between them
    for (int pane = 0; pane < paneCount(); ++pane) {
        const PaneArea to = area(pane);
        if (Smoother& mean = m_pictures->smooth[std::size_t(pane)]; mean.count() > 0)
            mean.copyTo(screen, to.x, to.width, to.height);
        else
            copyTo(m_pictures->drawn[std::size_t(pane)], screen, to.x, to.width, to.height);
    }
}

// Counts the fetches of what is shown, then smooths the edges.
void Viewport::measure()
{
    if (m_stale || !m_renderer || !m_assets.ready())
        return;
    makeCurrent();
    for (int pane = 0; pane < paneCount(); ++pane) {
        const PaneArea size = area(pane);
        const auto measured = m_renderer->measure(
            m_document.state(), std::size_t(pane), m_assets.resources(), float(size.width) / float(std::max(size.height, 1)), false);
        m_measured[std::size_t(pane)] = measured ? std::optional(*measured) : std::nullopt;
    }
    doneCurrent();
    updateOverlays();
    if (m_reference->isShown())
        m_reference->want(area(0).width, area(0).height);
    else
        m_smoothing.start(0);
}

QImage Viewport::picture()
{
    if (!m_renderer || !m_assets.ready())
        return {};
    makeCurrent();
    const auto done = qScopeGuard([this] { doneCurrent(); });
    const PaneArea last = area(paneCount() - 1);
    QImage sheet(last.x + last.width, last.height, QImage::Format_RGBA8888);
    sheet.fill(Qt::transparent);
    QPainter painter(&sheet);
    for (int pane = 0; pane < paneCount(); ++pane) {
        const PaneArea size = area(pane);
        const auto drawn = drawPicture(*m_renderer, m_document.state(), std::size_t(pane), m_reference->resourcesOf(pane),
            m_document.state().view, size.width, size.height, m_reference->isShown() ? 1 : kSmoothSamples, false, false);
        if (!drawn)
            return {}; // the message line says why
        const QImage part(reinterpret_cast<const uchar*>(drawn->data.data()), drawn->width, drawn->height, QImage::Format_RGBA8888);
        painter.drawImage(size.x, 0, part);
    }
    return sheet;
}

} // namespace relievo
