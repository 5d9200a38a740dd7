// One map slot: a tall line when it is filled, a short one when it is not.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/map_row.h"
#include "app/window/document/stand_ins.h"
#include "app/window/panels/thumbnails.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/dropping.h"
#include "app/window/widgets/elided_label.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/state/sample_names.h"
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

namespace relievo {
namespace {
constexpr int kThumbnail = 40, kFilledHeight = 48, kEmptyHeight = 28; // px

QToolButton* toolButton(const char* picture, const QString& tip, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setIcon(icon(picture));
    button->setIconSize({16, 16});
    button->setFixedSize(24, 24);
    button->setToolTip(tip);
    return button;
}

QString shownName(const MapSlot& slot)
{
    const QString file = QString::fromStdString(slot.file);
    return file.startsWith("sample:") ? QObject::tr("built-in") : QFileInfo(file).fileName();
}

// Its file is there, but loading told that it could not be read.
bool isBroken(const Material& material, const MapSlot& slot)
{
    return std::ranges::any_of(
        material.warnings, [&](const Warning& told) { return told.code == "map-broken" && isAbout(told, slot.file); });
}

QString channelLabel(Channel channel, int channels)
{
    if (channel == Channel::Rgb)
        return channels == 1 ? QObject::tr("mean") : "RGB";
    return qt(wordOf(channel)).toUpper();
}
} // namespace

MapRow::MapRow(const MapKindRow& kind, QWidget* parent)
    : QWidget(parent)
    , m_kind(kind)
    , m_name(new QLabel(qt(kind.label), this))
    , m_facts(new ElidedLabel(this))
    , m_locate(toolButton("locate", tr("The file is not there: say where it is now"), this))
    , m_invert(kind.kind == MapKind::Normal ? toolButton("flip", tr("Green flip: the map is DirectX style"), this)
                                            : toolButton("invert", tr("Invert: black for white"), this))
    , m_clear(toolButton("clear", tr("Clear this map"), this))
    , m_channel(new ChoiceList(this))
{
    setObjectName("map-" + qt(kind.key));
    setAcceptDrops(true);
    setFocusPolicy(Qt::TabFocus);
    setAccessibleName(tr("%1 map").arg(qt(kind.label)));
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    setToolTip(QString("<p><b>%1</b><br>%2<br>Click to choose a file, or drop one here.</p>").arg(qt(kind.label), qt(kind.help)));
    m_invert->setCheckable(true);
    m_invert->setObjectName("invert");
    m_clear->setObjectName("clear");
    m_facts->setFont(smallFont());
    m_facts->setProperty("role", "dim");
    m_channel->setFont(smallFont());
    m_channel->setFixedWidth(kind.channels == 1 ? 68 : 56);
    m_channel->setToolTip(tr("Channel of the file that is read"));
    for (std::size_t i = 0; i < kChoices<Channel>; ++i)
        m_channel->addItem(channelLabel(Channel(i), kind.channels));

    auto* texts = new QVBoxLayout;
    texts->setSpacing(0);
    texts->addStretch(1);
    texts->addWidget(m_name);
    texts->addWidget(m_facts);
    texts->addStretch(1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12 + kThumbnail + 8, 0, 4, 0);
    layout->setSpacing(0);
    layout->addLayout(texts, 1);
    for (QWidget* widget : {static_cast<QWidget*>(m_locate), static_cast<QWidget*>(m_channel), static_cast<QWidget*>(m_invert),
             static_cast<QWidget*>(m_clear)}) {
        widget->setCursor(Qt::ArrowCursor);
        layout->addWidget(widget);
    }
    connect(m_clear, &QToolButton::clicked, this, &MapRow::cleared);
    connect(m_locate, &QToolButton::clicked, this, &MapRow::locateWanted);
    connect(m_invert, &QToolButton::clicked, this, &MapRow::inverted);
    connect(m_channel, &QComboBox::activated, this, [this](int index) { Q_EMIT channelChosen(Channel(index)); });
    show({}, nullptr);
}

void MapRow::show(const MapSlot& slot, const Material* material)
{
    const QString facts = material ? mapFacts(*material, m_kind.kind) : QString();
    m_filled = !slot.empty();
    // While other maps are loading the material is not yet that of the slot.
    const bool isLoaded = m_filled && material && material->slots[std::size_t(m_kind.kind)] == slot;
    m_missing = isLoaded && (facts.isEmpty() || isTroubled(*material, slot)); // what was read before may be shown all the same
    m_thumbnail = QPixmap();
    if (!facts.isEmpty() && m_filled)
        m_thumbnail = QPixmap::fromImage(thumbnail(*material, m_kind.kind, int(kThumbnail * devicePixelRatio())));
    m_thumbnail.setDevicePixelRatio(devicePixelRatio());
    setFixedHeight(m_filled ? kFilledHeight : kEmptyHeight);
    const bool isThere = m_missing && material && isBroken(*material, slot);
    m_facts->setFullText(m_missing ? (isThere ? tr("cannot be read: %1") : tr("missing: %1")).arg(shownName(slot)) : facts);
    m_facts->setVisible(m_filled);
    m_facts->setToolTip(m_filled ? QString::fromStdString(slot.file) : QString());
    setRole(*m_name, m_filled ? "" : "dim");
    setRole(*m_facts, m_missing ? "warning" : "dim");
    const bool scalar = m_kind.channels == 1;
    m_channel->setVisible(m_filled && !m_missing && scalar && !namesSample(slot.file));
    m_channel->setCurrentIndex(int(slot.channel));
    m_invert->setVisible(m_filled && !m_missing && (scalar || m_kind.kind == MapKind::Normal));
    m_invert->setChecked(slot.invert);
    m_clear->setVisible(m_filled);
    m_locate->setVisible(m_missing);
    update();
}

void MapRow::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || m_dropHere)
        painter.fillRect(rect(), raised(palette()));
    const int size = m_filled ? kThumbnail : 16;
    const QRect frame(12 + (kThumbnail - size) / 2, (height() - size) / 2, size, size);
    if (!m_thumbnail.isNull()) {
        const QSize shown = m_thumbnail.size() / m_thumbnail.devicePixelRatio();
        const QRect at(frame.center() - QPoint(shown.width() / 2 - 1, shown.height() / 2 - 1), shown);
        painter.drawPixmap(at, m_thumbnail);
        painter.setPen(lineColor(palette())); // a white map ends somewhere in bright surroundings too
        painter.drawRect(QRectF(at).adjusted(0.5, 0.5, -0.5, -0.5));
    } else {
        painter.setPen(QPen(m_missing ? warningColor(palette()) : dimText(palette()), 1, Qt::DashLine));
        painter.drawRoundedRect(QRectF(frame).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    }
    if (m_dropHere || hasFocus()) {
        painter.setPen(QPen(accent(palette()), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void MapRow::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
        m_missing ? Q_EMIT locateWanted() : Q_EMIT assignWanted();
}

void MapRow::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space)
        m_missing ? Q_EMIT locateWanted() : Q_EMIT assignWanted();
    else if (key == Qt::Key_Delete && m_filled)
        Q_EMIT cleared();
    else
        QWidget::keyPressEvent(event);
}

void MapRow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->urls().size() != 1 || draggedFile(*event).isEmpty())
        return;
    m_dropHere = true;
    update();
    acceptCopy(*event);
}

void MapRow::dragLeaveEvent(QDragLeaveEvent*)
{
    m_dropHere = false;
    update();
}

void MapRow::dropEvent(QDropEvent* event)
{
    m_dropHere = false;
    update();
    acceptCopy(*event);
    Q_EMIT dropped(draggedFile(*event));
}

} // namespace relievo
