// The parameter panel, walked from the table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/parameter_panel.h"
#include "app/window/panels/parameter_editor.h"
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/section.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace relievo {
namespace {
// All panes, then each.
QVector<Segmented::Item> scopeItems(std::size_t panes)
{
    QVector<Segmented::Item> items;
    if (panes == 2)
        items = {{QObject::tr("Both"), QObject::tr("Changes reach both pictures"), {}}};
    else
        items = {{QObject::tr("All"), QObject::tr("Changes reach all pictures"), {}}};
    for (std::size_t pane = 0; pane < panes; ++pane)
        items.append({paneLetter(pane), QObject::tr("Changes reach picture %1 only").arg(paneLetter(pane)), {}});
    return items;
}

// Their sections are closed at first: most pictures have one light.
bool isFurtherLight(Group group)
{
    return group == Group::Light2 || group == Group::Light3 || group == Group::Light4;
}
} // namespace

ParameterPanel::ParameterPanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_scopeLine(new QWidget(this))
    , m_scopeChoice(new Segmented({}, m_scopeLine))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* scopeLayout = new QHBoxLayout(m_scopeLine);
    scopeLayout->setContentsMargins(12, 8, 8, 8);
    scopeLayout->addWidget(new QLabel(tr("Changes reach")));
    scopeLayout->addStretch(1);
    scopeLayout->addWidget(m_scopeChoice);
    layout->addWidget(m_scopeLine);

    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (std::size_t i = 0; i < kChoices<Group>; ++i) { // Tab goes in the order in which they are made
        column->addWidget(m_sections[Group(i)] = new Section(qt(wordOf(Group(i))), nullptr, !isFurtherLight(Group(i))));
        connect(m_sections[Group(i)], &Section::opened, this, &ParameterPanel::sectionsChanged);
        for (const ParameterRow& row : kParameters)
            if (std::size_t(row.group) == i)
                addEditor(row, *m_sections[Group(i)]);
    }
    column->addStretch(1);

    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    scroll->setWidget(content);
    layout->addWidget(scroll, 1);

    connect(
        m_scopeChoice, &Segmented::chosen, this, [this](int index) { setScope(index == 0 ? kAllPanes : Scope(std::size_t(index - 1))); });
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & (Changes(Change::Parameters) | Change::Panes))
            refresh();
    });
    refresh();
}

void ParameterPanel::addEditor(const ParameterRow& row, Section& section)
{
    auto* editor = new ParameterEditor(row);
    section.body()->addWidget(editor);
    m_editors.append(editor);
    connect(editor, &ParameterEditor::pressed, &m_document, &Document::beginGesture);
    connect(editor, &ParameterEditor::resumed, &m_document, &Document::resumeGesture);
    connect(editor, &ParameterEditor::released, &m_document, &Document::endGesture);
    connect(editor, &ParameterEditor::edited, this,
        [this, &row](const Value& value) { m_document.edit(qt(row.label), [&](State& state) { assign(state, row, value, m_scope); }); });
    connect(editor, &ParameterEditor::resetWanted, this, [this, &row] {
        const QString name = m_document.inGesture() ? qt(row.label) : tr("Reset %1").arg(qt(row.label)); // then one step with its edits
        m_document.edit(name, [&](State& state) { reset(state, row, m_scope); });
    });
    connect(editor, &ParameterEditor::clearWanted, this,
        [this, &row] { m_document.edit(tr("Same %1").arg(qt(row.label)), [&](State& state) { clearOverride(state, row, m_scope); }); });
}

bool ParameterPanel::isOpen(Group group) const
{
    return m_sections[group]->isVisible() && m_sections[group]->isOpen();
}

void ParameterPanel::setScope(Scope scope)
{
    if (scope == m_scope)
        return;
    m_scope = scope;
    refresh();
    Q_EMIT scopeChanged(scope);
}

void ParameterPanel::refresh()
{
    const State& state = m_document.state();
    if (m_scope && (state.panes.size() == 1 || *m_scope >= state.panes.size()))
        return setScope(kAllPanes);
    m_scopeLine->setVisible(state.panes.size() > 1);
    m_scopeChoice->setItems(scopeItems(state.panes.size()));
    m_scopeChoice->setCurrent(m_scope ? int(*m_scope) + 1 : 0);
    PerChoice<Group, bool> used;
    for (ParameterEditor* editor : m_editors) {
        const ParameterRow& row = editor->row();
        const bool shown = isShown(state, row);
        used[row.group] |= shown;
        editor->setVisible(shown);
        editor->show(shownValue(state, row, m_scope), isOverridden(state, row, m_scope) && state.panes.size() > 1);
    }
    for (std::size_t i = 0; i < kChoices<Group>; ++i)
        m_sections[Group(i)]->setVisible(used[Group(i)]);
}

} // namespace relievo
