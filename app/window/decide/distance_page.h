// Cost against distance: how many pixels the relief moves what is seen, and the technique's error, from near to far and at several angles.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/analysis/decide/distance.h"
#include <QTimer>
#include <QWidget>

class QCustomPlot;
class QLabel;

namespace relievo {

class Viewport;

// Of the active pane; measured in the background while it is seen, when nothing moves.
class DistancePage : public QWidget {
    Q_OBJECT
public:
    DistancePage(const Document& document, const Assets& assets, const Viewport& viewport);
    struct Answer {
        std::string setting; // label
        std::vector<AngleFigures> figures;
        double depth = 0., distance = 0.; // m; of the eye now
        Lens lens{35., 600.};
    };
    const Answer& answer() const { return m_answer; }
    double fadeDistance() const { return distanceOfParallax(m_answer.figures, m_answer.depth, m_answer.lens); } // m
    bool busy() const { return m_background.busy() || m_rest.isActive(); }

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void changeEvent(QEvent*) override;

private:
    void stir();
    void measure();
    void take(const Answer& answer);
    void draw();
    void curve(const AngleFigures& at, std::size_t index);
    void upright(double distance, const QString& text, Qt::PenStyle style);
    const Document& m_document;
    const Assets& m_assets;
    const Viewport& m_viewport;
    Background m_background;
    QTimer m_rest;
    QLabel* m_line;
    QCustomPlot* m_plot;
    Answer m_answer;
    double m_from = 0.1, m_to = 100.; // m, of the axis
};

} // namespace relievo
