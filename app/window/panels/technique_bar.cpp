// The technique bar, walked from the table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/technique_bar.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include <QMenu>
#include <algorithm>

namespace relievo {

TechniqueBar::TechniqueBar(QWidget* parent) : QWidget(parent), m_list(new ChoiceList(this))
{
    QVector<Segmented::Item> items;
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        m_rows.append(&row);
        const QString paper = row.paper == "-" ? QString() : "<br><i>" + qt(row.paper) + "</i>";
        items.append({qt(row.label), QString("<p><b>%1</b><br>%2%3</p>").arg(qt(row.label), qt(row.help), paper), {}});
        m_list->addItem(qt(row.label));
        m_list->setItemData(m_list->count() - 1, items.last().tip, Qt::ToolTipRole);
    }
    m_buttons = new Segmented(items, this);
    m_buttons->setObjectName("techniques");
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(m_buttons, &Segmented::chosen, this, [this](int index) { Q_EMIT chosen(*m_rows[index]); });
    connect(m_list, &QComboBox::activated, this, [this](int index) { Q_EMIT chosen(*m_rows[index]); });
}

void TechniqueBar::show(const std::string& technique)
{
    const auto at = std::find_if(m_rows.begin(), m_rows.end(), [&](const TechniqueRow* row) { return row->key == technique; });
    const int index = at == m_rows.end() ? -1 : int(at - m_rows.begin());
    m_buttons->setCurrent(index);
    m_list->setCurrentIndex(index);
}

QSize TechniqueBar::sizeHint() const
{
    return m_buttons->sizeHint();
}

void TechniqueBar::resizeEvent(QResizeEvent*)
{
    const bool room = width() >= m_buttons->sizeHint().width();
    m_buttons->setVisible(room);
    m_list->setVisible(!room);
    m_buttons->setGeometry(QRect(QPoint(0, 0), m_buttons->sizeHint()));
    m_list->setGeometry(rect());
}

void popUpTechniques(QWidget* parent, QPoint at, const std::string& current, const std::function<void(const TechniqueRow&)>& chosen)
{
    auto* menu = new QMenu(parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        QAction* action = menu->addAction(qt(row.label));
        action->setToolTip(qt(row.help));
        action->setCheckable(true);
        action->setChecked(row.key == current);
        QObject::connect(action, &QAction::triggered, parent, [chosen, &row] { chosen(row); });
    }
    menu->popup(at);
}

} // namespace relievo
