// Menus and keys from the table of actions, and from those of techniques, views, samples and recent files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/top_bar.h"
#include "app/window/document/files.h"
#include "app/window/panels/choice_menus.h"
#include "app/window/panels/pane_menu.h"
#include "app/window/run_action.h"
#include "app/window/viewport/navigation.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QToolButton>
#include <QUndoStack>

namespace relievo {
namespace {
QFrame* ruler()
{
    auto* rule = upright();
    rule->setFixedHeight(20);
    return rule;
}

} // namespace

TopBar::TopBar(Files& files, QWidget* window)
    : m_files(files)
    , m_menus(new QMenuBar)
    , m_actions(makeActions(window, m_menus, [this](Action action, bool on) { Q_EMIT triggered(action, on); }))
{
    m_menus->setObjectName("menu");
    m_menus->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(8, 4, 8, 4);
    line->setSpacing(2 * kGrid);
    line->addWidget(m_menus);
    line->addWidget(ruler());
    line->addLayout(fileButtons());
    line->addStretch(1);
    for (const Action action : {Action::Wireframe, Action::TwoPanes, Action::Frame, Action::Panels})
        line->addWidget(toolButton(m_actions[action]));
    addTableMenus();
    addKeys(window);
}

QHBoxLayout* TopBar::fileButtons()
{
    auto* samples = new QToolButton;
    samples->setIcon(icon("sample"));
    samples->setIconSize({16, 16});
    samples->setFixedSize(28, 28);
    samples->setPopupMode(QToolButton::InstantPopup);
    samples->setToolTip(tr("Built-in materials"));
    auto* menu = new QMenu(samples);
    menu->setToolTipsVisible(true);
    m_files.fillSamples(*menu);
    samples->setMenu(menu);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    buttons->addWidget(samples);
    for (const Action action : {Action::Open, Action::Save, Action::Undo, Action::Redo, Action::Export})
        buttons->addWidget(toolButton(m_actions[action]));
    return buttons;
}

// Rows of other tables in the menus.
void TopBar::addTableMenus()
{
    QMenu* file = menuOf(m_menus, "File");
    QAction* line = file->actions().value(file->actions().indexOf(m_actions[Action::Save]) - 1); // the separator
    lazyMenu(file, line, tr("Open recent"), [this](QMenu& menu) { m_files.fillRecent(menu); });
    lazyMenu(file, line, tr("Built-in materials"), [this](QMenu& menu) { m_files.fillSamples(menu); });
    lazyMenu(file, line, tr("Presets"), [this](QMenu& menu) { m_files.fillPresets(menu); });
    QMenu* view = menuOf(m_menus, "View");
    QAction* first = view->actions().front();
    lazyMenu(view, first, tr("Technique"),
        [this](QMenu& menu) { fillTechniques(menu, m_technique, [this](const TechniqueRow& row) { Q_EMIT techniqueChosen(row); }); });
    lazyMenu(
        view, first, tr("Show"), [this](QMenu& menu) { fillViews(menu, m_view, [this](const ViewRow& row) { Q_EMIT viewChosen(row); }); });
    lazyMenu(view, first, tr("Pictures"),
        [this](QMenu& menu) { fillPaneCounts(menu, m_panes, [this](std::size_t count) { Q_EMIT paneCountChosen(count); }); });
    lazyMenu(view, first, tr("Field of view"), [this](QMenu& menu) {
        for (const float degrees : kFieldsOfView) {
            QAction* choice = menu.addAction(fieldOfViewText(degrees), this, [this, degrees] { Q_EMIT fieldOfViewChosen(degrees); });
            choice->setCheckable(true);
            choice->setChecked(degrees == m_fieldOfView);
        }
    });
}

// The menus above are filled when they open; their keys work always.
void TopBar::addKeys(QWidget* window)
{
    for (int i = 0; !techniqueKeys(i).isEmpty(); ++i)
        connect(new QShortcut(techniqueKeys(i), window), &QShortcut::activated, this, [this, i] {
            const TechniqueRow* now = findTechnique(m_technique);
            if (const auto techniques = drawnTechniques(now && now->isOfObjects); i < techniques.size())
                Q_EMIT techniqueChosen(*techniques[i]);
        });
    for (std::size_t i = 0; i < kViews.size() && !viewKeys(i).isEmpty(); ++i)
        connect(new QShortcut(viewKeys(i), window), &QShortcut::activated, this, [this, i] { Q_EMIT viewChosen(kViews[i]); });
    for (const std::size_t count : kPaneCounts)
        connect(new QShortcut(paneCountKeys(count), window), &QShortcut::activated, this, [this, count] { Q_EMIT paneCountChosen(count); });
    connect(new QShortcut(QKeySequence(Qt::Key_F10), window), &QShortcut::activated, m_menus,
        [this] { m_menus->setActiveAction(m_menus->actions().front()); });
}

void TopBar::tick(const std::string& technique, const std::string& view, std::size_t panes, float fieldOfView)
{
    m_fieldOfView = fieldOfView;
    m_panes = panes;
    m_technique = technique;
    m_view = view;
}

void TopBar::follow(const QUndoStack& undo)
{
    const auto tell = [](QAction* action, const QString& verb, bool can, const QString& text) {
        action->setEnabled(can);
        action->setText(text.isEmpty() ? verb : verb + ' ' + text);
    };
    const auto update = [this, &undo, tell] {
        tell(m_actions[Action::Undo], tr("Undo"), undo.canUndo(), undo.undoText());
        tell(m_actions[Action::Redo], tr("Redo"), undo.canRedo(), undo.redoText());
    };
    connect(&undo, &QUndoStack::indexChanged, this, update);
    update();
}

} // namespace relievo
