// What stands above the picture: the menus, the tool buttons, the technique and the view.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/menus.h"
#include "core/state/views.h"
#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QUndoStack;

namespace relievo {

class Files;
class TechniqueBar;
struct TechniqueRow;

class TopBar : public QWidget {
    Q_OBJECT
public:
    // window: its keys work everywhere in it.
    TopBar(Files& files, QWidget* window);
    QAction* action(Action which) const { return m_actions[which]; }
    TechniqueBar& techniques() { return *m_techniques; }
    void showTechnique(const std::string& key);
    void showView(const std::string& key);
    void follow(const QUndoStack& undo); // the actions for undo and redo name the step and are on when there is one

Q_SIGNALS:
    void triggered(relievo::Action action, bool on);
    void techniqueChosen(const relievo::TechniqueRow& row);
    void viewChosen(const relievo::ViewRow& row);

private:
    QHBoxLayout* fileButtons();
    void addTableMenus();
    void addKeys(QWidget* window);
    Files& m_files;
    QMenuBar* m_menus;
    Actions m_actions;
    TechniqueBar* m_techniques;
    QComboBox* m_view;
};

} // namespace relievo
