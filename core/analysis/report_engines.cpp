// The report's table of what engines draw.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/report.h"
#include "core/analysis/report_plot.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {

std::string tableHead()
{
    std::string html = "<div class='scroll'><table><tr><th rowspan='2'>Engine</th>";
    for (const double angle : kEngineAngles)
        html += "<th class='band' colspan='2'>" + std::to_string(std::lround(angle)) + "\u00b0</th>";
    html += "<th rowspan='2' class='first'>Too high</th></tr><tr>";
    for (std::size_t i = 0; i < kEngineAngles.size(); ++i)
        html += "<th class='first'>Depth drawn, %</th><th>Mean error</th>";
    return html + "</tr>\n";
}

std::string tableRow(const Report& report, const TechniqueRow& technique)
{
    std::string html = "<tr><td>" + escaped(std::string(technique.label)) + "</td>";
    double raised = 0.;
    for (const double angle : kEngineAngles) {
        double share = 0., error = 0., count = 0.;
        for (const EngineRow& row : report.engines)
            if (row.technique == &technique && row.angle == angle) {
                share += row.drawing.share, error += row.drawing.meanError, count += 1.;
                raised = row.drawing.raised;
            }
        count = std::max(count, 1.);
        html += "<td class='first'>" + figure(100. * share / count) + "</td><td>" + figure(error / count) + "</td>";
    }
    return html + "<td class='first'>" + figure(raised) + "</td></tr>\n";
}

} // namespace

std::string enginesHtml(const Report& report)
{
    if (report.engines.empty())
        return {};
    std::string html = "<h2>As engines draw it</h2><p>By their published formulas, given this depth, at these angles from the normal"
        + std::string(report.plan.fields.size() > 1 ? "; means over all fields" : "")
        + ". Depth drawn: what is seen of the relief's depth. Mean error: between the depth drawn and the exact one, share of the depth, "
          "with the "
          "height that the engine puts on its mesh lying there in both. Too high: by how much the whole lies above where the midlevel has "
          "it, "
          "share of the depth.</p>"
        + tableHead();
    std::vector<const TechniqueRow*> techniques;
    for (const EngineRow& row : report.engines)
        if (!std::ranges::count(techniques, row.technique))
            techniques.push_back(row.technique);
    for (const TechniqueRow* technique : techniques)
        html += tableRow(report, *technique);
    return html + "</table></div>\n";
}

} // namespace relievo
