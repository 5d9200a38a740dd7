// The report as one HTML page: plots, tables, heat maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/report.h"
#include "core/analysis/report_plot.h"
#include "core/analysis/report_style.h"
#include "core/ground/base64.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

namespace relievo {

namespace {

// Below these, errors are drawn and printed as none: float rounding, and less than a ray in the whole set.
constexpr double kRmseFloor = 1e-5, kPercentFloor = 0.01, kFlipFloor = 1e-4;

// As it was given: "60", "89.9".
std::string degrees(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
}

std::string cell(const std::string& text, const char* kind = "")
{
    return *kind ? std::string("<td class='") + kind + "'>" + text + "</td>" : "<td>" + text + "</td>";
}

std::string percent(double share)
{
    const double value = 100. * share;
    if (value == 0.)
        return "0";
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, value < 0.095 ? "%.2f" : value < 9.95 ? "%.1f" : "%.0f", value);
    return buffer;
}

// Curves join the settings of one series; those that read nothing have no place on a logarithmic axis.
class Series {
public:
    explicit Series(const Report& report)
    {
        std::vector<const TechniqueRow*> techniques;
        for (const SearchSetting& s : report.plan.settings) {
            if (!std::ranges::count(techniques, s.technique))
                techniques.push_back(s.technique);
            const auto style = std::size_t(std::ranges::find(techniques, s.technique) - techniques.begin());
            if (std::ranges::find(m_names, s.series) == m_names.end()) {
                m_names.push_back(s.series);
                m_styles.push_back({style, s.series != s.technique->label, {}});
            }
        }
    }
    // y and x of a setting; a setting whose x is not positive is left out.
    template <class X, class Y> std::vector<PlotCurve> curves(const Report& report, X x, Y y) const
    {
        std::vector<PlotCurve> curves = m_styles;
        for (std::size_t i = 0; i < report.plan.settings.size(); ++i) {
            const auto at = std::size_t(std::ranges::find(m_names, report.plan.settings[i].series) - m_names.begin());
            if (x(i) > 0.)
                curves[at].points.push_back({x(i), y(i), report.plan.settings[i].label + ": " + figure(x(i)) + ", " + figure(y(i))});
        }
        return curves;
    }
    std::string legend(const std::vector<std::vector<PlotCurve>>& plots) const
    {
        std::string html = "<ul class='legend'>";
        for (std::size_t i = 0; i < m_names.size(); ++i)
            if (std::ranges::any_of(plots, [&](const auto& curves) { return !curves[i].points.empty(); }))
                html += "<li>" + legendSvg(m_styles[i].style, m_styles[i].dashed) + escaped(m_names[i]) + "</li>";
        return html + "</ul>\n";
    }

private:
    std::vector<std::string> m_names;
    std::vector<PlotCurve> m_styles;
};

std::string plotRow(const std::vector<std::string>& titles, const std::vector<std::vector<PlotCurve>>& plots, const PlotAxes& axes)
{
    constexpr std::array<const char*, 5> kColumns = {"", " one", " two", " three", " four"};
    const std::size_t count = titles.size();
    const char* const columns = axes.large ? " large" : count % 4 == 0 ? kColumns[4] : count < 4 ? kColumns[count] : "";
    std::string html = std::string("<div class='plots") + columns + "'>\n";
    for (std::size_t i = 0; i < plots.size(); ++i)
        html += plotSvg(titles[i], axes, plots[i]);
    return html + "</div>\n";
}

class Page {
public:
    explicit Page(const Report& report) : m_report(report), m_plan(report.plan), m_series(report)
    {
        for (std::size_t s = 0; s < m_plan.settings.size(); ++s)
            for (std::size_t b = 0; b < m_plan.bands.size(); ++b)
                m_all.push_back(overFields(report.rows, s, b));
    }

    std::string text() const
    {
        std::string html = "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
                           "content='width=device-width,initial-scale=1'><title>Speed against error: "
            + escaped(m_report.title) + "</title><style>" + kReportStyle + plotCss() + "</style></head><body>\n";
        html += head() + rayPlots() + overview() + pictureSection() + enginesHtml(m_report) + meshSection() + farHtml(m_report)
            + heatSection() + details();
        return html + "</body></html>\n";
    }

private:
    const HitErrors& all(std::size_t setting, std::size_t band) const { return m_all[setting * m_plan.bands.size() + band]; }

    std::string head() const
    {
        std::string html = "<h1>Speed against error</h1><p class='lead'>" + escaped(m_report.title) + "</p><p>";
        html += std::to_string(m_plan.settings.size()) + " settings, " + std::to_string(m_plan.fields.size()) + " height field"
            + (m_plan.fields.size() == 1 ? "" : "s");
        if (m_plan.fields.size() == 1)
            html += " of " + std::to_string(m_plan.fields[0].heights.width()) + " \u00d7 "
                + std::to_string(m_plan.fields[0].heights.height()) + " texels, depth " + figure(m_plan.fields[0].depth) + " of the tile";
        html += "; " + std::to_string(m_plan.rays) + " rays in each band of viewing angles (from the normal), seed "
            + std::to_string(m_plan.seed)
            + ". Each ray is compared with the exact first hit on the bilinear surface, in double precision. A hit is wrong when it is off "
              "by "
              "more than 0.002 of the depth and more than half a texel; ties, where moving the surface by 0.0001 decides, are counted "
              "apart.</p>";
        for (const Warning& warning : m_report.warnings)
            html += "<p>Note: " + escaped(warning.text) + "</p>";
        return html;
    }

    std::string rayPlots() const
    {
        std::vector<std::string> titles;
        std::vector<std::vector<PlotCurve>> rmse, wrong;
        for (std::size_t band = 0; band < m_plan.bands.size(); ++band) {
            titles.push_back(bandTitle(band));
            const auto fetches = [&](std::size_t s) { return all(s, band).meanFetches; };
            rmse.push_back(m_series.curves(m_report, fetches, [&](std::size_t s) { return all(s, band).rmse; }));
            wrong.push_back(m_series.curves(m_report, fetches, [&](std::size_t s) { return 100. * all(s, band).wrongShare(); }));
        }
        std::string html = "<h2>Fetches against error</h2><p>Left and low is better. One curve a technique, one point a setting"
            + std::string(m_plan.fields.size() > 1 ? "; over all fields together" : "") + ".</p>" + m_series.legend(rmse);
        html += "<h3>RMSE of the depth found, share of the relief's depth</h3>"
            + plotRow(titles, rmse, axesFor(rmse, kRmseFloor, "mean fetches a ray", "RMSE"));
        html += "<h3>Wrong hits, percent of the rays</h3>"
            + plotRow(titles, wrong, axesFor(wrong, kPercentFloor, "mean fetches a ray", "wrong, %"));
        return html;
    }

    std::string bandTitle(std::size_t band) const
    {
        return degrees(m_plan.bands[band].from) + "\u2013" + degrees(m_plan.bands[band].to) + "\u00b0";
    }

    std::string overview() const
    {
        std::string html = "<h2>Overview</h2><p>Mean fetches a ray, wrong hits in percent and RMSE of the depth in each band"
            + std::string(m_plan.fields.size() > 1 ? ", over all fields" : "")
            + ". Tinted: no wrong hit at all. Bake: seconds for the map that the technique searches with; bytes a texel: height and that "
              "map.</p><div class='scroll'><table><tr><th rowspan='2'>Setting</th>";
        for (std::size_t band = 0; band < m_plan.bands.size(); ++band)
            html += "<th class='band' colspan='3'>" + bandTitle(band) + "</th>";
        html += "<th rowspan='2' class='first'>Bake, s</th><th rowspan='2'>Bytes/texel</th></tr><tr>";
        for (std::size_t band = 0; band < m_plan.bands.size(); ++band)
            html += "<th class='first'>Fetches</th><th>Wrong</th><th>RMSE</th>";
        html += "</tr>\n";
        for (std::size_t s = 0; s < m_plan.settings.size(); ++s) {
            html += startOfRow(s);
            for (std::size_t band = 0; band < m_plan.bands.size(); ++band) {
                const HitErrors& e = all(s, band);
                html += cell(figure(e.meanFetches), "first")
                    + cell(percent(e.wrongShare()), e.rays > 0 && e.wrong() + e.invalid == 0 ? "none" : "") + cell(error(e.rmse));
            }
            const auto [seconds, bytes] = costOf(s);
            html += cell(seconds > 0. ? figure(seconds) : "\u2013", "first") + cell(figure(bytes)) + "</tr>\n";
        }
        return html + "</table></div>\n";
    }

    // Opens a row; a rule above where another technique begins.
    std::string startOfRow(std::size_t setting) const
    {
        const bool begins = setting > 0 && m_plan.settings[setting].technique != m_plan.settings[setting - 1].technique;
        return std::string(begins ? "<tr class='top'>" : "<tr>") + cell(escaped(m_plan.settings[setting].label));
    }

    static std::string error(double value) { return value < kRmseFloor ? "0" : figure(value); }

    std::pair<double, double> costOf(std::size_t setting) const
    {
        double seconds = 0., bytes = 0., count = 0.;
        for (const SweepRow& row : m_report.rows)
            if (row.setting == setting && row.band == 0)
                seconds += row.bakeSeconds, bytes += row.bytesPerTexel, count += 1.;
        return {seconds / std::max(count, 1.), bytes / std::max(count, 1.)};
    }

    struct PictureMean {
        double ratio = 0., flip = 0., psnr = 0., count = 0., finite = 0.;
    };
    // Over the fields: geometric mean of the ratios, mean of FLIP, mean of the PSNR where pictures differ.
    PictureMean pictureMean(std::size_t setting, std::size_t angle) const
    {
        PictureMean mean;
        for (const PictureRow& row : m_report.pictures) {
            if (row.setting != setting || row.angle != angle)
                continue;
            mean.count += 1., mean.ratio += std::log(std::max(row.ratio, 1e-6)), mean.flip += row.flip;
            if (std::isfinite(row.psnr))
                mean.psnr += row.psnr, mean.finite += 1.;
        }
        mean.ratio = std::exp(mean.ratio / std::max(mean.count, 1.)), mean.flip /= std::max(mean.count, 1.);
        mean.psnr /= std::max(mean.finite, 1.);
        return mean;
    }

    // Which fields are pictured, where not all are.
    std::string picturedText() const
    {
        std::string names;
        std::size_t count = 0;
        for (std::size_t field = 0; field < m_plan.fields.size(); ++field)
            if (std::ranges::count(m_report.pictures, field, &PictureRow::field) > 0)
                names += (count++ ? ", " : "") + m_plan.fields[field].label;
        return count < m_plan.fields.size() ? "Means over " + escaped(names) + ". " : "";
    }

    std::string pictureSection() const
    {
        if (m_report.angles.empty())
            return {};
        std::vector<std::string> titles;
        std::vector<std::vector<PlotCurve>> plots;
        for (std::size_t angle = 0; angle < m_report.angles.size(); ++angle) {
            titles.push_back(degrees(m_report.angles[angle]) + "\u00b0");
            plots.push_back(m_series.curves(
                m_report, [&](std::size_t s) { return pictureMean(s, angle).ratio; },
                [&](std::size_t s) { return pictureMean(s, angle).flip; }));
        }
        std::string html = "<h2>Pictures</h2><p>" + picturedText() + "A plane that fills " + std::to_string(m_report.pictureWidth)
            + " \u00d7 " + std::to_string(m_report.pictureHeight) + " pixels, seen at these angles from its normal, drawn by "
            + escaped(m_report.renderer)
            + ". Time: the search with one colour lookup (or its depth shown, where there is no colour map), as a multiple of the same "
              "plane as a plain textured quad; frames interleaved, "
              "median. "
              "FLIP and PSNR: the lit picture against "
            + escaped(m_report.exactLabel) + ".</p>" + m_series.legend(plots);
        html += plotRow(titles, plots, axesFor(plots, kFlipFloor, "time, \u00d7 plain quad", "mean FLIP"));
        html += "<div class='scroll'><table><tr><th rowspan='2'>Setting</th>";
        for (const std::string& title : titles)
            html += "<th class='band' colspan='3'>" + title + "</th>";
        html += "</tr><tr>";
        for (std::size_t i = 0; i < titles.size(); ++i)
            html += "<th class='first'>Time, \u00d7</th><th>PSNR, dB</th><th>FLIP</th>";
        html += "</tr>\n";
        for (std::size_t s = 0; s < m_plan.settings.size(); ++s) {
            html += startOfRow(s);
            for (std::size_t angle = 0; angle < titles.size(); ++angle) {
                const PictureMean mean = pictureMean(s, angle);
                html += cell(figure(mean.ratio), "first") + cell(mean.finite > 0. ? figure(mean.psnr) : "equal") + cell(figure(mean.flip));
            }
            html += "</tr>\n";
        }
        return html + "</table></div>\n";
    }

    static std::string scaleOf(const std::string& title, double range)
    {
        std::string gradient;
        for (int i = 0; i <= 10; ++i) {
            const glm::vec3 c = heatColor(float(i) / 10.f) * 255.f;
            gradient += ",rgb(" + std::to_string(std::lround(c.r)) + ' ' + std::to_string(std::lround(c.g)) + ' '
                + std::to_string(std::lround(c.b)) + ')';
        }
        return "<div class='scale'>" + title + "<i style='background:linear-gradient(90deg" + gradient
            + ");print-color-adjust:exact'></i><div><span>0</span><span>" + degrees(0.5 * range) + "</span><span>" + degrees(range)
            + " and more</span></div></div>";
    }

    std::string meshSection() const
    {
        const MeshSection& mesh = m_report.mesh;
        if (mesh.name.empty())
            return {};
        std::string html = "<h2>On the mesh</h2><p>" + escaped(mesh.name) + ", relief " + figure(1000. * mesh.depth)
            + " mm deep, searched exactly, against the displaced mesh itself (" + std::to_string(mesh.triangles) + " micro-triangles): "
            + std::to_string(mesh.views) + " views of " + std::to_string(mesh.width) + " \u00d7 " + std::to_string(mesh.height)
            + " pixels. Outline: pixels that only one of the two covers, percent of those that either covers. Depth: RMSE of the distance "
              "to "
              "the eye, in pixels' sizes there. Time: of a shaded frame, ratio to the first row in one run.</p><div class='scroll'><table>"
              "<tr><th>Changed</th><th>Outline, %</th><th>Depth, px</th><th>NaN</th><th>Time</th></tr>\n";
        for (const MeshRow& row : mesh.rows)
            html += "<tr>" + cell(escaped(row.label)) + cell(figure(100. * row.coverage)) + cell(figure(row.depthRmse))
                + cell(figure(row.invalid)) + cell(figure(row.ratio)) + "</tr>\n";
        html += "</table></div>\n";
        if (mesh.tangents)
            html += "<p>Tangents of the file against MikkTSpace\u2019s: " + std::to_string(mesh.tangents->off) + " of "
                + std::to_string(mesh.tangents->corners) + " corners differ by more than " + figure(kTangentTolerance)
                + "\u00b0; the worst by " + figure(mesh.tangents->worst) + "\u00b0.</p>\n";
        return html;
    }

    std::string heatSection() const
    {
        if (m_report.heats.empty())
            return {};
        std::string html = "<h2>Where it costs and where it errs</h2><p>" + escaped(m_report.heatField) + " seen at "
            + degrees(m_report.heatView.angle)
            + "\u00b0 from its normal, one ray a pixel. Above: fetches. Below: distance of the depth found from "
              "the exact one, share of the depth.</p><div class='scales'>"
            + scaleOf("Fetches", m_report.heatView.fetchRange) + scaleOf("Error of the depth", m_report.heatView.errorRange)
            + "</div><div class='heats'>\n";
        for (const HeatRow& row : m_report.heats) {
            const auto image = [&](const std::vector<std::byte>& png, const char* what) {
                return "<img alt='" + escaped(row.label) + ": " + what + "' src='data:image/png;base64," + base64(png) + "'>";
            };
            html += "<figure>" + image(row.fetches, "fetches") + image(row.error, "error") + "<figcaption><b>" + escaped(row.label)
                + "</b><span>" + figure(row.meanFetches) + " fetches, error " + error(row.meanError)
                + " (means)</span></figcaption></figure>\n";
        }
        return html + "</div>\n";
    }

    std::string details() const
    {
        std::string html = "<h2>All figures</h2><p>Bytes: what the fetches of a ray return, mean. Overshoot: wrong and past the first hit. "
                           "Short: wrong and before it. Not found: the search gave "
                           "up. RMSE and the largest error of the depth (share of the depth) and sideways in texels.</p>\n";
        for (std::size_t field = 0; field < m_plan.fields.size(); ++field) {
            const SweepField& f = m_plan.fields[field];
            html += std::string("<details") + (m_plan.fields.size() == 1 ? " open" : "") + "><summary>" + escaped(f.label) + "<span>"
                + std::to_string(f.heights.width()) + " \u00d7 " + std::to_string(f.heights.height()) + ", depth " + figure(f.depth)
                + "</span></summary><div "
                  "class='scroll'><table><tr><th>Setting</th><th>Angles</th><th>Fetches</th><th>p99</th><th>Most</th><th>Bytes</th>"
                  "<th>Overshoot, %</th><th>Short, %</th><th>Not found, %</th><th>RMSE</th><th>Largest</th><th>RMSE, texels</th>"
                  "<th>Largest, texels</th><th>NaN</th><th>Ties</th></tr>\n";
            for (const SweepRow& row : m_report.rows)
                if (row.field == field)
                    html += detailRow(row);
            html += "</table></div></details>\n";
        }
        return html;
    }

    std::string detailRow(const SweepRow& row) const
    {
        const HitErrors& e = row.errors;
        std::string html = row.band == 0 && row.setting > 0 ? "<tr class='top'>" : "<tr>";
        html += cell(row.band == 0 ? escaped(m_plan.settings[row.setting].label) : "") + cell(bandTitle(row.band))
            + cell(figure(e.meanFetches)) + cell(figure(e.p99Fetches)) + cell(std::to_string(e.maxFetches)) + cell(figure(e.meanBytes));
        for (const std::size_t count : {e.tooDeep, e.tooShort, e.notFound})
            html += cell(percent(e.share(count)));
        html += cell(error(e.rmse)) + cell(error(e.largest)) + cell(figure(e.rmseTexels)) + cell(figure(e.largestTexels));
        return html + cell(std::to_string(e.invalid)) + cell(std::to_string(e.ties)) + "</tr>\n";
    }

    const Report& m_report;
    const SweepPlan& m_plan;
    Series m_series;
    std::vector<HitErrors> m_all; // setting x band
};

} // namespace

std::string reportHtml(const Report& report)
{
    return Page(report).text();
}

} // namespace relievo
