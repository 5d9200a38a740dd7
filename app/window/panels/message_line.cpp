// Counting, opening and withdrawing messages; progress and its cancel button.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/message_line.h"
#include "app/window/widgets/elided_label.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/theme.h"
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace relievo {
namespace {
constexpr int kListLines = 8; // of messages that are seen at once
constexpr int kListSlack = 12; // px, for the scroll bar
constexpr int kShowWorkAfter = 150; // ms: short work shows no bar
const char* const kMouseHelp = "Left drag orbits   \u00b7   Middle drag moves   \u00b7   Wheel zooms   \u00b7   Right drag with W A S D "
                               "flies   \u00b7   Shift + right drag turns the light";

QString counted(const QList<Message>& all)
{
    const auto errors = std::ranges::count_if(all, &Message::isError), notes = std::ranges::count_if(all, &Message::isNote);
    const auto warnings = all.size() - errors - notes;
    QStringList parts;
    if (errors)
        parts << (errors == 1 ? QObject::tr("1 error") : QObject::tr("%1 errors").arg(errors));
    if (warnings)
        parts << (warnings == 1 ? QObject::tr("1 warning") : QObject::tr("%1 warnings").arg(warnings));
    if (notes)
        parts << (notes == 1 ? QObject::tr("1 note") : QObject::tr("%1 notes").arg(notes));
    return parts.join(", ");
}
const char* iconOf(const Message& message)
{
    return message.isError ? "error" : message.isNote ? "info" : "warning";
}
} // namespace

MessageLine::MessageLine(Messages& messages, Background& background, QWidget* parent)
    : QWidget(parent)
    , m_messages(messages)
    , m_list(new QScrollArea(this))
    , m_entries(new QWidget)
    , m_work(new QWidget(this))
    , m_choices(new QWidget(this))
    , m_doing(new QLabel)
    , m_lines(new QVBoxLayout(m_entries))
    , m_count(new QToolButton(this))
    , m_text(new ElidedLabel(this))
    , m_progress(new QProgressBar(this))
{
    m_list->setObjectName("message-list");
    m_list->setWidget(m_entries);
    m_list->setWidgetResizable(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_lines->setContentsMargins(12, 8, 12, 8);
    m_lines->setSpacing(2 * kGrid);
    m_count->setObjectName("message-count");
    m_count->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_count->setIconSize({16, 16});
    m_count->setToolTip(tr("Shows or hides all messages"));
    m_text->setObjectName("message-text");
    m_work->hide();
    m_choices->setObjectName("choices");
    (new QHBoxLayout(m_choices))->setContentsMargins(0, 0, 0, 0);
    m_choices->hide();

    auto* line = new QHBoxLayout;
    line->setContentsMargins(8, 2, 8, 2);
    line->setSpacing(2 * kGrid);
    line->addWidget(m_count);
    line->addWidget(m_text, 1);
    line->addWidget(m_choices);
    line->addWidget(m_work);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(hairline());
    layout->addWidget(m_list);
    auto* holder = new QWidget;
    holder->setLayout(line);
    holder->setFixedHeight(32);
    layout->addWidget(holder);

    connect(&messages, &Messages::changed, this, &MessageLine::refresh);
    connect(m_count, &QToolButton::clicked, this, [this] { setOpen(!m_open); });
    fillWork(background);
    refresh();
}

// What is being done, how far it has come, and its cancel button; seen while something is being done.
void MessageLine::fillWork(Background& background)
{
    m_doing->setObjectName("doing");
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(160);
    auto* cancel = new QToolButton;
    cancel->setObjectName("cancel");
    cancel->setIcon(icon("clear"));
    cancel->setIconSize({12, 12});
    cancel->setToolTip(tr("Stop"));
    auto* workLine = new QHBoxLayout(m_work);
    workLine->setContentsMargins(0, 0, 0, 0);
    workLine->addWidget(m_doing);
    workLine->addWidget(m_progress);
    workLine->addWidget(cancel);

    connect(cancel, &QToolButton::clicked, &background, &Background::cancel);
    connect(&background, &Background::progressed, this, [this, &background](float share) {
        m_doing->setText(background.what());
        m_progress->setValue(int(share * 1000));
    });
    connect(&background, &Background::busyChanged, this, [this, &background](bool busy) {
        m_progress->setValue(0);
        m_doing->setText(background.what());
        if (!busy)
            return m_work->hide();
        QTimer::singleShot(kShowWorkAfter, this, [this, &background] { m_work->setVisible(background.busy()); });
    });
}

void MessageLine::setOpen(bool open)
{
    m_open = open;
    refresh();
}

QString MessageLine::text() const
{
    return m_text->fullText();
}

void MessageLine::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}

void MessageLine::refresh()
{
    QList<Message> all = m_messages.all();
    const auto asks = std::ranges::find_if(all, [](const Message& one) { return !one.choices.isEmpty(); });
    showChoices(asks == all.end() ? QList<Offer>() : asks->choices);
    const auto notices = std::ranges::find(all, true, &Message::isNotice);
    const QString notice = notices == all.end() ? QString() : notices->text;
    all.erase(notices, all.end());
    m_open = m_open && !all.isEmpty();
    fillList(m_open ? all : QList<Message>{});
    m_list->setVisible(m_open);
    fitList();
    m_count->setVisible(!all.isEmpty());
    m_count->setText(' ' + counted(all));
    m_count->setIcon(icon(all.isEmpty() ? "warning" : iconOf(all.front())));
    const QString told = all.isEmpty() ? QString::fromUtf8(kMouseHelp) : m_open ? QString() : all.front().text;
    const QString said = notice.isEmpty() ? told : notice; // it goes by itself
    setRole(*m_text, !notice.isEmpty() ? "" : all.isEmpty() ? "dim" : all.front().isError ? "error" : "");
    m_text->setFullText(said);
}

// Of the message that asks. Buttons stay under the mouse while their words are the same.
void MessageLine::showChoices(const QList<Offer>& choices)
{
    const bool isSame = choices == m_asked;
    m_asked = choices; // what they do may be other things now
    if (isSame)
        return;
    for (QPushButton* button : m_choices->findChildren<QPushButton*>(Qt::FindDirectChildrenOnly)) {
        button->setParent(nullptr);
        button->deleteLater(); // it may be the one that was clicked
    }
    for (qsizetype i = 0; i < choices.size(); ++i) {
        auto* button = new QPushButton(choices[i].label);
        connect(button, &QPushButton::clicked, this, [this, i] {
            const Offer taken = m_asked.value(i);
            if (taken.take)
                taken.take();
        });
        m_choices->layout()->addWidget(button);
    }
    m_choices->setVisible(!choices.isEmpty());
}

void MessageLine::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitList();
}

// As high as its messages, up to kListLines lines; more are scrolled to.
void MessageLine::fitList()
{
    const int lines = kListLines * (fontMetrics().height() + m_lines->spacing());
    m_list->setFixedHeight(std::clamp(m_lines->totalHeightForWidth(std::max(width() - kListSlack, 1)), 0, lines));
}

void MessageLine::fillList(const QList<Message>& all)
{
    while (QLayoutItem* item = m_lines->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    for (const Message& one : all) {
        auto* entry = new QWidget;
        auto* row = new QHBoxLayout(entry);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(2 * kGrid);
        auto* picture = new QLabel;
        picture->setPixmap(icon(iconOf(one)).pixmap(QSize(16, 16), devicePixelRatioF()));
        auto* text = new QLabel(one.text);
        text->setTextFormat(Qt::PlainText);
        text->setWordWrap(true);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        setRole(*text, one.isError ? "error" : "");
        row->addWidget(picture, 0, Qt::AlignTop);
        row->addWidget(text, 1);
        m_lines->addWidget(entry);
    }
}

} // namespace relievo
