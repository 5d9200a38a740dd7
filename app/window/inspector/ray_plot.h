// The cross-section of the relief along a ray, with the steps of searches as the papers draw them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/ray_inspection.h"
#include "core/image/height_field.h"
#include <QWidget>
#include <optional>
#include <vector>

class QCPItemTracer;
class QCustomPlot;

namespace relievo {

class RayPlot : public QWidget {
    Q_OBJECT
public:
    explicit RayPlot(QWidget* parent = nullptr);

    struct Shown {
        RayInspection ray;
        QString name;
    };
    // The first ray's cross-section is drawn; `chosen` is the one whose boxes, cones and balls are. Nothing when empty.
    void show(const std::vector<Shown>& rays, const HeightField* field, std::size_t chosen);
    void mark(int step); // of the chosen ray; -1 for none
    void showAll(); // the part of the ray that the searches took
    QByteArray svg();
    static QColor colorOf(std::size_t pane, const QPalette& palette);

protected:
    void changeEvent(QEvent* event) override;

private:
    void rebuild();
    QPointF at(const RayInspection& ray, double t) const; // texels along, height
    void drawSurface();
    void drawArea(const RayInspection& ray, const SearchStep& step, double heightBefore, const QColor& color);
    void drawSteps(const Shown& shown, const QColor& color, bool chosen);
    void drawExact(const RayInspection& ray);

    QCustomPlot* m_plot;
    std::vector<Shown> m_rays;
    std::optional<HeightField> m_field;
    std::size_t m_chosen = 0;
    QCPItemTracer* m_mark = nullptr;
    int m_marked = -1;
};

} // namespace relievo
