// What can be opened under the picture: one dock at a time, each shown by its action.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/action.h"
#include <QObject>
#include <vector>

class QWidget;

namespace relievo {

class Assets;
class DecideDock;
class Document;
class RayInspector;
class Viewport;

// Made hidden; whoever puts them into a layout owns them.
class Docks : public QObject {
    Q_OBJECT
public:
    Docks(Document& document, Assets& assets, Viewport& viewport);

    std::vector<QWidget*> between(QWidget* above, QWidget* below) const; // all, in their order
    void show(Action action, bool on); // of a dock; what else is shown closes
    RayInspector& inspector() { return *m_inspector; }
    DecideDock& decide() { return *m_decide; }

Q_SIGNALS:
    void closed(relievo::Action action); // by its own button, or as another one opened

private:
    struct Dock {
        Action action;
        QWidget* widget;
    };
    template <class Widget> void add(Action action, Widget* dock);
    std::vector<Dock> m_all;
    RayInspector* m_inspector;
    DecideDock* m_decide;
};

} // namespace relievo
