// Drawing the panes: when and how finely.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/viewport.h"
#include "app/window/viewport/gl_calls.h"
#include "app/window/viewport/pane_drops.h"
#include <QElapsedTimer>
#include <QScopeGuard>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr int kRestDelay = 100; // ms without a move until the full picture
} // namespace

Viewport::Viewport(Document& document, Assets& assets, Messages& messages, QWidget* parent)
    : QOpenGLWidget(parent)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
    , m_reference(new MeshReference(document, assets, messages, this)) // hears of changes before the picture does
    , m_navigator(new Navigator(document,
          {.isReady = [this] { return m_assets.ready(); },
              .paneAt = [this](QPointF at) { return m_places->under(at); },
              .view = [this](std::size_t pane) { return view(pane); },
              .activePane = [this] { return std::size_t(m_activePane); }},
          this))
    , m_places(new PanePlaces(
          document, [this] { return std::size_t(m_activePane); }, this))
    , m_atRest(new AtRest([this] { return scene(); }, *m_places, this))
    , m_overlays(this, document,
          {.pressed = [this](std::size_t pane) { setActivePane(int(pane)); },
              .ownValuesWanted = [this](std::size_t pane) { Q_EMIT ownValuesWanted(pane); }})
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 160);
    setUpdateBehavior(QOpenGLWidget::PartialUpdate);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] { refresh(false); });
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
    connect(m_atRest, &AtRest::filled, this, [this](double ms) {
        m_pacer.took(ms, 1.);
        m_shownScale = 1.;
        update();
        if (m_assets.ready())
            m_atRest->start(*m_pictures, true);
    });
    connect(m_atRest, &AtRest::counted, this, [this] { updateOverlays(), m_reference->want(areas()); });
    connect(m_atRest, &AtRest::smoothed, this, qOverload<>(&Viewport::update));
    connect(m_places, &PanePlaces::arranged, this, [this] { refresh(false), updateOverlays(); });
    connect(m_places, &PanePlaces::composed, this, [this] { update(), updateOverlays(); });
    connect(&m_places->zoom(), &PixelZoom::changed, this, [this] {
        const int factor = m_places->zoom().factor();
        m_overlays.say(factor > 1 ? tr("%1 x    middle drag moves, Esc shows all").arg(factor) : QString());
    });
    new PaneDrops(
        document, [this](QPointF at) { return m_places->under(at); }, this);
    connect(m_navigator, &Navigator::pressed, this, [this](std::size_t pane) { setActivePane(int(pane)); });
    connect(m_navigator, &Navigator::wheeled, this, [this] { refresh(true); });
    connect(m_navigator, &Navigator::hint, this, [this](const QString& text) { m_overlays.say(text); });
    connect(m_navigator, &Navigator::clicked, this, &Viewport::clicked);
    connect(m_navigator, &Navigator::ended, this, [this](bool movedCamera) { movedCamera&& m_moving ? refresh(false) : void(); });
    updateOverlays();
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
        m_atRest->forget();
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
    m_atRest->stop();
    m_places->flip().forget();
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
        drawPanes(m_pacer.scale()); // in full where that is quick enough, else by slices at rest
    m_pictures->show(defaultFramebufferObject(), m_places->arrangement(), std::max(1, int(std::lround(height() * devicePixelRatioF()))));
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
    if (!m_moving && (m_assets.ready() || scale < 1.) && std::size_t(troubles.size()) < paneCount()) // one does not stop the others
        m_atRest->start(*m_pictures, scale >= 1.);
}

void Viewport::drawn(const QList<Message>& troubles)
{
    // Maps that are being made, or were stopped, are told by Assets.
    const Resources& resources = m_assets.drawnResources();
    const bool waits = !resources.accelerationMaps.missingFor(m_assets.drawnState(), *resources.material).empty();
    m_messages.set("picture", waits ? QList<Message>() : troubles);
    if (!troubles.isEmpty())
        m_atRest->forget(), updateOverlays(); // it was of another picture
}

Image Viewport::pixelsAround(std::size_t pane, glm::vec2 share, int radius)
{
    if (!m_pictures)
        return {};
    makeCurrent();
    const auto done = qScopeGuard([this] { doneCurrent(); });
    return m_pictures->around(pane, share, radius);
}

std::optional<glm::vec2> Viewport::worstPoint(std::size_t pane)
{
    if (!m_pictures || !m_assets.ready())
        return {};
    makeCurrent();
    const auto done = qScopeGuard([this] { doneCurrent(); });
    return m_pictures->worst(scene(), pane, areas()[pane]);
}

QImage Viewport::picture()
{
    if (!m_pictures || !m_assets.ready())
        return {};
    if (m_places->inPlace().isOn())
        return grabFramebuffer();
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
    m_overlays.update(m_atRest->measured(), *m_reference, std::size_t(m_activePane));
    m_overlays.place(m_places->captionAreas(), devicePixelRatioF());
}

} // namespace relievo
