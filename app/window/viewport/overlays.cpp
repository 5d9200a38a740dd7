// Captions, legend and hint, painted over the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/slider_scale.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace relievo {
namespace {
// The picture is dark in either look, so what lies over it is light on dark in either.
const QColor kShade(0, 0, 0, 150), kBright(240, 240, 240), kQuiet(190, 190, 190);
constexpr int kPadding = 8, kArrow = 14, kHistogram = 56; // px

void shade(QPainter& painter, const QRect& rect)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kShade);
    painter.drawRoundedRect(rect, 4, 4);
}
} // namespace

QString techniqueText(const State& state, std::size_t pane)
{
    const TechniqueRow* technique = findTechnique(state.panes[pane].technique);
    if (!technique)
        return QString::fromStdString(state.panes[pane].technique);
    const Parameters p = effectiveParameters(state, pane);
    QString text = qt(technique->label);
    if (technique->parameters.contains(&Parameters::maxSteps))
        text += p.minSteps == p.maxSteps ? QString(" %1").arg(p.maxSteps) : QString(" %1\u2013%2").arg(p.minSteps).arg(p.maxSteps);
    if (technique->parameters.contains(&Parameters::leapSteps))
        text += QString(" %1").arg(p.leapSteps);
    if (technique->parameters.contains(&Parameters::refineSteps) && p.refineSteps > 0)
        text += QString("+%1").arg(p.refineSteps);
    return text;
}

QString paneLetter(std::size_t pane)
{
    return QString(QChar('A' + int(pane)));
}

CaptionChoice::CaptionChoice(const char* name, const QString& tip, QWidget* parent) : QAbstractButton(parent)
{
    setObjectName(name);
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tip);
}

QSize CaptionChoice::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(text()) + 1 + kArrow + 2 * kPadding, kRowHeight}; // 1: advances are rounded
}

void CaptionChoice::mousePressEvent(QMouseEvent* event)
{
    m_pressedAt = event->position().toPoint();
    QAbstractButton::mousePressEvent(event);
}

void CaptionChoice::mouseMoveEvent(QMouseEvent* event)
{
    if (!isDown() || (event->position().toPoint() - m_pressedAt).manhattanLength() < QApplication::startDragDistance())
        return QAbstractButton::mouseMoveEvent(event);
    setDown(false);
    Q_EMIT pulled();
}

void CaptionChoice::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || isDown()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(255, 255, 255, 36));
        painter.drawRoundedRect(rect().adjusted(2, 2, -2, -2), 3, 3);
    }
    painter.setPen(kBright);
    const QRect room = rect().adjusted(kPadding, 0, -kPadding - kArrow, 0);
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
    painter.setPen(QPen(kQuiet, 1.2));
    const QPointF tip(width() - kPadding - 2.5, height() / 2. + 2);
    painter.drawPolyline(QPolygonF({tip + QPointF(-3.5, -3.5), tip, tip + QPointF(3.5, -3.5)}));
}

PaneCaption::PaneCaption(QWidget* parent)
    : QWidget(parent)
    , m_more(new CaptionChoice("more", tr("What can be done with this picture; drag it onto another to swap them"), this))
    , m_technique(new CaptionChoice("technique", tr("Choose the technique of this picture; drag it onto another to draw that by it"), this))
    , m_view(new CaptionChoice("view", tr("Choose what this picture shows"), this))
{
    setCursor(Qt::ArrowCursor);
}

void PaneCaption::show(const QString& letter, const QString& technique, const QString& view, const QString& cost, bool active)
{
    setAccessibleName((letter + u' ' + technique + u' ' + view + u' ' + cost).simplified());
    // Only what differs is painted again: a repaint beside the picture costs as much as a small picture.
    if (m_technique->text() != technique)
        m_technique->setText(technique);
    if (m_view->text() != view)
        m_view->setText(view);
    if (m_more->text() != letter)
        m_more->setText(letter);
    m_more->setVisible(!letter.isEmpty());
    if (std::tie(cost, active) == std::tie(m_cost, m_active))
        return;
    m_cost = cost, m_active = active;
    update();
}

int PaneCaption::wide(const QString& text) const
{
    return text.isEmpty() ? 0 : fontMetrics().horizontalAdvance(text) + 1 + kPadding;
}

void PaneCaption::fit(int room)
{
    const int start = m_more->isHidden() ? 0 : m_more->sizeHint().width() - kPadding / 2;
    m_more->setGeometry(0, 0, m_more->sizeHint().width(), kRowHeight);
    int technique = m_technique->sizeHint().width(), view = m_view->sizeHint().width();
    const int most = std::max(room - start, 0);
    if (technique + view > most) {
        view = std::min(view, std::max(most * 2 / 5, most - technique));
        technique = std::min(technique, most - view);
    }
    m_technique->setGeometry(start, 0, technique, kRowHeight);
    m_view->setGeometry(start + technique, 0, view, kRowHeight);
    const int end = start + technique + view, beside = end + kPadding + wide(m_cost), under = 2 * kPadding + wide(m_cost);
    const bool isUnder = !m_cost.isEmpty() && beside > room && under <= room;
    const bool isShown = !m_cost.isEmpty() && (beside <= room || isUnder);
    m_costFrom = !isShown ? QPoint() : isUnder ? QPoint(kPadding, kRowHeight - 3) : QPoint(end + kPadding, 0);
    resize(isUnder ? std::max(end, under) : isShown ? beside : end, isUnder ? 2 * kRowHeight - 6 : kRowHeight);
}

void PaneCaption::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    shade(painter, rect());
    if (!m_costFrom.isNull()) {
        painter.setPen(kQuiet);
        painter.drawText(QRect(m_costFrom, QSize(width(), kRowHeight)), Qt::AlignVCenter | Qt::AlignLeft, m_cost);
    }
    if (m_active && !m_more->isHidden()) {
        painter.setPen(QPen(accent(palette()), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
}

HeatLegend::HeatLegend(QWidget* parent) : QWidget(parent)
{
    setCursor(Qt::ArrowCursor);
    setFont(smallFont());
    setToolTip(tr("Double click: the scale ends where 99 % of the pixels lie below"));
    resize(sizeHint());
}

void HeatLegend::show(const QString& title, const QString& unit, double max, const std::optional<HeatNumbers>& numbers)
{
    const bool isSame = std::tie(title, unit, max) == std::tie(m_title, m_unit, m_max) && !numbers && !m_numbers;
    m_title = title, m_unit = unit, m_max = max, m_numbers = numbers;
    if (!isSame)
        update();
}

QSize HeatLegend::sizeHint() const
{
    return {268, 76 + (m_isOpen ? kHistogram : 0)};
}

// The histogram stands above the scale.
void HeatLegend::unfold(bool open)
{
    open = open && m_numbers;
    if (std::exchange(m_isOpen, open) == open)
        return;
    const int more = open ? kHistogram : -kHistogram;
    setGeometry(x(), y() - more, width(), height() + more);
    raise();
}

void HeatLegend::mouseDoubleClickEvent(QMouseEvent*)
{
    if (m_numbers && m_numbers->p99 > 0.)
        Q_EMIT fitWanted(m_numbers->p99);
}

void HeatLegend::paintHistogram(QPainter& painter, const QRect& room) const
{
    const auto& shares = m_numbers->histogram;
    const float most = std::max(*std::ranges::max_element(shares), 1e-6f);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const int from = room.left() + room.width() * int(i) / int(shares.size());
        const int to = room.left() + room.width() * int(i + 1) / int(shares.size());
        const int high = int(std::lround(std::sqrt(shares[i] / most) * float(room.height()))); // the root: what is rare is seen as well
        const glm::vec3 c = heatColor((float(i) + 0.5f) / float(shares.size()));
        painter.fillRect(from, room.bottom() + 1 - high, std::max(to - from - 1, 1), high, QColor::fromRgbF(c.x, c.y, c.z));
    }
}

void HeatLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    shade(painter, rect());
    const int top = m_isOpen ? kHistogram : 0;
    const QRect bar(12, top + 8, width() - 24, 10);
    if (m_isOpen && m_numbers)
        paintHistogram(painter, {bar.left(), 10, bar.width(), kHistogram - 8});
    for (int x = 0; x < bar.width(); ++x) { // the colours of the picture, by the picture's own text
        const glm::vec3 c = heatColor((float(x) + 0.5f) / float(bar.width()));
        painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(), QColor::fromRgbF(c.x, c.y, c.z));
    }
    painter.setPen(kBright);
    int marks = 4;
    const auto number = [&](int i) { return (i == marks ? QString::fromUtf8("\u2265 ") : QString()) + plainNumber(m_max * i / marks); };
    const auto widest = [&] {
        int most = 0;
        for (int i = 0; i <= marks; ++i)
            most = std::max(most, fontMetrics().horizontalAdvance(number(i)));
        return most;
    };
    while (marks > 1 && (widest() + kPadding) * marks > bar.width()) // fewer where they would run together
        marks /= 2;
    for (int i = 0; i <= marks; ++i) {
        const int x = bar.left() + (bar.width() - 1) * i / marks;
        painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + 3);
        const int w = fontMetrics().horizontalAdvance(number(i));
        painter.drawText(std::clamp(x - w / 2, 4, width() - w - 4), bar.bottom() + 5 + fontMetrics().ascent(), number(i));
    }
    const auto line = [&](int from, const QString& text, const QColor& color) {
        painter.setPen(color);
        painter.drawText(QRect(12, from, width() - 24, 14), Qt::AlignCenter, fontMetrics().elidedText(text, Qt::ElideRight, width() - 24));
    };
    line(height() - 33, caption(), kQuiet);
    line(height() - 17, summary(), kBright);
}

QString HeatLegend::summary() const
{
    if (!m_numbers)
        return {};
    // What is next to nothing on this scale is nothing.
    const auto text = [this](double value) { return value < 1e-4 * m_max ? QString("0") : QString::number(value, 'g', 3); };
    return tr("mean %1    99 % %2    most %3").arg(text(m_numbers->mean), text(m_numbers->p99), text(m_numbers->most));
}

QString HeatLegend::caption() const
{
    if (m_unit == "depth")
        return tr("%1 (share of the depth)").arg(m_title);
    return m_title.compare(m_unit, Qt::CaseInsensitive) == 0 ? tr("%1 a pixel").arg(m_title) : QString("%1 (%2)").arg(m_title, m_unit);
}

Hint::Hint(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void Hint::say(const QString& text)
{
    m_text = text;
    setVisible(!text.isEmpty());
    resize(sizeHint());
    update();
}

QSize Hint::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(m_text) + 3 * kPadding, kRowHeight};
}

void Hint::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    shade(painter, rect());
    painter.setPen(kBright);
    painter.drawText(rect(), Qt::AlignCenter, m_text);
}

} // namespace relievo
