// The line at the bottom: what the user should know, how far the work has come, and otherwise what the mouse does.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/background.h"
#include "app/window/document/messages.h"
#include <QWidget>

class QLabel;
class QProgressBar;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace relievo {

class ElidedLabel;

class MessageLine : public QWidget {
    Q_OBJECT
public:
    MessageLine(Messages& messages, Background& background, QWidget* parent = nullptr);
    bool isOpen() const { return m_open; }
    void setOpen(bool open); // the list of all messages above the line
    QString text() const; // what the line says now

protected:
    void changeEvent(QEvent* event) override; // another look: other icons
    void resizeEvent(QResizeEvent* event) override; // another width: other line breaks

private:
    void fillWork(Background& background);
    void refresh();
    void fillList(const QList<Message>& all);
    void fitList();
    void showChoices(const QList<Offer>& choices);
    Messages& m_messages;
    QList<Offer> m_asked;
    bool m_open = false;
    QScrollArea* m_list;
    QWidget *m_entries, *m_work, *m_choices;
    QLabel* m_doing;
    QVBoxLayout* m_lines;
    QToolButton* m_count;
    ElidedLabel* m_text;
    QProgressBar* m_progress;
};

} // namespace relievo
