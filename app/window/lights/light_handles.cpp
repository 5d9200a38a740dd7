// Drawing and dragging the handles of lights.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/lights/light_handles.h"
#include "app/window/document/assets.h"
#include "app/window/document/editing.h"
#include "app/window/panels/parameter_editor.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/painting.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {
constexpr double kReach = 16.; // px around a handle that take hold of it
constexpr double kSize = 9.; // px, radius of a handle's disc
// The picture is dark in either look, so what lies over it is light on dark in either.
const QColor kShade(0, 0, 0, 170), kBright(240, 240, 240);

Around aroundOf(const Mesh& mesh)
{
    return around(mesh.boundsMin, mesh.boundsMax);
}

// Rays all around; of a lamp fewer than of the sun.
void paintRays(QPainter& painter, QPointF at, int count)
{
    for (int i = 0; i < count; ++i) {
        const double angle = 2. * std::numbers::pi * i / count;
        const QPointF way(std::cos(angle), std::sin(angle));
        painter.drawLine(at + way * (kSize + 2.), at + way * (kSize + 5.));
    }
}

// Two edges of the cone, from the light towards the middle.
void paintCone(QPainter& painter, const LightHandle& handle, double degrees)
{
    const QPointF way = handle.middle - handle.at;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1.)
        return;
    for (const double side : {-0.5, 0.5}) {
        const double angle = std::atan2(way.y(), way.x()) + side * degrees * std::numbers::pi / 180.;
        const QPointF out(std::cos(angle), std::sin(angle));
        painter.drawLine(handle.at + out * kSize, handle.at + out * (kSize + std::min(26., length)));
    }
}

// From the light to what it shines on, with an arrow's head.
void paintWay(QPainter& painter, const LightHandle& handle)
{
    const QPointF way = handle.middle - handle.at;
    const double length = std::hypot(way.x(), way.y());
    if (length < 3. * kSize)
        return;
    const QPointF along = way / length, aside(-along.y(), along.x());
    const QPointF from = handle.at + along * (kSize + 6.), tip = handle.at + along * std::max(0.45 * length, kSize + 16.);
    painter.drawLine(from, tip);
    painter.drawPolyline(QPolygonF({tip - along * 6. + aside * 3.5, tip, tip - along * 6. - aside * 3.5}));
}
} // namespace

LightHandles::LightHandles(Document& document, Assets& assets, Viewport& viewport, std::function<bool(std::size_t)> isOpen)
    : QWidget(&viewport)
    , m_document(document)
    , m_assets(assets)
    , m_viewport(viewport)
    , m_isOpen(std::move(isOpen))
{
    setObjectName("lights");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    viewport.installEventFilter(this);
    connect(&document, &Document::changed, this, &LightHandles::update);
    connect(&assets, &Assets::resourcesChanged, this, &LightHandles::update);
    connect(&viewport.places(), &PanePlaces::arranged, this, &LightHandles::update);
    connect(&viewport.places(), &PanePlaces::composed, this, &LightHandles::update);
    hide();
}

CameraView LightHandles::camera(std::size_t pane) const
{
    const std::vector<PaneArea> areas = m_viewport.places().areas();
    return cameraOnto(*m_assets.drawnResources().mesh, cameraOf(m_document.state(), pane), areas[pane].aspect());
}

std::vector<LightHandle> LightHandles::handles() const
{
    std::vector<LightHandle> shown;
    if (!m_assets.ready() || !m_assets.drawnResources().mesh)
        return shown;
    const State& state = m_document.state();
    const Around mesh = aroundOf(*m_assets.drawnResources().mesh);
    const std::vector<PaneArea> areas = m_viewport.places().areas();
    for (std::size_t pane = 0; pane < std::min(areas.size(), state.panes.size()); ++pane) {
        const Parameters lit = effectiveParameters(state, pane);
        std::optional<CameraView> view; // framing a large mesh takes its time
        for (std::size_t light = 0; light < kLights.size(); ++light) {
            const bool isWanted = m_isHeld || m_drag || m_isOpen(light);
            if (areas[pane].isEmpty() || !isLit(lit, kLights[light]) || !isWanted)
                continue;
            if (!view)
                view = camera(pane);
            const LightPlace place = lightPlace(lit, kLights[light], mesh, *view);
            const auto inWindow = [&](glm::vec2 share) { return m_viewport.places().fromPicture(pane, share); };
            shown.push_back({pane, light, inWindow(place.share), inWindow(middlePlace(mesh, *view)), place});
        }
    }
    return shown;
}

void LightHandles::update()
{
    const bool wanted = !handles().empty();
    if (wanted && size() != m_viewport.size())
        resize(m_viewport.size());
    if (wanted && !isVisible())
        lower(); // under captions
    setVisible(wanted);
    if (wanted)
        QWidget::update();
}

void LightHandles::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    for (const LightHandle& handle : handles()) {
        const Parameters lit = effectiveParameters(m_document.state(), handle.pane);
        const LightMembers& light = kLights[handle.light];
        const bool isHeld = m_drag && m_drag->handle.light == handle.light;
        const QColor line = isHeld ? accent(palette()) : kBright;
        painter.setOpacity(handle.place.isBehind || !handle.place.isThere ? 0.6 : 1.);
        for (const auto& [color, width] : {std::pair(kShade, 4.), std::pair(line, 1.5)}) { // seen on any ground
            painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
            paintWay(painter, handle);
            if (lit.*light.kind == LightKind::Spot)
                paintCone(painter, handle, double(lit.*light.cone));
            else
                paintRays(painter, handle.at, lit.*light.kind == LightKind::Directional ? 12 : 6);
        }
        painter.setPen(QPen(line, 1.5, handle.place.isBehind ? Qt::DotLine : Qt::SolidLine));
        painter.setBrush(kShade);
        painter.drawEllipse(handle.at, kSize, kSize);
        painter.setPen(Qt::NoPen);
        painter.setBrush(toDisplay(lit.*light.color));
        painter.drawEllipse(handle.at, kSize - 2.5, kSize - 2.5);
        painter.setPen(toDisplay(lit.*light.color).lightness() > 110 ? Qt::black : Qt::white);
        painter.drawText(QRectF(handle.at.x() - 10., handle.at.y() - 10., 20., 20.), Qt::AlignCenter, QString::number(handle.light + 1));
    }
}

bool LightHandles::eventFilter(QObject* viewport, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        if (const auto* key = static_cast<QKeyEvent*>(event);
            (key->key() == Qt::Key_Shift || key->key() == Qt::Key_L) && !key->isAutoRepeat())
            setHeld(event->type() == QEvent::KeyPress && !(key->modifiers() & Qt::ControlModifier));
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
        if (m_drag)
            move(static_cast<QMouseEvent*>(event)->position());
        return m_drag.has_value();
    case QEvent::MouseButtonRelease: {
        const bool isMine = m_drag.has_value();
        if (isMine && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
            letGo();
        return isMine;
    }
    case QEvent::Wheel: {
        if (!m_drag)
            return false;
        const double steps = double(static_cast<QWheelEvent*>(event)->angleDelta().y()) / 120.;
        edit([&](Parameters& lit) { pushLight(lit, kLights[m_drag->handle.light], steps); });
        return true;
    }
    case QEvent::Resize:
        update();
        return false;
    case QEvent::FocusOut:
        letGo();
        setHeld(false);
        return false;
    default:
        return QWidget::eventFilter(viewport, event);
    }
}

void LightHandles::setHeld(bool held)
{
    m_isHeld = held;
    update();
}

bool LightHandles::press(const QMouseEvent& event)
{
    if (m_drag)
        return true;
    if (event.button() != Qt::LeftButton || (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)))
        return false;
    if (const bool shift = bool(event.modifiers() & Qt::ShiftModifier); shift && !m_isHeld)
        setHeld(true); // pressed while another widget had the focus
    double nearest = kReach;
    for (const LightHandle& handle : handles()) {
        const QPointF grip = handle.at - event.position();
        if (const double away = std::hypot(grip.x(), grip.y()); away < nearest) {
            nearest = away;
            m_drag = Drag{handle, grip, event.position()};
        }
    }
    if (!m_drag)
        return false;
    m_viewport.setFocus();
    m_viewport.setActivePane(int(m_drag->handle.pane));
    m_document.beginGesture();
    update();
    return true;
}

void LightHandles::edit(const std::function<void(Parameters&)>& change)
{
    const std::size_t pane = m_drag->handle.pane;
    const LightMembers& light = kLights[m_drag->handle.light];
    m_document.edit(tr("Move light %1").arg(m_drag->handle.light + 1), [&](State& state) {
        Parameters lit = effectiveParameters(state, pane);
        change(lit);
        const Scope scope = isLinked(state, pane) ? kAllPanes : Scope(pane); // an unlinked pane's light is its own too
        for (const Member& member : {Member(light.yaw), Member(light.pitch), Member(light.distance)}) {
            const ParameterRow& row = kParameters[indexOf(member)];
            if (get(lit, row) != get(effectiveParameters(state, pane), row))
                assign(state, row, get(lit, row), scope);
        }
    });
    m_viewport.say(told());
}

void LightHandles::move(QPointF at)
{
    const LightHandle& handle = m_drag->handle;
    const QPointF moved = at - m_drag->last;
    m_drag->last = at;
    edit([&](Parameters& lit) {
        const LightMembers& light = kLights[handle.light];
        if (!handle.place.isThere)
            return turnLight(lit, light, moved.x(), moved.y());
        const glm::vec2 share = m_viewport.places().toPicture(handle.pane, at + m_drag->grip);
        moveLight(lit, light, aroundOf(*m_assets.drawnResources().mesh), camera(handle.pane), share, handle.place.isBehind);
    });
}

QString LightHandles::told() const
{
    const Parameters lit = effectiveParameters(m_document.state(), m_drag->handle.pane);
    const LightMembers& light = kLights[m_drag->handle.light];
    QString text = tr("Light %1  direction %2\u00b0  height %3\u00b0  %4 W/m\u00b2")
                       .arg(m_drag->handle.light + 1)
                       .arg(double(turnedYaw(lit, light)), 0, 'f', 0)
                       .arg(double(lit.*light.pitch), 0, 'f', 0)
                       .arg(double(irradianceOf(lit, light)), 0, 'g', 3);
    if (isNear(lit, light))
        text += tr(" at the middle  %1 W/sr  distance %2 (wheel)")
                    .arg(double(radiantIntensityOf(lit, light, aroundOf(*m_assets.drawnResources().mesh))), 0, 'g', 3)
                    .arg(double(lit.*light.distance), 0, 'f', 2);
    return text;
}

void LightHandles::letGo()
{
    if (!m_drag)
        return;
    m_drag.reset();
    m_viewport.say({});
    m_document.endGesture();
    update();
}

} // namespace relievo
