// Menus and tool buttons made from the action table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/actions.h"
#include <QMap>
#include <QString>
#include <functional>

class QAction;
class QMenu;
class QMenuBar;
class QToolButton;
class QWidget;

namespace relievo {

// One handler for each row of kActions; `on` is the new state of a row that toggles.
using Handlers = QMap<QString, std::function<void(bool on)>>;
using Actions = QMap<QString, QAction*>;

// The actions of all rows, owned by `window`, in its menus. A row without handler is our mistake (asserted).
Actions makeActions(QWidget* window, QMenuBar* bar, const Handlers& handlers);
QMenu* menuOf(QMenuBar* bar, std::string_view title); // nullptr when there is none

QToolButton* toolButton(QAction* action);

// A submenu that is filled each time it opens.
QMenu* lazyMenu(QMenu* before, QAction* beforeAction, const QString& title, std::function<void(QMenu&)> fill);

// The window of Help > Mouse and keys, from the tables of actions and gestures; deletes itself when closed.
void showShortcuts(QWidget* parent);
void showAbout(QWidget* parent);

} // namespace relievo
