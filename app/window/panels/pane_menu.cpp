// Filling the menu of a pane.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/pane_menu.h"
#include "app/window/document/document.h"
#include "app/window/document/editing.h"
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/text.h"
#include "core/state/techniques.h"
#include <QMenu>
#include <algorithm>

namespace relievo {
namespace {
QString tr(const char* text)
{
    return QObject::tr(text);
}

QAction* add(QMenu& menu, const char* name, const QString& text, const QString& tip, std::function<void()> does)
{
    QAction* action = menu.addAction(text);
    action->setObjectName(name);
    action->setToolTip(tip);
    QObject::connect(action, &QAction::triggered, &menu, std::move(does));
    return action;
}

// "0.12   (all: 0.08)"
QString ownAndShared(const State& state, const ParameterRow& row, std::size_t pane)
{
    const auto text = [&](Scope scope) { return QString::fromStdString(toText(row, shownValue(state, row, scope))); };
    return tr("%1   (all: %2)").arg(text(pane), text(kAllPanes));
}

void addOwnValues(QMenu& menu, Document& document, std::size_t pane, const std::function<void()>& ownValuesWanted)
{
    const auto edit = [&document, pane](const QString& what, auto change) {
        document.edit(what, [&](State& state) {
            if (pane < state.panes.size())
                change(state);
        });
    };
    add(menu, "own-values", tr("Change values of this picture only"), tr("The panel's values reach this picture alone"), ownValuesWanted);
    const State& state = document.state();
    const auto own = ownValues(state, pane);
    for (const ParameterRow* row : own)
        add(menu, row->key.data(), qt(row->label) + '\t' + ownAndShared(state, *row, pane), tr("Take the value that all have"),
            [=] { edit(tr("Same %1").arg(qt(row->label)), [=](State& s) { clearOverride(s, *row, pane); }); });
    add(menu, "take-over", tr("Take its values over to all"), tr("What this picture has of its own holds for all"), [=] {
        edit(tr("Take over"), [=](State& s) { shareOwnValues(s, pane); });
    })->setEnabled(!own.empty());
    add(menu, "same-as-all", tr("Same values as all"), tr("Nothing of its own any more"), [=] {
        edit(tr("Same values"), [=](State& s) { dropOwnValues(s, pane); });
    })->setEnabled(!own.empty());
}
} // namespace

void fillPaneMenu(QMenu& menu, Document& document, std::size_t pane, const std::function<void()>& ownValuesWanted)
{
    menu.setToolTipsVisible(true);
    const State& state = document.state();
    const std::size_t count = state.panes.size();
    // It was of a document with so many panes.
    const auto edit = [&document, count](const QString& what, auto change) {
        document.edit(what, [&](State& s) {
            if (s.panes.size() == count)
                change(s);
        });
    };
    add(menu, "duplicate", tr("Duplicate"), tr("The same picture once more"), [=] {
        edit(tr("Duplicate %1").arg(paneLetter(pane)), [=](State& s) { duplicatePane(s, pane); });
    })->setEnabled(count < kMaxPanes);
    add(menu, "close", tr("Close"), tr("Without this picture"), [=] {
        edit(tr("Close %1").arg(paneLetter(pane)), [=](State& s) { closePane(s, pane); });
    })->setEnabled(count > 1);
    for (std::size_t other = 0; other < count; ++other)
        if (other != pane)
            add(menu, qPrintable("swap-" + paneLetter(other)), tr("Swap with %1").arg(paneLetter(other)), tr("They change their places"),
                [&document, pane, other] { swapPanes(document, pane, other); });
    menu.addSeparator();
    const bool linked = isLinked(state, pane);
    QAction* own = add(menu, "own-camera", tr("Own camera and light"), tr("It moves alone, and its light turns alone"),
        [=] { edit(tr("Own camera"), [=](State& s) { setLinked(s, pane, !linked); }); });
    own->setCheckable(true);
    own->setChecked(!linked);
    menu.addSeparator();
    addOwnValues(menu, document, pane, ownValuesWanted);
}

void chooseTechnique(Document& document, std::size_t pane, const TechniqueRow& technique)
{
    document.edit(tr("Technique %1").arg(qt(technique.label)), [&](State& state) {
        if (pane < state.panes.size())
            state.panes[pane].technique = technique.key;
    });
}

void swapPanes(Document& document, std::size_t one, std::size_t other)
{
    document.edit(tr("Swap %1 and %2").arg(paneLetter(one), paneLetter(other)), [&](State& state) {
        if (std::max(one, other) < state.panes.size())
            swapPanes(state, one, other);
    });
}

void fillPaneCounts(QMenu& menu, std::size_t current, const std::function<void(std::size_t)>& chosen)
{
    for (const std::size_t count : kPaneCounts) {
        const QString keys = paneCountKeys(count).toString(QKeySequence::NativeText);
        QAction* action = menu.addAction(QString::number(count) + '\t' + keys);
        action->setObjectName(QString("panes-%1").arg(count));
        action->setCheckable(true);
        action->setChecked(count == current);
        QObject::connect(action, &QAction::triggered, &menu, [chosen, count] { chosen(count); });
    }
}

} // namespace relievo
