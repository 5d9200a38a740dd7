// Everything that the command palette offers, walked from the tables.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <functional>
#include <vector>

namespace relievo {

class MainWindow;

struct Command {
    QString title; // "View: Depth"
    QString detail; // keys, or what there is now
    QString words; // other words that find it
    std::function<void()> run; // none: it cannot be done now, or the query has to say more
    QString completion = {}; // what the query becomes instead, "depth "
    bool isMeant = false; // the query says what to do, not only what it is about
};

// Those that fit the query, best first: actions, techniques of the active pane, views, presets and scenes, samples, parameters. "depth 0.1"
// sets the parameter for all panes, as one step that can be undone. Every word of the query has to be in a command.
std::vector<Command> commandsFor(const QString& query, MainWindow& window);

} // namespace relievo
