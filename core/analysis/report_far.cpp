// The report's table of far views.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/report.h"
#include "core/analysis/report_plot.h"

namespace relievo {

std::string farHtml(const Report& report)
{
    const FarSection& far = report.far;
    if (far.rows.empty())
        return {};
    std::string html = "<h2>Far away</h2><p>" + escaped(far.field) + ", " + escaped(far.technique)
        + ", lit, at these angles from the normal and so far that a pixel is as wide as this many texels; against the same view of "
        + std::to_string(far.finer) + " \u00d7 " + std::to_string(far.finer)
        + " times as many pixels, unfiltered and averaged. Brightness: of the whole picture, stops; below 0 it is too dark. RMSE: of the "
          "pixels\u2019 light, percent of its mean.</p><div class='scroll'><table><tr><th rowspan='2'>Filters</th>";
    for (const FarView& view : far.views)
        html += "<th class='band' colspan='2'>" + figure(view.angle) + "\u00b0, \u00d7 " + figure(view.texelsAPixel) + "</th>";
    html += "</tr><tr>";
    for (std::size_t i = 0; i < far.views.size(); ++i)
        html += "<th class='first'>Brightness</th><th>RMSE</th>";
    html += "</tr>\n";
    for (const FarRow& row : far.rows) {
        html += "<tr><td>" + escaped(row.label) + "</td>";
        for (const FarErrors& errors : row.errors)
            html += "<td class='first'>" + figure(errors.stops) + "</td><td>" + figure(100. * errors.rmse) + "</td>";
        html += "</tr>\n";
    }
    return html + "</table></div>\n";
}

} // namespace relievo
