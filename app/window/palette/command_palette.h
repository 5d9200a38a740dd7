// The command palette: a line to type into, and what fits.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/palette/commands.h"
#include <QFrame>

class QLineEdit;
class QListWidget;

namespace relievo {

// Over the top of the window; goes when something is chosen, on Esc, and when another window is looked at. Owned by the window.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    explicit CommandPalette(MainWindow& window);
    void present(); // with the last query, to be typed over

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; // arrows in the line move in the list

private:
    void refill();
    void choose();

    MainWindow& m_window;
    QLineEdit* m_line;
    QListWidget* m_list;
    std::vector<Command> m_commands; // as listed
};

void showPalette(MainWindow& window); // made the first time

} // namespace relievo
