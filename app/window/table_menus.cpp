// Menus and keys that come from other tables than that of the actions: techniques, views, samples, recent files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/files.h"
#include "app/window/main_window.h"
#include "app/window/panels/technique_bar.h"
#include "app/window/widgets/text.h"
#include "core/state/views.h"
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>

namespace relievo {
namespace {
// One for each row of kViews, along the keyboard.
constexpr std::string_view kViewKeys = "1234567890-";
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
} // namespace

// Rows of other tables in the menus.
void MainWindow::addTableMenus()
{
    auto* bar = menuWidget()->findChild<QMenuBar*>("menu");
    QMenu* file = menuOf(bar, "File");
    QAction* line = file->actions().value(file->actions().indexOf(m_actions["save"]) - 1); // the separator
    lazyMenu(file, line, tr("Open recent"), [this](QMenu& menu) { m_files->fillRecent(menu); });
    lazyMenu(file, line, tr("Built-in materials"), [this](QMenu& menu) { m_files->fillSamples(menu); });
    lazyMenu(file, line, tr("Presets"), [this](QMenu& menu) { m_files->fillPresets(menu); });
    QMenu* view = menuOf(bar, "View");
    QAction* first = view->actions().front();
    lazyMenu(view, first, tr("Technique"), [this](QMenu& menu) {
        for (int i = 0; i < m_techniques->rows().size(); ++i) {
            const TechniqueRow& row = *m_techniques->rows()[i];
            QAction* action = menu.addAction(qt(row.label) + keyText(techniqueKeys(i)), this, [this, &row] { setTechnique(row.key); });
            action->setToolTip(qt(row.help));
        }
    });
    lazyMenu(view, first, tr("Show"), [this](QMenu& menu) {
        for (std::size_t i = 0; i < kViews.size(); ++i) {
            const ViewRow& row = kViews[i];
            QAction* action = menu.addAction(qt(row.label) + keyText(QKeySequence(viewKey(i))), this, [this, &row] { setView(row.key); });
            action->setToolTip(qt(row.help));
        }
    });
}

// The menus above are filled when they open; their keys work always.
void MainWindow::addKeys()
{
    for (int i = 0; i < m_techniques->rows().size() && !techniqueKeys(i).isEmpty(); ++i)
        connect(
            new QShortcut(techniqueKeys(i), this), &QShortcut::activated, this, [this, i] { setTechnique(m_techniques->rows()[i]->key); });
    for (std::size_t i = 0; i < kViews.size(); ++i)
        connect(new QShortcut(QKeySequence(viewKey(i)), this), &QShortcut::activated, this, [this, i] { setView(kViews[i].key); });
    auto* bar = menuWidget()->findChild<QMenuBar*>("menu");
    connect(new QShortcut(QKeySequence(Qt::Key_F10), this), &QShortcut::activated, bar,
        [bar] { bar->setActiveAction(bar->actions().front()); });
}

} // namespace relievo
