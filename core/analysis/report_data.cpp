// The report as JSON and CSV.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/report.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace relievo {

namespace {

// The figures of rays, once, for JSON and CSV.
struct Column {
    const char* key;
    double (*of)(const SweepRow& row);
};
constexpr Column kRayColumns[] = {
    {"rays", [](const SweepRow& r) { return double(r.errors.rays); }},
    {"wrong", [](const SweepRow& r) { return double(r.errors.wrong()); }},
    {"ties", [](const SweepRow& r) { return double(r.errors.ties); }},
    {"meanFetches", [](const SweepRow& r) { return r.errors.meanFetches; }},
    {"p99Fetches", [](const SweepRow& r) { return r.errors.p99Fetches; }},
    {"maxFetches", [](const SweepRow& r) { return double(r.errors.maxFetches); }},
    {"meanBytes", [](const SweepRow& r) { return r.errors.meanBytes; }},
    {"overshootPercent", [](const SweepRow& r) { return 100. * r.errors.share(r.errors.tooDeep); }},
    {"shortPercent", [](const SweepRow& r) { return 100. * r.errors.share(r.errors.tooShort); }},
    {"notFoundPercent", [](const SweepRow& r) { return 100. * r.errors.share(r.errors.notFound); }},
    {"rmse", [](const SweepRow& r) { return r.errors.rmse; }},
    {"maxError", [](const SweepRow& r) { return r.errors.largest; }},
    {"rmseTexels", [](const SweepRow& r) { return r.errors.rmseTexels; }},
    {"maxErrorTexels", [](const SweepRow& r) { return r.errors.largestTexels; }},
    {"nan", [](const SweepRow& r) { return double(r.errors.invalid); }},
    {"bakeSeconds", [](const SweepRow& r) { return r.bakeSeconds; }},
    {"bytesPerTexel", [](const SweepRow& r) { return r.bytesPerTexel; }},
};
struct PictureColumn {
    const char* key;
    double PictureRow::*of;
};
constexpr PictureColumn kPictureColumns[] = {
    {"milliseconds", &PictureRow::milliseconds}, {"msRatio", &PictureRow::ratio}, {"psnr", &PictureRow::psnr}, {"flip", &PictureRow::flip}};

struct MeshColumn {
    const char* key;
    double (*of)(const MeshRow& row);
};
constexpr MeshColumn kMeshColumns[] = {
    {"coveragePercent", [](const MeshRow& r) { return 100. * r.coverage; }},
    {"depthRmsePixels", [](const MeshRow& r) { return r.depthRmse; }},
    {"invalidPixels", [](const MeshRow& r) { return r.invalid; }},
};

struct EngineColumn {
    const char* key;
    double EngineDrawing::*of;
};
constexpr EngineColumn kEngineColumns[]
    = {{"depthDrawn", &EngineDrawing::share}, {"meanError", &EngineDrawing::meanError}, {"tooHigh", &EngineDrawing::raised}};

struct FarColumn {
    const char* key;
    double (*of)(const FarErrors& errors);
};
constexpr FarColumn kFarColumns[] = {{"brightnessStops", [](const FarErrors& e) { return e.stops; }},
    {"lightRmsePercent", [](const FarErrors& e) { return 100. * e.rmse; }}};

// Where the columns of each begin in a line of the CSV.
constexpr std::size_t kPictures = std::size(kRayColumns), kEngines = kPictures + std::size(kPictureColumns),
                      kMesh = kEngines + std::size(kEngineColumns), kFar = kMesh + std::size(kMeshColumns),
                      kAllColumns = kFar + std::size(kFarColumns);

std::string number(double value)
{
    char buffer[40];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

std::string quoted(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == text.npos)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? "\"\"" : std::string(1, c);
    return out + '"';
}

nlohmann::ordered_json conditionsJson(const Report& report)
{
    nlohmann::ordered_json json{{"version", RELIEVO_VERSION}, {"raysPerBand", report.plan.rays}, {"seed", report.plan.seed},
        {"wrongAboveDepth", kWrongDepth}, {"wrongAboveTexels", kWrongTexels}, {"tieHeight", kTieHeight}};
    if (!report.angles.empty())
        json.update({{"renderer", report.renderer}, {"width", report.pictureWidth}, {"height", report.pictureHeight},
            {"comparedWith", report.exactLabel}});
    return json;
}

const std::string& fieldKey(const Report& report, std::size_t field)
{
    static const std::string all = "all fields";
    return field == kAllFields ? all : report.plan.fields[field].key;
}

// nlohmann writes infinities as null, which is what JSON can say of them.
nlohmann::ordered_json namesOf(const Report& report, std::size_t setting, std::size_t field)
{
    const SearchSetting& s = report.plan.settings[setting];
    return {{"technique", s.technique->key}, {"setting", s.label}, {"field", fieldKey(report, field)}};
}

nlohmann::ordered_json rayLines(const Report& report, std::span<const SweepRow> rows)
{
    auto lines = nlohmann::ordered_json::array();
    for (const SweepRow& row : rows) {
        auto line = namesOf(report, row.setting, row.field);
        line["fromDegrees"] = report.plan.bands[row.band].from;
        line["toDegrees"] = report.plan.bands[row.band].to;
        for (const Column& column : kRayColumns)
            line[column.key] = column.of(row);
        lines.push_back(std::move(line));
    }
    return lines;
}

nlohmann::ordered_json engineLines(const Report& report)
{
    auto lines = nlohmann::ordered_json::array();
    for (const EngineRow& row : report.engines) {
        nlohmann::ordered_json line{{"technique", row.technique->key}, {"engine", row.technique->engine},
            {"field", fieldKey(report, row.field)}, {"degrees", row.angle}};
        for (const EngineColumn& column : kEngineColumns)
            line[column.key] = row.drawing.*column.of;
        lines.push_back(std::move(line));
    }
    return lines;
}

nlohmann::ordered_json farJson(const FarSection& far)
{
    nlohmann::ordered_json json{{"field", far.field}, {"technique", far.technique}, {"width", far.width}, {"height", far.height},
        {"finer", far.finer}, {"rows", nlohmann::ordered_json::array()}};
    for (const FarRow& row : far.rows)
        for (std::size_t view = 0; view < far.views.size(); ++view) {
            nlohmann::ordered_json line{
                {"label", row.label}, {"degrees", far.views[view].angle}, {"texelsAPixel", far.views[view].texelsAPixel}};
            for (const FarColumn& column : kFarColumns)
                line[column.key] = column.of(row.errors[view]);
            json["rows"].push_back(std::move(line));
        }
    return json;
}
// Nothing where one field is all there is.
std::vector<SweepRow> totalsOf(const Report& report)
{
    return report.plan.fields.size() > 1 ? totals(report.plan, report.rows) : std::vector<SweepRow>();
}

} // namespace

std::string figure(double value)
{
    if (std::isnan(value))
        return "-";
    if (std::isinf(value))
        return value > 0. ? "inf" : "-inf";
    const double size = std::abs(value);
    if (size < 5e-7)
        return "0";
    if (size >= 1e15)
        return number(value);
    const int decimals = std::clamp(2 - int(std::floor(std::log10(size))), 0, 6);
    char buffer[64];
    std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr);
    if (size < 1e-4 && text.find('.') != text.npos) // mostly zeros: no false precision
        text.erase(text.find_last_not_of('0') + 1);
    return text;
}

std::string reportJson(const Report& report)
{
    nlohmann::ordered_json json{{"title", report.title}, {"conditions", conditionsJson(report)}};
    json["settings"] = nlohmann::ordered_json::array();
    for (const SearchSetting& s : report.plan.settings)
        json["settings"].push_back({{"technique", s.technique->key}, {"label", s.label}, {"parameters", parametersText(s)}});
    json["fields"] = nlohmann::ordered_json::array();
    for (const SweepField& f : report.plan.fields)
        json["fields"].push_back({{"key", f.key}, {"label", f.label}, {"width", f.heights.width()}, {"height", f.heights.height()},
            {"depth", double(float(f.depth))}});
    json["rays"] = rayLines(report, report.rows);
    json["totals"] = rayLines(report, totalsOf(report));
    json["pictures"] = nlohmann::ordered_json::array();
    for (const PictureRow& row : report.pictures) {
        auto line = namesOf(report, row.setting, row.field);
        line["degrees"] = report.angles[row.angle];
        for (const PictureColumn& column : kPictureColumns)
            line[column.key] = row.*column.of;
        json["pictures"].push_back(std::move(line));
    }
    json["engines"] = engineLines(report);
    if (const MeshSection& mesh = report.mesh; !mesh.name.empty()) {
        json["mesh"] = {{"name", mesh.name}, {"displacedTriangles", mesh.triangles}, {"depthMetres", mesh.depth}, {"views", mesh.views},
            {"width", mesh.width}, {"height", mesh.height}, {"rows", nlohmann::ordered_json::array()}};
        for (const MeshRow& row : mesh.rows) {
            nlohmann::ordered_json line{{"label", row.label}};
            for (const MeshColumn& column : kMeshColumns)
                line[column.key] = column.of(row);
            line["msRatio"] = row.ratio;
            json["mesh"]["rows"].push_back(std::move(line));
        }
        if (mesh.tangents)
            json["mesh"]["tangents"]
                = {{"corners", mesh.tangents->corners}, {"off", mesh.tangents->off}, {"worstDegrees", mesh.tangents->worst}};
    }
    if (!report.far.rows.empty())
        json["farViews"] = farJson(report.far);
    json["warnings"] = nlohmann::ordered_json::array();
    for (const Warning& warning : report.warnings)
        json["warnings"].push_back({{"code", warning.code}, {"text", warning.text}});
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

namespace {
std::string farName(const FarView& view)
{
    return "far " + number(view.angle) + " x" + number(view.texelsAPixel);
}

// A line: its names, and values of the columns from `first` on; the others stay empty.
std::string csvLine(const std::string& names, std::size_t first, const std::vector<std::string>& values)
{
    std::string line = names + std::string(first, ',');
    for (const std::string& value : values)
        line += ',' + value;
    return line + std::string(kAllColumns - first - values.size(), ',') + '\n';
}

std::string csvHead()
{
    std::string text = "technique,setting,field,view";
    const auto add = [&text](const auto& columns) {
        for (const auto& column : columns)
            text += std::string(",") + column.key;
    };
    add(kRayColumns), add(kPictureColumns), add(kEngineColumns), add(kMeshColumns), add(kFarColumns);
    return text + '\n';
}

// What was changed on the mesh and in far views: no technique's settings.
std::string csvOfChanges(const Report& report)
{
    std::string text;
    for (const MeshRow& row : report.mesh.rows) {
        std::vector<std::string> values;
        for (const PictureColumn& column : kPictureColumns)
            values.push_back(column.of == &PictureRow::ratio && std::isfinite(row.ratio) ? number(row.ratio) : "");
        values.resize(kMesh - kPictures);
        for (const MeshColumn& column : kMeshColumns)
            values.push_back(number(column.of(row)));
        text += csvLine(',' + quoted(row.label) + ',' + quoted(report.mesh.name) + ",mesh", kPictures, values);
    }
    for (const FarRow& row : report.far.rows)
        for (std::size_t view = 0; view < report.far.views.size(); ++view) {
            std::vector<std::string> values;
            for (const FarColumn& column : kFarColumns)
                values.push_back(number(column.of(row.errors[view])));
            text += csvLine(',' + quoted(row.label) + ',' + quoted(report.far.field) + ',' + farName(report.far.views[view]), kFar, values);
        }
    return text;
}
} // namespace

std::string reportCsv(const Report& report)
{
    std::string text = csvHead();
    const auto names = [&](std::size_t setting, std::size_t field) {
        const SearchSetting& s = report.plan.settings[setting];
        return std::string(s.technique->key) + ',' + quoted(s.label) + ',' + quoted(fieldKey(report, field)) + ',';
    };
    std::vector<SweepRow> rows = report.rows;
    std::ranges::copy(totalsOf(report), std::back_inserter(rows));
    for (const SweepRow& row : rows) {
        const AngleBand band = report.plan.bands[row.band];
        std::vector<std::string> values;
        for (const Column& column : kRayColumns)
            values.push_back(number(column.of(row)));
        text += csvLine(names(row.setting, row.field) + "rays " + number(band.from) + '-' + number(band.to), 0, values);
    }
    for (const PictureRow& row : report.pictures) {
        std::vector<std::string> values;
        for (const PictureColumn& column : kPictureColumns)
            values.push_back(number(row.*column.of));
        text += csvLine(names(row.setting, row.field) + "picture " + number(report.angles[row.angle]), kPictures, values);
    }
    for (const EngineRow& row : report.engines) {
        std::vector<std::string> values;
        for (const EngineColumn& column : kEngineColumns)
            values.push_back(number(row.drawing.*column.of));
        text += csvLine(std::string(row.technique->key) + ',' + quoted(std::string(row.technique->label)) + ','
                + quoted(fieldKey(report, row.field)) + ",engine " + number(row.angle),
            kEngines, values);
    }
    return text + csvOfChanges(report);
}

} // namespace relievo
