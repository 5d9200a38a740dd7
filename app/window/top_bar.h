// What stands above the picture: the menus and the tool buttons.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/menus.h"
#include "core/state/views.h"
#include <QWidget>

class QHBoxLayout;
class QUndoStack;

namespace relievo {

class Files;
struct TechniqueRow;

class TopBar : public QWidget {
    Q_OBJECT
public:
    // window: its keys work everywhere in it.
    TopBar(Files& files, QWidget* window);
    QAction* action(Action which) const { return m_actions[which]; }
    // Of the keys, and how many panes, in the menus.
    void tick(const std::string& technique, const std::string& view, std::size_t panes, float fieldOfView);
    void follow(const QUndoStack& undo); // the actions for undo and redo name the step and are on when there is one

Q_SIGNALS:
    void triggered(relievo::Action action, bool on);
    void techniqueChosen(const relievo::TechniqueRow& row);
    void viewChosen(const relievo::ViewRow& row);
    void paneCountChosen(std::size_t count);
    void fieldOfViewChosen(float degrees);

private:
    QHBoxLayout* fileButtons();
    void addTableMenus();
    void addKeys(QWidget* window);
    Files& m_files;
    QMenuBar* m_menus;
    Actions m_actions;
    std::string m_technique, m_view; // keys of those that are ticked
    std::size_t m_panes = 1;
    float m_fieldOfView = 0.f;
};

} // namespace relievo
