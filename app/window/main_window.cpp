// Putting the window together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"
#include "app/window/compare/compare_bar.h"
#include "app/window/compare/loupe.h"
#include "app/window/dialogs/export_dialog.h"
#include "app/window/docks.h"
#include "app/window/document/files.h"
#include "app/window/lights/light_handles.h"
#include "app/window/lights/turning.h"
#include "app/window/page.h"
#include "app/window/panels/animation_bar.h"
#include "app/window/panels/drop_frame.h"
#include "app/window/panels/drop_note.h"
#include "app/window/panels/map_panel.h"
#include "app/window/panels/message_line.h"
#include "app/window/panels/pane_menu.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/run_action.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/dropping.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QCloseEvent>

namespace relievo {

MainWindow::MainWindow()
    : m_assets(m_document, m_messages)
    , m_files(new Files(m_document, m_assets, m_messages, this))
    , m_viewport(new Viewport(m_document, m_assets, m_messages))
    , m_compare(new CompareBar(m_document, *m_viewport))
    , m_loupe(new Loupe(m_document, m_assets, *m_viewport))
    , m_animation(new AnimationBar(m_document, m_assets))
    , m_docks(std::make_unique<Docks>(m_document, m_assets, *m_viewport))
    , m_maps(new MapPanel(m_document, m_assets))
    , m_parameters(new ParameterPanel(m_document))
    , m_lights(new LightHandles(m_document, m_assets, *m_viewport,
          [this](std::size_t light) { return light > 0 && m_parameters->isOpen(Group(std::size_t(Group::Light) + light)); }))
    , m_turning(new Turning(m_document, *m_viewport))
    , m_line(new MessageLine(m_messages, m_assets.background()))
    , m_top(new TopBar(*m_files, this))
    , m_page(new Page({m_maps, m_viewport, m_docks->between(m_compare, m_animation), m_parameters, m_line}))
{
    setAcceptDrops(true);
    setCentralWidget(m_page);
    setMenuWidget(m_top);
    new DropNote(m_messages, this);
    new DropFrame(m_viewport, this);
    connectAll();
    m_page->restore(*this);
    showPanels(m_page->panelsShown());
    documentChanged();
    updateTitle();
}

MainWindow::~MainWindow()
{
    // The document and its undo stack tell of their own end; nobody is to listen any more.
    m_document.disconnect();
    m_document.undoStack().disconnect();
    delete m_lights; // the focus that the viewport loses is none of theirs any more
    delete m_page; // the panels look at the document, which goes first otherwise
}

void MainWindow::connectAll()
{
    connect(m_top, &TopBar::triggered, this, [this](Action action, bool on) { runAction(*this, action, on); });
    connect(m_docks.get(), &Docks::closed, this, [this](Action action) { m_top->action(action)->setChecked(false); });
    connect(m_top, &TopBar::techniqueChosen, this, [this](const TechniqueRow& row) { setTechnique(row.key); });
    connect(m_top, &TopBar::viewChosen, this, [this](const ViewRow& row) { setView(row.key); });
    connect(m_top, &TopBar::fieldOfViewChosen, this, [this](float degrees) { setFieldOfView(*this, degrees); });
    connect(m_top, &TopBar::paneCountChosen, m_compare, qOverload<std::size_t>(&CompareBar::showPanes));
    connect(m_viewport, &Viewport::activePaneChanged, this, &MainWindow::documentChanged);
    connect(m_viewport, &Viewport::ownValuesWanted, this, [this](std::size_t pane) { m_parameters->setScope(pane); });
    connect(&m_viewport->places().inPlace(), &InPlace::arranged, this, &MainWindow::documentChanged);
    connect(m_parameters, &ParameterPanel::scopeChanged, this, [this](Scope scope) {
        if (scope)
            m_viewport->setActivePane(int(*scope));
    });
    connect(m_parameters, &ParameterPanel::sectionsChanged, m_lights, &LightHandles::update);
    connect(&m_document, &Document::changed, this, &MainWindow::documentChanged);
    connect(&m_document, &Document::titleChanged, this, &MainWindow::updateTitle);
    m_top->follow(m_document.undoStack());
}

void MainWindow::documentChanged()
{
    const State& state = m_document.state();
    const Pane& active = state.panes[std::min(std::size_t(m_viewport->activePane()), state.panes.size() - 1)];
    m_top->tick(active.technique, active.view, state.panes.size(), cameraOf(state, std::size_t(m_viewport->activePane())).fov);
    m_top->action(Action::TwoPanes)->setChecked(state.panes.size() > 1);
    m_top->action(Action::Wireframe)->setChecked(state.parameters.wireframe);
    for (const Action action : {Action::Wipe, Action::Blink, Action::Difference, Action::Flip})
        m_top->action(action)->setChecked(m_compare->compares(inPlaceModeOf(action)));
}

void MainWindow::updateTitle()
{
    setWindowTitle(QString::fromUtf8("%1[*] \u2013 Relievo").arg(m_document.name()));
    setWindowModified(m_document.isModified());
}

void MainWindow::setTechnique(std::string_view key)
{
    chooseTechnique(m_document, std::size_t(m_viewport->activePane()), *findTechnique(key));
}

void MainWindow::setView(std::string_view key)
{
    m_document.edit(tr("View %1").arg(qt(findView(key)->label)), [&](State& state) { relievo::setView(state, key); });
}

void MainWindow::showPanels(bool on)
{
    m_top->action(Action::Panels)->setChecked(on);
    m_page->showPanels(on);
}

ExportDialog& MainWindow::exportDialog()
{
    commitTyping(this);
    if (!m_export)
        m_export = new ExportDialog(m_document, m_assets, this);
    return *m_export;
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    commitTyping(this);
    const bool exporting = m_export && m_export->busy();
    if (!m_closing && (m_files->unsaved() || exporting)) {
        event->ignore();
        const auto end = [this] {
            m_closing = true;
            close();
        };
        return m_files->guard(end, exporting ? tr("An export is still running. Quitting stops it.") : QString());
    }
    m_page->save(*this);
    event->accept();
}

void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::ActivationChange && isActiveWindow())
        m_assets.lookAgain();
    QMainWindow::changeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!draggedFile(*event).isEmpty())
        acceptCopy(*event);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    acceptCopy(*event);
    m_files->openDropped(draggedFile(*event)); // of several images the first finds its siblings
}

} // namespace relievo
