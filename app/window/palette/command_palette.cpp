// The command palette.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/command_palette.h"
#include "app/window/main_window.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/theme.h"
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr QSize kSize(520, 380); // px
constexpr int kTop = 48; // px under the window's upper edge

QWidget* lineOf(const Command& command)
{
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(2 * kGrid, 0, 2 * kGrid, 0);
    auto* title = new QLabel(command.title);
    auto* detail = new QLabel(command.detail);
    setRole(*detail, "dim");
    if (!command.run && command.completion.isEmpty())
        setRole(*title, "dim");
    layout->addWidget(title, 1);
    layout->addWidget(detail);
    return line;
}
} // namespace

CommandPalette::CommandPalette(MainWindow& window)
    : QFrame(&window, Qt::Popup)
    , m_window(window)
    , m_line(new QLineEdit)
    , m_list(new QListWidget)
{
    setObjectName("palette");
    setFrameShape(QFrame::StyledPanel);
    m_line->setObjectName("query");
    m_line->setPlaceholderText(tr("Search commands, techniques, views, values: depth 0.1"));
    m_line->setAccessibleName(tr("Command"));
    m_list->setObjectName("commands");
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setUniformItemSizes(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_line->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    layout->addWidget(m_line);
    layout->addWidget(m_list, 1);
    connect(m_line, &QLineEdit::textChanged, this, &CommandPalette::refill);
    connect(m_line, &QLineEdit::returnPressed, this, &CommandPalette::choose);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::choose);
}

void CommandPalette::present()
{
    const QSize size = kSize.boundedTo(m_window.size() - QSize(16, kTop + 16));
    resize(size);
    move(m_window.mapToGlobal(QPoint((m_window.width() - size.width()) / 2, kTop)));
    refill();
    show();
    m_line->setFocus();
    m_line->selectAll();
}

void CommandPalette::refill()
{
    m_commands = commandsFor(m_line->text(), m_window);
    m_list->clear();
    for (const Command& command : m_commands) {
        auto* item = new QListWidgetItem(m_list);
        item->setData(Qt::AccessibleTextRole, command.title);
        item->setSizeHint(QSize(0, kRowHeight));
        m_list->setItemWidget(item, lineOf(command));
    }
    m_list->setCurrentRow(m_commands.empty() ? -1 : 0);
}

void CommandPalette::choose()
{
    const int row = m_list->currentRow();
    if (row < 0 || row >= int(m_commands.size()))
        return;
    const Command command = m_commands[std::size_t(row)];
    if (!command.completion.isEmpty() && !command.run)
        return m_line->setText(command.completion);
    if (!command.run)
        return;
    hide();
    command.run();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_line || event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    const int count = m_list->count(), key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : key == Qt::Key_PageDown ? 10 : key == Qt::Key_PageUp ? -10 : 0;
    if (step == 0 || count == 0)
        return QFrame::eventFilter(watched, event);
    m_list->setCurrentRow(std::clamp(m_list->currentRow() + step, 0, count - 1));
    return true;
}

void showPalette(MainWindow& window)
{
    commitTyping(&window);
    auto* palette = window.findChild<CommandPalette*>();
    (palette ? palette : new CommandPalette(window))->present();
}

} // namespace relievo
