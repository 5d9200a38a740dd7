// Drawing the panes: when and how finely.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/viewport.h"
#include "app/window/viewport/gl_calls.h"
#include <QElapsedTimer>
#include <QScopeGuard>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr int kRestDelay = 100; // ms without a move until the full picture
constexpr int kMeasureDelay = 60; // ms from the full picture to the counting of fetches
constexpr double kSlice = 25; // ms of smoothing between two looks at what the hand does
} // namespace

Viewport::Viewport(Document& document, Assets& assets, Messages& messages, QWidget* parent)
    : QOpenGLWidget(parent)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
    , m_reference(new MeshReference(document, assets, messages, this)) // hears of changes before the picture does
    , m_navigator(new Navigator(document,
          {.isReady = [this] { return m_assets.ready(); },
              .paneAt = [this](QPointF at) { return paneAt(areas(), at * devicePixelRatioF()).value_or(std::size_t(m_activePane)); },
              .view = [this](std::size_t pane) { return view(pane); },
              .activePane = [this] { return std::size_t(m_activePane); }},
          this))
    , m_overlays(this, document, [this](std::size_t pane) { setActivePane(int(pane)); })
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 160);
    setUpdateBehavior(QOpenGLWidget::PartialUpdate);
    for (QTimer* timer : {&m_rest, &m_measuring, &m_smoothing})
        timer->setSingleShot(true);
    connect(&m_smoothing, &QTimer::timeout, this, &Viewport::smooth);
    connect(&m_rest, &QTimer::timeout, this, [this] { refresh(false); });
    connect(&m_measuring, &QTimer::timeout, this, &Viewport::measure);
    connect(&m_shaderWatch, &QTimer::timeout, this, [this] {
        if (m_pictures && m_pictures->shadersChanged())
            refresh(false);
    });
    if (qEnvironmentVariableIsSet("RELIEVO_SHADERS"))
        m_shaderWatch.start(500);
    connect(&document, &Document::changed, this, &Viewport::documentChanged);
    connect(&document, &Document::gestureEnded, this, [this] { refresh(false); });
    connect(&assets, &Assets::resourcesChanged, this, [this] { refresh(false); });
    connect(&assets, &Assets::earlyChanged, this, [this] { refresh(m_assets.drawsEarly()); });
    connect(m_reference, &MeshReference::progressed, this, &Viewport::updateOverlays);
    connect(m_reference, &MeshReference::made, this, [this] { refresh(false); });
    connect(m_navigator, &Navigator::pressed, this, [this](std::size_t pane) { setActivePane(int(pane)); });
    connect(m_navigator, &Navigator::wheeled, this, [this] { refresh(true); });
    connect(m_navigator, &Navigator::hint, this, [this](const QString& text) { m_overlays.say(text); });
    connect(m_navigator, &Navigator::clicked, this, &Viewport::clicked);
    connect(m_navigator, &Navigator::ended, this, [this](bool movedCamera) { movedCamera&& m_moving ? refresh(false) : void(); });
    updateOverlays();
}

void Viewport::wantSamples(int samples)
{
    m_samplesAtRest.want(samples);
    refresh(false);
}

Viewport::~Viewport()
{
    delete m_navigator; // the focus that is lost at the end is no gesture any more
    makeCurrent();
    m_pictures.reset();
    doneCurrent();
}

void Viewport::initializeGL()
{
    if (const auto suffices = openGLSuffices(); !suffices)
        return m_messages.set("picture", suffices.error());
    m_pictures = std::make_unique<PanePictures>();
}

void Viewport::resizeGL(int, int)
{
    updateOverlays();
    refresh(m_shownScale > 0.); // coarse while the window is pulled larger
}

std::vector<PaneArea> Viewport::areas() const
{
    const auto pixels = [this](int size) { return std::max(1, int(std::lround(size * devicePixelRatioF()))); };
    return paneAreas(int(paneCount()), pixels(width()), pixels(height()));
}

ShownScene Viewport::scene() const
{
    return {m_assets.drawnState(), m_assets.drawnResources(), *m_reference, devicePixelRatioF()};
}

Navigator::PaneView Viewport::view(std::size_t pane) const
{
    const std::vector<PaneArea> all = areas();
    const PaneArea& area = all[std::min(pane, all.size() - 1)];
    const Mesh& mesh = *m_assets.drawnResources().mesh;
    return {cameraOnto(mesh, cameraOf(m_document.state(), pane), area.aspect()), double(area.height) / devicePixelRatioF()};
}

void Viewport::documentChanged(Changes what)
{
    if (what & Change::Panes) {
        m_measured.clear();
        if (m_activePane >= int(paneCount()))
            setActivePane(0);
    }
    if (what & ~Changes(Change::Name)) // a moment is soon followed by the next
        refresh(m_navigator->isDragging() || m_document.inGesture() || what == Changes(Change::Moment));
    if (what & ~(Changes(Change::Camera) | Change::Moment))
        updateOverlays();
}

void Viewport::refresh(bool moving)
{
    m_stale = true;
    m_moving = moving;
    m_measuring.stop();
    m_smoothing.stop();
    m_rest.stop();
    if (moving && !m_assets.drawsEarly()) // after an early picture more comes soon
        m_rest.start(kRestDelay);
    update();
}

void Viewport::paintGL()
{
    if (!m_pictures || !m_assets.drawnResources().mesh)
        return clearTo(defaultFramebufferObject(), 0.2f, 0.2f, 0.2f);
    if (m_stale)
        drawPanes(m_moving ? m_pacer.scale() : 1.);
    m_pictures->show(defaultFramebufferObject(), areas(), std::max(1, int(std::lround(height() * devicePixelRatioF()))));
    Q_EMIT painted(m_shownScale >= 1.);
}

void Viewport::drawPanes(double scale)
{
    QElapsedTimer clock;
    clock.start();
    QList<Message> troubles;
    for (const Error& error : m_pictures->draw(scene(), areas(), scale))
        troubles.append({true, QString::fromStdString(message(error))});
    finishDrawing();
    m_pacer.took(double(clock.nsecsElapsed()) * 1e-6, scale);
    m_stale = false;
    m_shownScale = scale;
    QTimer::singleShot(0, this, [this, troubles] { drawn(troubles); }); // what hears of it may change the layout: not while painting
    if (scale >= 1. && std::size_t(troubles.size()) < paneCount()) // one that cannot be drawn does not stop the others
        m_measuring.start(kMeasureDelay);
}

void Viewport::drawn(const QList<Message>& troubles)
{
    // Maps that are being made, or were stopped, are told by Assets.
    const Resources& resources = m_assets.drawnResources();
    const bool waits = !resources.accelerationMaps.missingFor(m_assets.drawnState(), *resources.material).empty();
    m_messages.set("picture", waits ? QList<Message>() : troubles);
    if (!troubles.isEmpty())
        m_measured.clear(), updateOverlays(); // it was of another picture
}

// A slice more of the shifted pictures; the hand is heard between any two.
void Viewport::smooth()
{
    if (m_stale || !m_pictures)
        return;
    makeCurrent();
    const bool isWhole = m_pictures->addSlice(scene(), areas(), kSlice);
    doneCurrent();
    if (!isWhole || !m_samplesAtRest.isEnough(smoothSamples()))
        m_smoothing.start(0);
    if (isWhole && m_samplesAtRest.isShown(smoothSamples()))
        update();
}

// Counts the fetches of what is shown, then smooths the edges.
void Viewport::measure()
{
    if (m_stale || !m_pictures || !m_assets.ready())
        return;
    makeCurrent();
    m_measured = m_pictures->measure(scene(), areas());
    doneCurrent();
    updateOverlays();
    m_reference->want(areas());
    m_samplesAtRest.begin();
    m_smoothing.start(0);
}

QImage Viewport::picture()
{
    if (!m_pictures || !m_assets.ready())
        return {};
    makeCurrent();
    const auto done = qScopeGuard([this] { doneCurrent(); });
    return m_pictures->sheet({m_document.state(), m_assets.resources(), *m_reference, devicePixelRatioF()}, areas(), SamplesAtRest::kLeast);
}

void Viewport::setActivePane(int pane)
{
    pane = std::clamp(pane, 0, int(paneCount()) - 1);
    if (pane == m_activePane)
        return;
    m_activePane = pane;
    updateOverlays();
    Q_EMIT activePaneChanged(pane);
}

void Viewport::updateOverlays()
{
    m_overlays.update(m_measured, *m_reference, std::size_t(m_activePane));
    m_overlays.place(areas(), devicePixelRatioF());
}

} // namespace relievo
