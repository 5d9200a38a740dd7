// Comparing two panes in one place.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/in_place.h"
#include "app/window/document/document.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {
namespace {
constexpr int kBlink = 600; // ms that each picture stays
constexpr double kReach = 7.; // px from the line within which it is taken
constexpr int kNarrow = 240, kCaption = 48; // px that a caption wants across, and takes down
constexpr float kMargin = 0.02f; // of the picture that a line cannot leave
} // namespace

InPlace::InPlace(Document& document, QWidget* widget) : QObject(widget), m_document(document), m_widget(widget)
{
    widget->installEventFilter(this);
    widget->setMouseTracking(true);
    m_blinking.setInterval(kBlink);
    connect(&m_blinking, &QTimer::timeout, this, [this] {
        m_blinked = !m_blinked;
        Q_EMIT composed();
    });
}

void InPlace::setMode(InPlaceMode mode)
{
    if (mode == m_mode)
        return;
    m_mode = mode;
    m_blinked = false;
    mode == InPlaceMode::Blink ? m_blinking.start() : m_blinking.stop();
    m_widget->unsetCursor();
    Q_EMIT arranged();
}

void InPlace::setPair(std::size_t first, std::size_t second)
{
    if (first == second || m_pair == std::pair(first, second))
        return;
    m_pair = {first, second};
    Q_EMIT arranged();
}

std::pair<std::size_t, std::size_t> InPlace::pair() const
{
    const std::size_t count = m_document.state().panes.size();
    return std::max(m_pair.first, m_pair.second) < count ? m_pair : std::pair(std::size_t(0), std::min(std::size_t(1), count - 1));
}

void InPlace::setGain(float gain)
{
    m_gain = std::clamp(gain, 1.f, 64.f);
    Q_EMIT composed();
}

void InPlace::setSigned(bool isSigned)
{
    m_isSigned = isSigned;
    Q_EMIT composed();
}

bool InPlace::isOn() const
{
    return m_document.state().panes.size() > 1 && (m_mode != InPlaceMode::SideBySide || m_holds);
}

Composition InPlace::composition() const
{
    using How = Composition::How;
    Composition composition{
        .divider = m_divider, .angle = m_angle, .lineWidth = float(1.5 * m_widget->devicePixelRatioF()), .gain = m_gain};
    if (m_holds || m_mode == InPlaceMode::Blink)
        composition.how = m_holds || m_blinked ? How::Second : How::First;
    else if (m_mode == InPlaceMode::Wipe)
        composition.how = How::Wipe;
    else if (m_mode == InPlaceMode::Difference)
        composition.how = m_isSigned ? How::SignedDifference : How::Difference;
    return composition;
}

std::vector<PaneArea> InPlace::areas(int width, int height) const
{
    const std::size_t count = m_document.state().panes.size();
    if (!isOn())
        return paneAreas(int(count), width, height);
    std::vector<PaneArea> areas(count);
    areas[pair().first] = areas[pair().second] = {0, 0, std::max(width, 1), std::max(height, 1)};
    return areas;
}

std::vector<PaneArea> InPlace::captionAreas(int width, int height) const
{
    std::vector<PaneArea> places = areas(width, height);
    if (!isOn())
        return places;
    const auto [first, second] = pair();
    if (const auto how = composition().how;
        how == Composition::How::Second || (how == Composition::How::First && m_mode != InPlaceMode::Flip)) {
        places[how == Composition::How::First ? second : first] = {};
        return places;
    }
    const double ratio = m_widget->devicePixelRatioF();
    if (width / 2 < kNarrow * ratio) { // one under the other
        places[second].y = int(kCaption * ratio), places[second].height -= places[second].y;
        return places;
    }
    places[first].width = width / 2;
    places[second].x = width - width / 2, places[second].width = width / 2;
    return places;
}

std::size_t InPlace::paneAt(QPointF position) const
{
    const Composition shown = composition();
    const bool isSecond = shown.how == Composition::How::Wipe
        ? isSecondAt(shown, shareOf(position), float(m_widget->width()) / float(std::max(m_widget->height(), 1)))
        : shown.how == Composition::How::Second;
    return isSecond ? pair().second : pair().first;
}

glm::vec2 InPlace::shareOf(QPointF position) const
{
    return {position.x() / std::max(m_widget->width(), 1), position.y() / std::max(m_widget->height(), 1)};
}

bool InPlace::isNearLine(QPointF position) const
{
    if (!isOn() || m_holds || m_mode != InPlaceMode::Wipe)
        return false;
    const double angle = glm::radians(double(m_angle));
    const double dx = position.x() - double(m_divider.x) * m_widget->width(), dy = position.y() - double(m_divider.y) * m_widget->height();
    return std::abs(dx * std::cos(angle) + dy * std::sin(angle)) <= kReach;
}

bool InPlace::eventFilter(QObject*, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        return mouse(*static_cast<QMouseEvent*>(event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        return key(*static_cast<QKeyEvent*>(event));
    case QEvent::FocusOut:
        hold(false);
        return false;
    default:
        return false;
    }
}

bool InPlace::mouse(const QMouseEvent& event)
{
    if (m_grip == Grip::None) {
        const bool near = event.buttons() == Qt::NoButton ? isNearLine(event.position()) : m_pointsAtLine;
        if (std::exchange(m_pointsAtLine, near) != near)
            near ? m_widget->setCursor(Qt::SizeHorCursor) : m_widget->unsetCursor();
        if (event.type() != QEvent::MouseButtonPress || event.button() != Qt::LeftButton || !isNearLine(event.position()))
            return false;
        m_grip = event.modifiers() & Qt::ShiftModifier ? Grip::Turn : Grip::Move;
        return true;
    }
    if (event.type() == QEvent::MouseButtonRelease && event.button() == Qt::LeftButton)
        m_grip = Grip::None;
    const glm::vec2 at = shareOf(event.position());
    if (m_grip == Grip::Move)
        m_divider = glm::clamp(at, glm::vec2(kMargin), glm::vec2(1.f - kMargin));
    const double dx = double(at.x - m_divider.x) * m_widget->width(), dy = double(at.y - m_divider.y) * m_widget->height();
    if (m_grip == Grip::Turn && std::hypot(dx, dy) > 2. * kReach) // the line points at the hand, either end of it
        m_angle = float(std::remainder(glm::degrees(std::atan2(dy, dx)) - 90., 180.));
    Q_EMIT composed();
    return true;
}

// V shows the second picture in the place of the first for as long as it is held.
bool InPlace::key(const QKeyEvent& event)
{
    if (event.key() != Qt::Key_V || event.modifiers() != Qt::NoModifier)
        return false;
    if (event.type() == QEvent::ShortcutOverride)
        const_cast<QKeyEvent&>(event).accept();
    else if (!event.isAutoRepeat())
        hold(event.type() == QEvent::KeyPress);
    return true;
}

void InPlace::hold(bool other)
{
    if (std::exchange(m_holds, other) != other)
        m_mode == InPlaceMode::SideBySide ? Q_EMIT arranged() : Q_EMIT composed();
}

} // namespace relievo
