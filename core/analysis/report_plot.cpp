// Logarithmic plots drawn by hand.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/report_plot.h"
#include "core/analysis/report.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace relievo {

namespace {

// Okabe and Ito's palette, told apart by colour-blind readers too; the second of each pair is for dark pages.
constexpr std::array<std::array<const char*, 2>, 7> kColors = {{{"#0072b2", "#4aa8e0"}, {"#d55e00", "#f08a3c"}, {"#009e73", "#2cc79a"},
    {"#b0588c", "#e39ac4"}, {"#b37a00", "#e6b422"}, {"#444444", "#d0d0d0"}, {"#2f9fd8", "#8fd0f5"}}};
constexpr std::size_t kMarkers = 5;

constexpr double kLeft = 54, kRight = 18, kTop = 26, kBottom = 42;
constexpr double kZeroLine = 16; // room for the line marked 0 below the floor

std::string text(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1f", value);
    return buffer;
}

std::string marker(std::size_t style, double x, double y)
{
    const auto at = [&](double dx, double dy) { return text(x + dx) + ',' + text(y + dy) + ' '; };
    switch (style % kMarkers) {
    case 0:
        return "<circle cx='" + text(x) + "' cy='" + text(y) + "' r='3.6'";
    case 1:
        return "<rect x='" + text(x - 3.2) + "' y='" + text(y - 3.2) + "' width='6.4' height='6.4'";
    case 2:
        return "<path d='M" + at(0, -4.4) + 'L' + at(4.2, 3.2) + 'L' + at(-4.2, 3.2) + "Z'";
    case 3:
        return "<path d='M" + at(0, -4.6) + 'L' + at(4.6, 0) + 'L' + at(0, 4.6) + 'L' + at(-4.6, 0) + "Z'";
    default:
        return "<path d='M" + at(0, 4.4) + 'L' + at(4.2, -3.2) + 'L' + at(-4.2, -3.2) + "Z'";
    }
}

std::string styleClass(std::size_t style, bool dashed)
{
    return "s" + std::to_string(style % kColors.size()) + (dashed ? " dashed" : "");
}

double roundedOut(double value, bool up)
{
    const double power = std::pow(10., std::floor(std::log10(value)));
    const std::array<double, 4> steps = {1., 2., 5., 10.};
    if (up)
        return power * *std::ranges::find_if(steps, [&](double s) { return s * power >= value * 0.999; });
    return power * *std::ranges::find_if(steps.rbegin(), steps.rend(), [&](double s) { return s * power <= value * 1.001; });
}

struct Scale {
    PlotAxes axes;
    double width() const { return axes.large ? 632 : 310; }
    double height() const { return axes.large ? 400 : 262; }
    double right() const { return width() - kRight; }
    double bottom() const { return height() - kBottom; }
    double x(double value) const
    {
        const double share = std::log(std::clamp(value, axes.xFrom, axes.xTo) / axes.xFrom) / std::log(axes.xTo / axes.xFrom);
        return kLeft + share * (right() - kLeft);
    }
    double y(double value) const
    {
        if (!(value > axes.yFrom))
            return bottom();
        const double share = std::log(std::min(value, axes.yTo) / axes.yFrom) / std::log(axes.yTo / axes.yFrom);
        return bottom() - kZeroLine - share * (bottom() - kZeroLine - kTop);
    }
};

// 1, 2, 5 steps where they fit, else powers of ten.
std::vector<double> ticks(double from, double to)
{
    std::vector<double> values;
    const double decades = std::log10(to / from);
    for (double power = std::pow(10., std::floor(std::log10(from))); power <= to * 1.001; power *= 10.)
        for (const double step : {1., 2., 5.})
            if ((step == 1. || decades < 3.) && step * power >= from * 0.999 && step * power <= to * 1.001)
                values.push_back(step * power);
    return values;
}

std::string tickText(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    if (value > 0.9999e-4)
        return buffer;
    const int power = int(std::floor(std::log10(value) + 1e-9)), times = int(std::lround(value / std::pow(10., power)));
    return (times == 1 ? std::string() : std::to_string(times) + " · ") + "10<tspan dy='-4' font-size='8'>" + std::to_string(power)
        + "</tspan>";
}

std::string gridOf(const Scale& scale)
{
    std::string svg;
    const std::string bottom = text(scale.bottom()), right = text(scale.right());
    for (const double v : ticks(scale.axes.xFrom, scale.axes.xTo)) {
        const std::string x = text(scale.x(v));
        svg += "<line class='grid' x1='" + x + "' x2='" + x + "' y1='" + text(kTop) + "' y2='" + bottom + "'/><text x='" + x + "' y='"
            + text(scale.bottom() + 15) + "' text-anchor='middle'>" + tickText(v) + "</text>";
    }
    const auto row = [&](double at, const std::string& label) {
        const std::string y = text(at);
        svg += "<line class='grid' x1='" + text(kLeft) + "' x2='" + right + "' y1='" + y + "' y2='" + y + "'/><text x='" + text(kLeft - 7)
            + "' y='" + text(at + 3.6) + "' text-anchor='end'>" + label + "</text>";
    };
    for (const double v : ticks(scale.axes.yFrom, scale.axes.yTo))
        if (scale.y(v) < scale.bottom() - kZeroLine + 0.5 && v > scale.axes.yFrom * 1.001)
            row(scale.y(v), tickText(v));
    row(scale.bottom(), "0");
    return svg;
}

} // namespace

PlotAxes axesFor(const std::vector<std::vector<PlotCurve>>& plots, double floor, std::string xLabel, std::string yLabel)
{
    double least = 1e300, most = 0., high = 10. * floor;
    std::ptrdiff_t drawn = 0;
    for (const auto& curves : plots)
        drawn = std::max(drawn, std::ranges::count_if(curves, [](const PlotCurve& curve) { return !curve.points.empty(); }));
    const bool large = drawn > 8;
    for (const auto& curves : plots)
        for (const PlotCurve& curve : curves)
            for (const PlotPoint& point : curve.points) {
                least = std::min(least, point.x), most = std::max(most, point.x);
                high = std::isfinite(point.y) ? std::max(high, point.y) : high;
            }
    if (!(least > 0.) || most <= 0.)
        least = most = 1.;
    return {roundedOut(least * 0.8, false), roundedOut(std::max(most, least * 2.) * 1.1, true), floor, roundedOut(high * 1.05, true),
        std::move(xLabel), std::move(yLabel), large};
}

std::string plotSvg(const std::string& title, const PlotAxes& axes, const std::vector<PlotCurve>& curves)
{
    const Scale scale{axes};
    std::string svg = "<svg class='plot' viewBox='0 0 " + text(scale.width()) + ' ' + text(scale.height()) + "' role='img' aria-label='"
        + escaped(title) + "'><text class='title' x='" + text(kLeft) + "' y='14'>" + escaped(title) + "</text>" + gridOf(scale);
    svg += "<text x='" + text(0.5 * (kLeft + scale.right())) + "' y='" + text(scale.height() - 10) + "' text-anchor='middle'>"
        + escaped(axes.xLabel) + "</text><text transform='translate(12 " + text(0.5 * (kTop + scale.bottom()))
        + ") rotate(-90)' text-anchor='middle'>" + escaped(axes.yLabel) + "</text>";
    for (const PlotCurve& curve : curves) {
        svg += "<g class='" + styleClass(curve.style, curve.dashed) + "'>";
        if (curve.points.size() > 1) {
            svg += "<polyline points='";
            for (const PlotPoint& point : curve.points)
                svg += text(scale.x(point.x)) + ',' + text(scale.y(point.y)) + ' ';
            svg += "'/>";
        }
        for (const PlotPoint& point : curve.points)
            svg += marker(curve.style, scale.x(point.x), scale.y(point.y)) + "><title>" + escaped(point.label) + "</title></"
                + (curve.style % kMarkers == 0        ? "circle"
                        : curve.style % kMarkers == 1 ? "rect"
                                                      : "path")
                + '>';
        svg += "</g>";
    }
    return svg + "</svg>\n";
}

std::string legendSvg(std::size_t style, bool dashed)
{
    return "<svg class='key' viewBox='0 0 28 12'><g class='" + styleClass(style, dashed) + "'><polyline points='1,6 27,6'/>"
        + marker(style, 14, 6) + "/></g></svg>";
}

std::string plotCss()
{
    std::string light, dark;
    for (std::size_t i = 0; i < kColors.size(); ++i) {
        light += ".s" + std::to_string(i) + "{--c:" + kColors[i][0] + "}";
        dark += ".s" + std::to_string(i) + "{--c:" + kColors[i][1] + "}";
    }
    return light + "@media screen and (prefers-color-scheme:dark){" + dark + "}";
}

std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text)
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '\'':
            out += "&#39;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    return out;
}

} // namespace relievo
