// What is wrong with a dropped file, told for some seconds where it was dropped.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/messages.h"
#include <QLabel>
#include <QTimer>

namespace relievo {

// Beside the message line, which the eye is far from then. It looks at all drops into its window, and shows the first error that comes
// up after one, until the next drop.
class DropNote : public QLabel {
    Q_OBJECT
public:
    DropNote(Messages& messages, QWidget* window);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void messagesChanged();
    Messages& m_messages;
    QTimer m_end;
    QPoint m_at; // of the drop, in the window
    QList<Message> m_before; // what was known then
    bool m_waits = false; // for the drop's outcome
};

} // namespace relievo
