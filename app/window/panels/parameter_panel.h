// The panel on the right: one line for each parameter that the picture uses, in collapsible groups.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/document.h"
#include "app/window/document/editing.h"
#include <QVector>
#include <QWidget>
#include <array>

namespace relievo {

class ParameterEditor;
class Section;
class Segmented;

class ParameterPanel : public QWidget {
    Q_OBJECT
public:
    explicit ParameterPanel(Document& document, QWidget* parent = nullptr);
    Scope scope() const { return m_scope; }
    void setScope(Scope scope);
    bool isOpen(Group group) const; // and to be seen

Q_SIGNALS:
    void sectionsChanged(); // one was opened or closed
    void scopeChanged(relievo::Scope scope);

private:
    void addEditor(const ParameterRow& row, Section& section);
    void refresh();
    Document& m_document;
    Scope m_scope = kAllPanes;
    QWidget* m_scopeLine;
    Segmented* m_scopeChoice;
    PerChoice<Group, Section*> m_sections;
    QVector<ParameterEditor*> m_editors; // one for each row of kParameters, by groups
};

} // namespace relievo
