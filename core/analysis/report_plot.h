// Plots of a report as inline SVG: curves of points on logarithmic axes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace relievo {

struct PlotPoint {
    double x, y; // y at or below the plot's floor is drawn on the line marked 0
    std::string label; // shown by the browser when the pointer rests on it
};
struct PlotCurve {
    std::size_t style; // colour and marker; equal styles look equal in every plot
    bool dashed;
    std::vector<PlotPoint> points;
};
// Small multiples share their axes: both ranges are given.
struct PlotAxes {
    double xFrom, xTo, yFrom, yTo; // > 0; yFrom is the floor
    std::string xLabel, yLabel;
    bool large = false; // for more curves than a small plot can tell apart
};
// Axes that hold every point of these plots, rounded outwards to 1, 2 or 5 times a power of ten.
PlotAxes axesFor(const std::vector<std::vector<PlotCurve>>& plots, double floor, std::string xLabel, std::string yLabel);

std::string plotSvg(const std::string& title, const PlotAxes& axes, const std::vector<PlotCurve>& curves);
// A short piece of a curve with its marker, for the legend.
std::string legendSvg(std::size_t style, bool dashed);
// The rules that colour the styles, for the page's style sheet; light and dark.
std::string plotCss();

std::string escaped(const std::string& text); // for HTML and SVG

} // namespace relievo
