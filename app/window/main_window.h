// The main window: the picture between its panels, menus above, messages below.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "app/window/document/editing.h"
#include "app/window/top_bar.h"
#include <QMainWindow>
#include <memory>

namespace relievo {

class AnimationBar;
class CompareBar;
class Docks;
class ExportDialog;
class Files;
class LightHandles;
class Loupe;
class MapPanel;
class MessageLine;
class Page;
class ParameterPanel;
class Turning;
class Viewport;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow();
    ~MainWindow() override;

    Document& document() { return m_document; }
    Assets& assets() { return m_assets; }
    Messages& messages() { return m_messages; }
    Files& files() { return *m_files; }
    Viewport& viewport() { return *m_viewport; }
    AnimationBar& animation() { return *m_animation; }
    MapPanel& maps() { return *m_maps; }
    ParameterPanel& parameters() { return *m_parameters; }
    MessageLine& messageLine() { return *m_line; }
    CompareBar& comparing() { return *m_compare; }
    Loupe& loupe() { return *m_loupe; }
    Docks& docks() { return *m_docks; }
    LightHandles& lights() { return *m_lights; }
    Turning& turning() { return *m_turning; }
    QAction* action(std::string_view key) const { return m_top->action(findAction(key)->action); } // of kActions

    void setTechnique(std::string_view key); // of the active pane
    void setView(std::string_view key);
    void showPanels(bool on);
    ExportDialog& exportDialog(); // made when it is wanted first

protected:
    void closeEvent(QCloseEvent*) override;
    void changeEvent(QEvent*) override;
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    void connectAll();
    void documentChanged();
    void updateTitle();

    Document m_document;
    Messages m_messages;
    Assets m_assets;
    Files* m_files;
    Viewport* m_viewport;
    CompareBar* m_compare;
    Loupe* m_loupe;
    AnimationBar* m_animation;
    std::unique_ptr<Docks> m_docks; // what they show is the page's
    MapPanel* m_maps;
    ParameterPanel* m_parameters;
    LightHandles* m_lights;
    Turning* m_turning;
    MessageLine* m_line;
    TopBar* m_top;
    Page* m_page;
    ExportDialog* m_export = nullptr;
    bool m_closing = false; // the question has been answered
};

} // namespace relievo
