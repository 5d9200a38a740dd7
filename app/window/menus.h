// Menus and tool buttons made from the action table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/actions.h"
#include <QString>
#include <array>
#include <functional>

class QAction;
class QMenu;
class QMenuBar;
class QToolButton;
class QWidget;

namespace relievo {

// The actions of all rows.
struct Actions {
    std::array<QAction*, kActions.size()> all{};
    QAction* operator[](Action action) const { return all[std::size_t(action)]; }
};
// Owned by `window`, in the menus of `bar`. run: what a row does when it is triggered; `on` is the new state of a row that toggles.
Actions makeActions(QWidget* window, QMenuBar* bar, const std::function<void(Action, bool on)>& run);
QMenu* menuOf(QMenuBar* bar, std::string_view title); // nullptr when there is none

QToolButton* toolButton(QAction* action);

// A submenu that is filled each time it opens.
QMenu* lazyMenu(QMenu* before, QAction* beforeAction, const QString& title, std::function<void(QMenu&)> fill);

// The window of Help > Mouse and keys, from the tables of actions and gestures; deletes itself when closed.
void showShortcuts(QWidget* parent);
void showAbout(QWidget* parent);

} // namespace relievo
