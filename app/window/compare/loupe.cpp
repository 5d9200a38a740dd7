// Looking closely.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/loupe.h"
#include "app/window/document/assets.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/theme.h"
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr int kRadius = 5, kSquare = 11; // pixels around the middle one; px that each is wide
constexpr int kGlass = (2 * kRadius + 1) * kSquare, kPadding = 8, kAway = 20; // px
constexpr int kRestDelay = 40; // ms that the pointer rests before rays are searched
constexpr int kMostLines = 5;

PickedPoint pointAt(const Viewport& viewport, QPointF position)
{
    const std::size_t pane = viewport.places().under(position);
    return {pane, viewport.places().toPicture(pane, position), viewport.places().areas()[pane].aspect()};
}
} // namespace

LoupeGlass::LoupeGlass(QWidget* viewport) : QWidget(viewport)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFont(smallFont());
    resize(sizeHint());
    hide();
}

QSize LoupeGlass::sizeHint() const
{
    return {kGlass + 2 * kPadding, kGlass + 3 * kPadding + kMostLines * fontMetrics().lineSpacing()};
}

void LoupeGlass::show(const Image& pixels, const QStringList& lines)
{
    m_pixels = pixels, m_lines = lines;
    setAccessibleName(lines.join(", "));
    setVisible(true);
    raise();
    update();
}

QColor LoupeGlass::color() const
{
    if (m_pixels.data.empty())
        return {};
    const auto channel = [this](int i) { return m_pixels.value(kRadius, kRadius, i); };
    return QColor::fromRgbF(channel(0), channel(1), channel(2));
}

void LoupeGlass::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 205));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawRoundedRect(rect(), 4, 4);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int y = 0; y < m_pixels.height; ++y)
        for (int x = 0; x < m_pixels.width; ++x)
            if (m_pixels.value(x, y, 3) > 0.f)
                painter.fillRect(kPadding + x * kSquare, kPadding + y * kSquare, kSquare, kSquare,
                    QColor::fromRgbF(m_pixels.value(x, y, 0), m_pixels.value(x, y, 1), m_pixels.value(x, y, 2)));
    painter.setBrush(Qt::NoBrush);
    const int middle = kPadding + kRadius * kSquare;
    painter.setPen(Qt::black);
    painter.drawRect(middle - 2, middle - 2, kSquare + 3, kSquare + 3);
    painter.setPen(Qt::white);
    painter.drawRect(middle - 1, middle - 1, kSquare + 1, kSquare + 1);
    painter.setPen(QColor(230, 230, 230));
    for (int i = 0; i < m_lines.size(); ++i) {
        const int from = kGlass + 2 * kPadding + i * fontMetrics().lineSpacing();
        const QStringList parts = m_lines[i].split('\t');
        const QRect room(kPadding, from, kGlass, fontMetrics().lineSpacing());
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, parts.front());
        painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, parts.size() > 1 ? parts.back() : QString());
    }
}

Loupe::Loupe(Document& document, Assets& assets, Viewport& viewport)
    : QObject(&viewport)
    , m_document(document)
    , m_assets(assets)
    , m_viewport(viewport)
{
    viewport.installEventFilter(this);
    viewport.setMouseTracking(true);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestDelay);
    connect(&m_rest, &QTimer::timeout, this, &Loupe::search);
    connect(
        &viewport, &Viewport::painted, this,
        [this](bool full) {
            if (!m_isOn)
                return;
            look();
            if (full && m_foundAt && m_at && *m_foundAt != pointAt(m_viewport, *m_at))
                m_rest.start();
        },
        Qt::QueuedConnection); // not while it paints
    connect(&document, &Document::changed, this, [this] {
        m_found.reset(), m_foundAt.reset();
        if (m_isOn && m_at)
            m_rest.start();
    });
}

void Loupe::setOn(bool on)
{
    m_isOn = on;
    const QPoint at = m_viewport.mapFromGlobal(QCursor::pos());
    m_at = on && m_viewport.rect().contains(at) ? std::optional<QPointF>(at) : std::nullopt;
    on ? m_rest.start() : m_background.cancel();
    look();
}

bool Loupe::eventFilter(QObject* viewport, QEvent* event)
{
    if (!m_isOn)
        return false;
    if (event->type() == QEvent::MouseMove)
        m_at = static_cast<QMouseEvent*>(event)->position();
    else if (event->type() == QEvent::Leave)
        m_at.reset();
    else
        return QObject::eventFilter(viewport, event);
    m_rest.start();
    look();
    return false;
}

LoupeGlass& Loupe::glass(std::size_t pane)
{
    while (m_glasses.size() <= pane)
        m_glasses.push_back(new LoupeGlass(&m_viewport));
    return *m_glasses[pane];
}

void Loupe::look()
{
    const std::vector<PaneArea> areas = m_viewport.places().areas();
    for (std::size_t pane = 0; pane < std::max(areas.size(), m_glasses.size()); ++pane) {
        const bool shown = m_isOn && m_at && m_assets.ready() && pane < areas.size() && !areas[pane].isEmpty();
        if (!shown && pane < m_glasses.size())
            m_glasses[pane]->hide();
        if (!shown)
            continue;
        const PickedPoint point = pointAt(m_viewport, *m_at);
        LoupeGlass& one = glass(pane);
        const Image pixels = m_viewport.pixelsAround(pane, point.at, kRadius);
        one.show(pixels, {}), one.show(pixels, linesOf(pane, one));
        place(pane, one);
    }
}

// Beside the point, on the side where there is room; of two pictures in one place, one on each side.
void Loupe::place(std::size_t pane, LoupeGlass& one)
{
    const PickedPoint point = pointAt(m_viewport, *m_at);
    const PaneArea area = m_viewport.places().areas()[pane];
    const QPointF at = m_viewport.places().fromPicture(pane, point.at);
    const double ratio = m_viewport.devicePixelRatioF();
    const double left = area.x / ratio, right = (area.x + area.width) / ratio, bottom = (area.y + area.height) / ratio;
    const bool isLeft = (m_viewport.places().inPlace().isOn() && pane == m_viewport.places().inPlace().pair().first)
        || at.x() + kAway + one.width() > right;
    const double x = isLeft && at.x() - kAway - one.width() >= left ? at.x() - kAway - one.width() : at.x() + kAway;
    const double y = at.y() + kAway + one.height() > bottom ? at.y() - kAway - one.height() : at.y() + kAway;
    one.move(int(std::clamp(x, left, std::max(left, right - one.width()))), int(std::max(y, area.y / ratio)));
}

QStringList Loupe::linesOf(std::size_t pane, const LoupeGlass& one) const
{
    QStringList lines{one.color().name().toUpper() + '\t'};
    const PaneInspection* found = nullptr;
    if (m_found && m_foundAt && m_at && *m_foundAt == pointAt(m_viewport, *m_at))
        for (const PaneInspection& each : m_found->panes)
            found = each.pane == pane ? &each : found;
    if (!found || !found->view)
        return lines;
    const SearchHit& hit = found->view->hit;
    lines.append(tr("depth") + '\t' + QString::number(hit.t, 'f', 4));
    lines.append(tr("uv") + '\t' + QString("%1 %2").arg(hit.uv.x, 0, 'f', 4).arg(hit.uv.y, 0, 'f', 4));
    lines.append(tr("fetches") + '\t' + QString::number(hit.fetches));
    lines.append(tr("error") + '\t' + QString::number(hit.t - found->view->exact, 'f', 4));
    return lines;
}

void Loupe::search()
{
    if (!m_isOn || !m_at || !m_assets.ready())
        return;
    const PickedPoint point = pointAt(m_viewport, *m_at);
    if (m_foundAt == point && m_found)
        return;
    m_background.start(
        [this, point, state = m_document.state(), resources = m_assets.resources()](const Progress& progress) -> Background::Then {
            auto found = std::make_shared<const Inspected>(inspect(state, resources, point, progress));
            return [this, point, found] {
                m_found = found, m_foundAt = point;
                look();
            };
        });
}

} // namespace relievo
