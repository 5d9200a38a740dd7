// Opening and closing docks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/docks.h"
#include "app/window/decide/decide_dock.h"
#include "app/window/inspector/picking.h"
#include "app/window/inspector/ray_inspector.h"
#include "app/window/viewport/viewport.h"

namespace relievo {

template <class Widget> void Docks::add(Action action, Widget* dock)
{
    dock->hide();
    connect(dock, &Widget::closed, this, [this, action] { show(action, false); });
    m_all.push_back({action, dock});
}

Docks::Docks(Document& document, Assets& assets, Viewport& viewport)
    : m_inspector(new RayInspector(document, assets))
    , m_decide(new DecideDock(document, assets, viewport))
{
    add(Action::RayInspector, m_inspector);
    add(Action::SpeedAndError, m_decide);
    connectPicking(*m_inspector, viewport, document);
}

std::vector<QWidget*> Docks::between(QWidget* above, QWidget* below) const
{
    std::vector<QWidget*> widgets = {above};
    for (const Dock& dock : m_all)
        widgets.push_back(dock.widget);
    widgets.push_back(below);
    return widgets;
}

// What opens comes last, so that the picture does not grow in between.
void Docks::show(Action action, bool on)
{
    for (const Dock& dock : m_all)
        if (dock.widget->isVisibleTo(dock.widget->parentWidget()) && (dock.action != action || !on)) {
            dock.widget->hide();
            Q_EMIT closed(dock.action);
        }
    for (const Dock& dock : m_all)
        if (dock.action == action && on)
            dock.widget->show();
}

} // namespace relievo
