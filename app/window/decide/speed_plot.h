// Speed against error as points, one a setting: curves join those of one technique, a line the ones that nothing beats.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/decide/live_sweep.h"
#include "core/analysis/decide/front.h"
#include <QWidget>

class QCPItemText;
class QCPItemTracer;
class QCustomPlot;

namespace relievo {

// Logarithmic both ways. What has no error, or costs nothing, stands at the edge.
class SpeedPlot : public QWidget {
    Q_OBJECT
public:
    explicit SpeedPlot(QWidget* parent = nullptr);
    void show(const std::vector<MeasuredSetting>& points, const FigureRow& cost, const FigureRow& error);
    QPointF placeOf(std::size_t point) const; // px of this widget
    const std::vector<std::size_t>& front() const { return m_front; }

Q_SIGNALS:
    void hovered(int point); // index, -1 for none
    void chosen(int point);

protected:
    void changeEvent(QEvent* event) override;

private:
    void rebuild();
    void drawSeries(const std::vector<std::size_t>& points);
    void drawFront();
    void drawPresent();
    double leastOf(double none, double CostAndError::*value) const;
    void setRanges();
    void point(QPointF at);
    int nearest(QPointF at) const;
    CostAndError place(std::size_t point) const; // as drawn
    QColor colorOf(const TechniqueRow& technique) const;

    QCustomPlot* m_plot;
    QCPItemTracer* m_mark = nullptr;
    QCPItemText* m_name = nullptr;
    std::vector<MeasuredSetting> m_points;
    std::vector<CostAndError> m_values; // of them
    std::vector<std::size_t> m_front;
    double m_leastCost = 1., m_leastError = 1e-3; // where what has none is drawn
    int m_hovered = -1;
};

} // namespace relievo
