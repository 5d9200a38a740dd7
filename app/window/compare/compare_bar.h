// How two pictures are compared: a bar under them, with what the way of comparing needs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/action.h"
#include "app/window/compare/in_place.h"
#include "app/window/document/editing.h"
#include <QWidget>

class QComboBox;
class QLabel;

namespace relievo {

class Document;
class Segmented;
class Viewport;

// Of the actions Wipe to Flip.
inline InPlaceMode inPlaceModeOf(Action action)
{
    return InPlaceMode(int(InPlaceMode::Wipe) + int(action) - int(Action::Wipe));
}

// Seen while there are several panes. Where it is too narrow for all ways beside each other, a menu offers them.
class CompareBar : public QWidget {
    Q_OBJECT
public:
    CompareBar(Document& document, Viewport& viewport);
    QSize minimumSizeHint() const override { return {0, QWidget::minimumSizeHint().height()}; }

    void showPanes(bool several); // the others go, or come back as they last were
    void showPanes(std::size_t count);
    // on: in that way, of two panes when there is but one; off: side by side again.
    void compare(InPlaceMode mode, bool on);
    bool compares(InPlaceMode mode) const; // now
    void swap(); // the two that are compared

protected:
    void resizeEvent(QResizeEvent*) override { fit(); }

private:
    void follow();
    void showPair();
    void choosePair(std::size_t pane, bool second);
    void fit();
    void setMode(int index);
    Document& m_document;
    Viewport& m_viewport;
    Segmented* m_modes;
    QComboBox *m_mode, *m_first, *m_second, *m_gain, *m_sense;
    QLabel* m_number;
    FurtherPanes m_furtherPanes;
};

} // namespace relievo
