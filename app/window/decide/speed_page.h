// The page of speed against error: the plot, what its axes show, and what a point says.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/decide/live_sweep.h"
#include <QWidget>

class QBoxLayout;

namespace relievo {

class ElidedLabel;
class Segmented;
class SpeedPlot;

// Costs nothing while it is hidden.
class SpeedPage : public QWidget {
    Q_OBJECT
public:
    SpeedPage(Document& document, const Assets& assets, const Viewport& viewport);
    const LiveSweep& sweep() const { return m_sweep; }
    SpeedPlot& plot() { return *m_plot; }

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    void refresh();
    void say(int point); // in the line; -1: how far the measuring is
    void choose(int point);
    Document& m_document;
    const Viewport& m_viewport;
    LiveSweep m_sweep;
    Segmented *m_cost, *m_error;
    ElidedLabel* m_line;
    QBoxLayout* m_head;
    SpeedPlot* m_plot;
};

// The setting becomes that of the pane, as one undo step: of all panes where there is one.
void applySetting(Document& document, std::size_t pane, const SearchSetting& setting);

} // namespace relievo
