// Painting and handling of the small controls.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/controls.h"
#include "app/window/widgets/theme.h"
#include <QHelpEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSettings>
#include <QStyle>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace relievo {
namespace {
constexpr int kSegmentPadding = 10; // px, left and right of a text

struct SmoothPainter : QPainter {
    explicit SmoothPainter(QWidget* widget) : QPainter(widget) { setRenderHint(Antialiasing); }
};

void focusFrame(QPainter& painter, const QWidget& widget, const QRectF& rect, qreal radius)
{
    if (!widget.hasFocus())
        return;
    painter.setPen(accent(widget.palette()));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(rect, radius, radius);
}
} // namespace

Segmented::Segmented(const QVector<Item>& items, QWidget* parent) : QWidget(parent), m_items(items)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Segmented::setCurrent(int index)
{
    m_current = index;
    update();
}

int Segmented::width(int index) const
{
    const Item& item = m_items[index];
    return item.icon.isNull() ? fontMetrics().horizontalAdvance(item.text) + 2 * kSegmentPadding : 32;
}

QSize Segmented::sizeHint() const
{
    int total = 0;
    for (int i = 0; i < count(); ++i)
        total += width(i);
    return {total, kRowHeight};
}

QRect Segmented::segment(int index) const
{
    int x = 0;
    for (int i = 0; i < index; ++i)
        x += width(i);
    return {x, 0, width(index), height()};
}

int Segmented::at(QPoint point) const
{
    for (int i = 0; i < count(); ++i)
        if (segment(i).contains(point))
            return i;
    return -1;
}

void Segmented::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(lineColor(palette()));
    painter.setBrush(field(palette()));
    painter.drawRoundedRect(frame, 4, 4);
    for (int i = 0; i < count(); ++i) {
        const QRect part = segment(i);
        const bool on = i == m_current;
        if (on || i == m_hovered) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(on ? accent(palette()) : raised(palette()));
            painter.drawRoundedRect(part.adjusted(2, 2, -2, -2), 3, 3);
        }
        if (!m_items[i].icon.isNull()) {
            QPixmap pixels = m_items[i].icon.pixmap(QSize(16, 16), devicePixelRatio());
            if (on) {
                QPainter tint(&pixels);
                tint.setCompositionMode(QPainter::CompositionMode_SourceIn);
                tint.fillRect(pixels.rect(), onAccent(palette()));
            }
            painter.drawPixmap(QRect(part.center() - QPoint(7, 7), QSize(16, 16)), pixels);
            continue;
        }
        painter.setPen(on ? onAccent(palette()) : isEnabled() ? palette().color(QPalette::WindowText) : dimText(palette()));
        painter.drawText(part, Qt::AlignCenter, m_items[i].text);
    }
    focusFrame(painter, *this, frame, 4);
}

void Segmented::mousePressEvent(QMouseEvent* event)
{
    const int index = at(event->position().toPoint());
    if (event->button() != Qt::LeftButton || index < 0)
        return;
    setCurrent(index);
    Q_EMIT chosen(index);
}

void Segmented::mouseMoveEvent(QMouseEvent* event)
{
    m_hovered = at(event->position().toPoint());
    update();
}

void Segmented::leaveEvent(QEvent*)
{
    m_hovered = -1;
    update();
}

void Segmented::keyPressEvent(QKeyEvent* event)
{
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (step == 0)
        return QWidget::keyPressEvent(event);
    const int next = std::clamp(m_current + step, 0, count() - 1);
    if (next != m_current) {
        setCurrent(next);
        Q_EMIT chosen(next);
    }
}

bool Segmented::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int index = at(help->pos());
        if (index >= 0)
            QToolTip::showText(help->globalPos(), m_items[index].tip, this, segment(index));
        return true;
    }
    return QWidget::event(event);
}

void ChoiceList::wheelEvent(QWheelEvent* event)
{
    event->ignore(); // passed on to the parent
}

Switch::Switch(QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Switch::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    const QRectF track(1, height() / 2. - 7, 28, 14);
    painter.setPen(isChecked() ? accent(palette()) : lineColor(palette()));
    painter.setBrush(isChecked() ? accent(palette()) : field(palette()));
    painter.drawRoundedRect(track.adjusted(0.5, 0.5, -0.5, -0.5), 7, 7);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isChecked() ? onAccent(palette()) : underMouse() ? palette().color(QPalette::WindowText) : dimText(palette()));
    painter.drawEllipse(QPointF(isChecked() ? track.right() - 7 : track.left() + 7, track.center().y()), 4, 4);
    focusFrame(painter, *this, track.adjusted(-0.5, -0.5, 0.5, 0.5), 7.5);
}

Swatch::Swatch(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void Swatch::setColor(const QColor& color)
{
    m_color = color;
    update();
}

void Swatch::paintEvent(QPaintEvent*)
{
    SmoothPainter painter(this);
    painter.setPen(lineColor(palette()));
    painter.setBrush(m_color);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    focusFrame(painter, *this, QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4);
}

namespace {
// The clickable line at the top of a section.
class SectionHeader : public QAbstractButton {
public:
    SectionHeader(const QString& title, QWidget* parent) : QAbstractButton(parent)
    {
        setText(title);
        setCheckable(true);
        setFocusPolicy(Qt::TabFocus);
        setFixedHeight(28);
        setCursor(Qt::PointingHandCursor);
    }

protected:
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }
    void paintEvent(QPaintEvent*) override
    {
        SmoothPainter painter(this);
        relievo::icon(isChecked() ? "down" : "right").paint(&painter, QRect(6, (height() - 12) / 2, 12, 12));
        QFont bold = font();
        bold.setWeight(QFont::DemiBold);
        painter.setFont(bold);
        painter.setPen(underMouse() || hasFocus() ? accent(palette()) : palette().color(QPalette::WindowText));
        painter.drawText(rect().adjusted(24, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
    }
};
} // namespace

Section::Section(const QString& title, QWidget* parent)
    : QWidget(parent)
    , m_title(title)
    , m_header(new SectionHeader(title, this))
    , m_content(new QWidget(this))
    , m_body(new QVBoxLayout(m_content))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_header);
    layout->addWidget(m_content);
    layout->addWidget(hairline());
    m_body->setContentsMargins(12, 0, 8, 8);
    m_body->setSpacing(kGrid);
    connect(m_header, &QAbstractButton::toggled, this, [this](bool open) {
        setOpen(open);
        QSettings().setValue("sections/" + m_title, open);
    });
    setOpen(QSettings().value("sections/" + m_title, true).toBool());
}

QWidget* Section::header() const
{
    return m_header;
}

void Section::setOpen(bool open)
{
    m_open = open;
    const QSignalBlocker quiet(m_header);
    m_header->setChecked(open);
    m_content->setVisible(open);
}

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setFullText(const QString& text)
{
    if (toolTip() == m_full)
        setToolTip({});
    m_full = text;
    elide();
}

// A tooltip of another text stays.
void ElidedLabel::elide()
{
    setText(fontMetrics().elidedText(m_full, Qt::ElideRight, width()));
    if (toolTip().isEmpty() || toolTip() == m_full)
        setToolTip(text() == m_full ? QString() : m_full);
}

void ElidedLabel::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    elide();
}

namespace {
QFrame* ruled(QWidget* parent, const char* role)
{
    auto* frame = new QFrame(parent);
    frame->setProperty("role", role);
    return frame;
}
} // namespace

QFrame* hairline(QWidget* parent)
{
    return ruled(parent, "line");
}

QFrame* upright(QWidget* parent)
{
    return ruled(parent, "upright");
}

} // namespace relievo
