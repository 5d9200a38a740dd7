// Putting the window together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"
#include "app/window/dialogs/export_dialog.h"
#include "app/window/document/files.h"
#include "app/window/panels/animation_bar.h"
#include "app/window/panels/map_panel.h"
#include "app/window/panels/message_line.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/panels/technique_bar.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/state/views.h"
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QSplitter>
#include <QToolButton>

namespace relievo {
namespace {
constexpr int kMapWidth = 264, kParameterWidth = 348; // px
}

MainWindow::MainWindow()
    : m_assets(m_document, m_messages)
    , m_files(new Files(m_document, m_assets, m_messages, this))
    , m_viewport(new Viewport(m_document, m_assets, m_messages))
    , m_animation(new AnimationBar(m_document, m_assets))
    , m_maps(new MapPanel(m_document, m_assets))
    , m_parameters(new ParameterPanel(m_document))
    , m_techniques(new TechniqueBar)
    , m_view(new ChoiceList)
    , m_line(new MessageLine(m_messages, m_assets.background()))
    , m_splitter(new QSplitter)
{
    setAcceptDrops(true);
    m_splitter->setHandleWidth(1);
    m_splitter->setChildrenCollapsible(false);
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_viewport, 1);
    column->addWidget(m_animation);
    for (QWidget* part : {static_cast<QWidget*>(m_maps), centre, static_cast<QWidget*>(m_parameters)})
        m_splitter->addWidget(part);
    m_maps->setMinimumWidth(284); // the row of shapes
    m_parameters->setMinimumWidth(324); // the longest name beside a short slider
    m_splitter->setStretchFactor(1, 1);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(hairline());
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_line);
    setCentralWidget(page);
    setMenuWidget(makeTopBar());
    addTableMenus();
    addKeys();
    connectAll();
    restoreLayout();
    documentChanged(Changes(Change::Panes) | Change::View);
    updateTitle();
}

MainWindow::~MainWindow()
{
    // The document and its undo stack tell of their own end; nobody is to listen any more.
    m_document.disconnect();
    m_document.undoStack().disconnect();
    delete m_splitter; // the panels look at the document, which goes first otherwise
}

QWidget* MainWindow::makeTopBar()
{
    auto* top = new QWidget;
    auto* bar = new QMenuBar;
    bar->setObjectName("menu");
    bar->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_actions = makeActions(this, bar, handlers());
    auto* samples = new QToolButton;
    samples->setIcon(icon("sample"));
    samples->setIconSize({16, 16});
    samples->setFixedSize(28, 28);
    samples->setPopupMode(QToolButton::InstantPopup);
    samples->setToolTip(tr("Built-in materials"));
    auto* sampleMenu = new QMenu(samples);
    sampleMenu->setToolTipsVisible(true);
    m_files->fillSamples(*sampleMenu);
    samples->setMenu(sampleMenu);

    const auto dim = [](const QString& text) {
        auto* label = new QLabel(text);
        label->setProperty("role", "dim");
        return label;
    };
    const auto ruler = [] {
        auto* rule = upright();
        rule->setFixedHeight(20);
        return rule;
    };
    for (const ViewRow& row : kViews) {
        m_view->addItem(qt(row.label), qt(row.key));
        m_view->setItemData(m_view->count() - 1, qt(row.help), Qt::ToolTipRole);
    }
    m_view->setObjectName("view");
    auto* line = new QHBoxLayout(top);
    line->setContentsMargins(8, 4, 8, 4);
    line->setSpacing(2 * kGrid);
    line->addWidget(bar);
    line->addWidget(ruler());
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    buttons->addWidget(samples);
    for (const char* key : {"open", "save", "undo", "redo", "export"})
        buttons->addWidget(toolButton(m_actions[key]));
    line->addLayout(buttons);
    line->addWidget(ruler());
    line->addWidget(dim(tr("Technique")));
    line->addWidget(m_techniques, 1);
    line->addWidget(dim(tr("View")));
    line->addWidget(m_view);
    for (const char* key : {"wireframe", "two-panes", "frame", "panels"})
        line->addWidget(toolButton(m_actions[key]));
    return top;
}

Handlers MainWindow::handlers()
{
    const auto parameter = [this](const char* key, bool on) {
        const ParameterRow& row = *findParameter(key);
        m_document.edit(qt(row.label), [&](State& state) { assign(state, row, on, Scope::Both); });
    };
    return {
        {"new", [this](bool) { m_files->startNew(); }},
        {"open", [this](bool) { m_files->ask(); }},
        {"open-folder", [this](bool) { m_files->askFolder(); }},
        {"save", [this](bool) { m_files->save(); }},
        {"save-as", [this](bool) { m_files->saveAs(); }},
        {"export", [this](bool) { showExport(); }},
        {"quit", [this](bool) { close(); }},
        {"undo", [this](bool) { m_document.undoStack().undo(); }},
        {"redo", [this](bool) { m_document.undoStack().redo(); }},
        {"copy-picture", [this](bool) { copyPicture(); }},
        {"copy-camera", [this](bool) { copyCamera(); }},
        {"paste-camera", [this](bool) { pasteCamera(); }},
        {"wireframe", [parameter](bool on) { parameter("wireframe", on); }},
        {"two-panes",
            [this](bool on) { m_document.edit(m_actions["two-panes"]->text(), [&](State& state) { m_second.show(state, on); }); }},
        {"frame", [this](bool) { m_document.edit({}, [](State& state) { state.camera = framed(state.camera); }); }},
        {"reset-camera", [this](bool) { m_document.edit({}, [](State& state) { state.camera = Camera{}; }); }},
        {"light-theme",
            [](bool on) {
                saveLook(on ? Look::Light : Look::Dark);
                applyLook(*qApp, savedLook());
            }},
        {"panels", [this](bool on) { showPanels(on); }},
        {"shortcuts", [this](bool) { showShortcuts(this); }},
        {"about", [this](bool) { showAbout(this); }},
    };
}

void MainWindow::connectAll()
{
    connect(m_techniques, &TechniqueBar::chosen, this, [this](const TechniqueRow& row) { setTechnique(row.key); });
    connect(m_view, &QComboBox::activated, this, [this](int index) { setView(kViews[std::size_t(index)].key); });
    connect(m_viewport, &Viewport::activePaneChanged, this, [this] { documentChanged(Change::Panes); });
    connect(m_parameters, &ParameterPanel::scopeChanged, this, [this](Scope scope) {
        if (scope != Scope::Both)
            m_viewport->setActivePane(scope == Scope::A ? 0 : 1);
    });
    connect(&m_document, &Document::changed, this, &MainWindow::documentChanged);
    connect(&m_document, &Document::started, this, [this] { m_second.forget(); });
    connect(&m_document, &Document::titleChanged, this, &MainWindow::updateTitle);
    QUndoStack& undo = m_document.undoStack();
    const auto tell = [](QAction* action, const QString& verb, bool can, const QString& text) {
        action->setEnabled(can);
        action->setText(text.isEmpty() ? verb : verb + ' ' + text);
    };
    const auto update = [this, &undo, tell] {
        tell(m_actions["undo"], tr("Undo"), undo.canUndo(), undo.undoText());
        tell(m_actions["redo"], tr("Redo"), undo.canRedo(), undo.redoText());
    };
    connect(&undo, &QUndoStack::indexChanged, this, update);
    update();
}

void MainWindow::documentChanged(Changes what)
{
    const State& state = m_document.state();
    if (what & Change::Panes)
        m_techniques->show(state.panes[std::size_t(std::min<int>(m_viewport->activePane(), int(state.panes.size()) - 1))].technique);
    if (what & Change::View)
        m_view->setCurrentIndex(m_view->findData(QString::fromStdString(state.view)));
    m_actions["two-panes"]->setChecked(state.panes.size() > 1);
    m_actions["wireframe"]->setChecked(state.parameters.wireframe);
}

void MainWindow::updateTitle()
{
    setWindowTitle(QString::fromUtf8("%1[*] \u2013 Relievo").arg(m_document.name()));
    setWindowModified(m_document.isModified());
}

void MainWindow::setTechnique(std::string_view key)
{
    const std::size_t pane = std::size_t(m_viewport->activePane());
    m_document.edit(tr("Technique %1").arg(qt(findTechnique(key)->label)), [&](State& state) { state.panes[pane].technique = key; });
}

void MainWindow::setView(std::string_view key)
{
    m_document.edit(tr("View %1").arg(qt(findView(key)->label)), [&](State& state) { state.view = key; });
}

void MainWindow::showPanels(bool on)
{
    m_actions["panels"]->setChecked(on);
    m_maps->setVisible(on);
    m_parameters->setVisible(on);
}

void MainWindow::showExport()
{
    commitTyping(this);
    if (!m_export)
        m_export = new ExportDialog(m_document, m_assets, this);
    m_export->show();
    m_export->raise();
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
    saveLayout();
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
    const auto urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    m_files->take(event->mimeData()->urls().front().toLocalFile()); // of several images the first finds its siblings
}

void MainWindow::restoreLayout()
{
    const QSettings settings;
    resize(1280, 800);
    restoreGeometry(settings.value("window/geometry").toByteArray());
    if (!m_splitter->restoreState(settings.value("window/splitter").toByteArray()))
        m_splitter->setSizes({kMapWidth, width() - kMapWidth - kParameterWidth, kParameterWidth});
    showPanels(settings.value("window/panels", true).toBool());
    m_actions["light-theme"]->setChecked(savedLook() == Look::Light);
}

void MainWindow::saveLayout() const
{
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/splitter", m_splitter->saveState());
    settings.setValue("window/panels", m_actions["panels"]->isChecked());
}

} // namespace relievo
