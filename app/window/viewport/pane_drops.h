// Techniques and panes that are dragged onto a pane.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <functional>
#include <string>

class QDropEvent;
class QMimeData;
class QWidget;

namespace relievo {

class Document;

// Begins a drag; they return when it has ended. technique: a key of kTechniques.
void dragTechnique(QWidget* from, const std::string& technique);
void dragPane(QWidget* from, std::size_t pane);
QMimeData* draggedTechnique(const std::string& technique);
QMimeData* draggedPane(std::size_t pane);

// Takes drops for a widget, which owns it: a technique draws the pane that it falls on, a pane swaps places with it. What brings neither is
// left to others.
class PaneDrops : public QObject {
    Q_OBJECT
public:
    PaneDrops(Document& document, std::function<std::size_t(QPointF position)> paneAt, QWidget* widget);

protected:
    bool eventFilter(QObject* widget, QEvent* event) override;

private:
    void drop(const QDropEvent& event);
    Document& m_document;
    std::function<std::size_t(QPointF position)> m_paneAt;
};

} // namespace relievo
