// Waiting for what a drop comes to.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/drop_note.h"
#include "app/window/widgets/theme.h"
#include <QApplication>
#include <QDropEvent>
#include <algorithm>

namespace relievo {
namespace {
constexpr int kToldFor = 5000; // ms
constexpr int kWidth = 320, kAside = 12; // px
} // namespace

DropNote::DropNote(Messages& messages, QWidget* window) : QLabel(window), m_messages(messages)
{
    setObjectName("drop-note");
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setFixedWidth(kWidth);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setRole(*this, "drop-note");
    hide();
    m_end.setSingleShot(true);
    m_end.setInterval(kToldFor);
    connect(&m_end, &QTimer::timeout, this, &QWidget::hide);
    connect(&messages, &Messages::changed, this, &DropNote::messagesChanged);
    qApp->installEventFilter(this);
}

bool DropNote::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() != QEvent::Drop)
        return false;
    const auto* widget = qobject_cast<QWidget*>(object);
    m_waits = widget && widget->window() == window();
    if (m_waits) {
        m_at = widget->mapTo(window(), static_cast<QDropEvent*>(event)->position().toPoint());
        m_before = m_messages.all();
        hide();
    }
    return false;
}

void DropNote::messagesChanged()
{
    if (!m_waits)
        return;
    const QList<Message> all = m_messages.all();
    const auto news = std::ranges::find_if(all, [this](const Message& one) { return one.isError && !m_before.contains(one); });
    if (news == all.end()) {
        m_before = all; // what is withdrawn may come again
        return;
    }
    m_waits = false;
    setText(news->text);
    resize(kWidth, heightForWidth(kWidth));
    const QPoint most(window()->width() - width() - kAside, window()->height() - height() - kAside);
    move(std::max(std::min(m_at.x() + kAside, most.x()), 0), std::max(std::min(m_at.y() + kAside, most.y()), 0));
    show();
    raise();
    m_end.start();
}

} // namespace relievo
