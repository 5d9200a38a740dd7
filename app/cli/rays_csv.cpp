// CSV of rays and hits.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/rays_csv.h"
#include "core/ground/file.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace relievo::cli {

namespace {

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

// The numbers of a line; nothing when a field is no number or their count is not `count`.
std::optional<std::vector<double>> numbers(std::string_view line, std::size_t count)
{
    std::vector<double> values;
    for (bool more = true; more;) {
        const std::size_t comma = line.find(',');
        std::string_view field = trimmed(line.substr(0, comma));
        if (field.starts_with('+'))
            field.remove_prefix(1);
        double value = 0.;
        const auto [end, code] = std::from_chars(field.data(), field.data() + field.size(), value);
        if (field.empty() || end != field.data() + field.size() || code == std::errc::invalid_argument)
            return {};
        if (code == std::errc::result_out_of_range) // too large for a double, or too small
            value = field.find("e-") != field.npos || field.find("E-") != field.npos ? 0. : HUGE_VAL;
        values.push_back(value);
        more = comma != line.npos;
        line.remove_prefix(more ? comma + 1 : 0);
    }
    if (values.size() != count)
        return {};
    return values;
}

void append(std::string& text, double value)
{
    char buffer[32];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

} // namespace

double cosineOf(const SearchRay& ray, double depth)
{
    const double length = std::hypot(depth, std::hypot(ray.duv.x, ray.duv.y));
    const double cosine = length > 0. && std::isfinite(length) ? depth / length : 1.;
    return std::max(cosine, 1e-6);
}

Expected<RaysRead> readRays(const std::filesystem::path& file, double depth)
{
    const auto text = readText(file);
    if (!text)
        return tl::unexpected(text.error());
    std::string_view rest = *text;
    if (rest.starts_with("\xEF\xBB\xBF"))
        rest.remove_prefix(3);
    const auto nextLine = [&rest] {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return line;
    };
    const std::string_view header = nextLine();
    if (header != "u,v,du,dv" && header != "u,v,du,dv,cosView")
        return failure(file.string(), "the first line is not u,v,du,dv or u,v,du,dv,cosView", "Write that header");
    const std::size_t columns = header.ends_with("cosView") ? 5 : 4;
    RaysRead read;
    std::size_t outside = 0, firstOutside = 0; // cosines
    for (std::size_t line = 2; !rest.empty(); ++line) {
        const std::string_view content = nextLine();
        if (content.empty())
            continue;
        const auto values = numbers(content, columns);
        if (!values)
            return failure(file.string() + ':' + std::to_string(line), "this line is not " + std::to_string(columns) + " numbers",
                "Separate them by commas");
        SearchRay ray{{(*values)[0], (*values)[1]}, {(*values)[2], (*values)[3]}, 1.};
        ray.cosView = columns == 5 ? std::clamp((*values)[4], 1e-6, 1.) : cosineOf(ray, depth);
        if (columns == 5 && ((*values)[4] <= 0. || (*values)[4] > 1.) && outside++ == 0)
            firstOutside = line;
        if (!std::isfinite(ray.cosView)) // such a ray is not finite either
            ray.uv.x = ray.cosView;
        read.rays.push_back(ray);
    }
    if (outside > 0)
        read.warnings.push_back({"cosine-range",
            file.string() + ':' + std::to_string(firstOutside) + ": cosView lies outside (0, 1], and was brought into it ("
                + std::to_string(outside) + (outside == 1 ? " ray" : " rays")
                + "). It is the cosine of the angle between view and normal."});
    return read;
}

std::string hitsText(std::span<const SearchHit> hits)
{
    std::string text = "hit,t,u,v,fetches\n";
    text.reserve(hits.size() * 48);
    for (const SearchHit& hit : hits) {
        text += hit.isUnfinished ? "-1," : hit.found ? "1," : "0,";
        append(text, hit.t);
        text += ',';
        append(text, hit.uv.x);
        text += ',';
        append(text, hit.uv.y);
        text += ',';
        append(text, hit.fetches);
        text += '\n';
    }
    return text;
}

} // namespace relievo::cli
