// Menus and keys that come from other tables than that of the actions: techniques, views, samples, recent files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files.h"
#include "app/window/main_window.h"
#include "app/window/technique_bar.h"
#include "app/window/text.h"
#include "core/state/views.h"
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>

namespace relievo {
namespace {
// The key of the i-th row as a menu shows it. A shortcut of the item itself would make that of addKeys ambiguous.
QString keyText(Qt::KeyboardModifiers keys, int i)
{
    return i < 9 ? '\t' + QKeySequence(int(keys) | (Qt::Key_1 + i)).toString(QKeySequence::NativeText) : QString();
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
            menu.addAction(qt(row.label) + keyText(Qt::ControlModifier, i), this, [this, &row] { setTechnique(row.key); });
        }
    });
    lazyMenu(view, first, tr("Show"), [this](QMenu& menu) {
        for (std::size_t i = 0; i < kViews.size(); ++i)
            menu.addAction(qt(kViews[i].label) + keyText(Qt::NoModifier, int(i)), this, [this, i] { setView(kViews[i].key); });
    });
}

// The menus above are filled when they open; their keys work always.
void MainWindow::addKeys()
{
    for (int i = 0; i < m_techniques->rows().size() && i < 9; ++i)
        connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + i)), this), &QShortcut::activated, this,
            [this, i] { setTechnique(m_techniques->rows()[i]->key); });
    for (int i = 0; i < int(kViews.size()) && i < 9; ++i)
        connect(new QShortcut(QKeySequence(Qt::Key(Qt::Key_1 + i)), this), &QShortcut::activated, this,
            [this, i] { setView(kViews[std::size_t(i)].key); });
}

} // namespace relievo
