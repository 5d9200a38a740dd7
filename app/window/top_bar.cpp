// Menus and keys from the table of actions, and from those of techniques, views, samples and recent files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/top_bar.h"
#include "app/window/document/files.h"
#include "app/window/panels/technique_bar.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QToolButton>
#include <QUndoStack>

namespace relievo {
namespace {
// One for each row of kViews, along the keyboard.
constexpr std::string_view kViewKeys = "1234567890-=";
static_assert(kViewKeys.size() >= kViews.size(), "a view without key");
constexpr Qt::Key viewKey(std::size_t i)
{
    return Qt::Key(kViewKeys[i]); // Qt::Key_0 and its like are the characters' codes
}

// The keys of a row as a menu shows them. A shortcut of the item itself would make that of addKeys ambiguous.
QString keyText(const QKeySequence& keys)
{
    return '\t' + keys.toString(QKeySequence::NativeText);
}

QKeySequence techniqueKeys(int i) // empty after the ninth
{
    return i < 9 ? QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + i)) : QKeySequence();
}

QLabel* dim(const QString& text)
{
    auto* label = new QLabel(text);
    label->setProperty("role", "dim");
    return label;
}

QFrame* ruler()
{
    auto* rule = upright();
    rule->setFixedHeight(20);
    return rule;
}

QComboBox* listOfViews()
{
    auto* list = new ChoiceList;
    list->setObjectName("view");
    for (const ViewRow& row : kViews) {
        list->addItem(qt(row.label), qt(row.key));
        list->setItemData(list->count() - 1, qt(row.help), Qt::ToolTipRole);
    }
    return list;
}
} // namespace

TopBar::TopBar(Files& files, QWidget* window)
    : m_files(files)
    , m_menus(new QMenuBar)
    , m_actions(makeActions(window, m_menus, [this](Action action, bool on) { Q_EMIT triggered(action, on); }))
    , m_techniques(new TechniqueBar)
    , m_view(listOfViews())
{
    m_menus->setObjectName("menu");
    m_menus->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(8, 4, 8, 4);
    line->setSpacing(2 * kGrid);
    line->addWidget(m_menus);
    line->addWidget(ruler());
    line->addLayout(fileButtons());
    line->addWidget(ruler());
    line->addWidget(dim(tr("Technique")));
    line->addWidget(m_techniques, 1);
    line->addWidget(dim(tr("View")));
    line->addWidget(m_view);
    for (const Action action : {Action::Wireframe, Action::TwoPanes, Action::Frame, Action::Panels})
        line->addWidget(toolButton(m_actions[action]));
    connect(m_techniques, &TechniqueBar::chosen, this, &TopBar::techniqueChosen);
    connect(m_view, &QComboBox::activated, this, [this](int index) { Q_EMIT viewChosen(kViews[std::size_t(index)]); });
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
    lazyMenu(view, first, tr("Technique"), [this](QMenu& menu) {
        for (int i = 0; i < m_techniques->rows().size(); ++i) {
            const TechniqueRow& row = *m_techniques->rows()[i];
            QAction* action
                = menu.addAction(qt(row.label) + keyText(techniqueKeys(i)), this, [this, &row] { Q_EMIT techniqueChosen(row); });
            action->setToolTip(qt(row.help));
        }
    });
    lazyMenu(view, first, tr("Show"), [this](QMenu& menu) {
        for (std::size_t i = 0; i < kViews.size(); ++i) {
            const ViewRow& row = kViews[i];
            QAction* action
                = menu.addAction(qt(row.label) + keyText(QKeySequence(viewKey(i))), this, [this, &row] { Q_EMIT viewChosen(row); });
            action->setToolTip(qt(row.help));
        }
    });
}

// The menus above are filled when they open; their keys work always.
void TopBar::addKeys(QWidget* window)
{
    for (int i = 0; i < m_techniques->rows().size() && !techniqueKeys(i).isEmpty(); ++i)
        connect(new QShortcut(techniqueKeys(i), window), &QShortcut::activated, this,
            [this, i] { Q_EMIT techniqueChosen(*m_techniques->rows()[i]); });
    for (std::size_t i = 0; i < kViews.size(); ++i)
        connect(new QShortcut(QKeySequence(viewKey(i)), window), &QShortcut::activated, this, [this, i] { Q_EMIT viewChosen(kViews[i]); });
    connect(new QShortcut(QKeySequence(Qt::Key_F10), window), &QShortcut::activated, m_menus,
        [this] { m_menus->setActiveAction(m_menus->actions().front()); });
}

void TopBar::showTechnique(const std::string& key)
{
    m_techniques->show(key);
}

void TopBar::showView(const std::string& key)
{
    m_view->setCurrentIndex(m_view->findData(QString::fromStdString(key)));
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
