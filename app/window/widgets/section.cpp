// Opening and closing, and the line that does it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/section.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/painting.h"
#include <QAbstractButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace relievo {
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

Section::Section(const QString& title, QWidget* parent, bool isOpenAtFirst)
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
    setOpen(QSettings().value("sections/" + m_title, isOpenAtFirst).toBool());
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
    Q_EMIT opened(open);
}

} // namespace relievo
