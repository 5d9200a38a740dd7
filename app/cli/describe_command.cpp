// relievo describe: the tables, as text, markdown or JSON.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions.h"
#include "app/cli/command.h"
#include "app/cli/describe_parameters.h"
#include "core/exporters/exporters.h"
#include "core/maps/maps.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {
using Json = nlohmann::ordered_json;

namespace {

Table techniques()
{
    Table table;
    const auto add = [&table](const TechniqueRow& row) {
        table.push_back({{"key", row.key}, {"label", row.label}, {"group", row.group()}, {"maps", keysOf(row.maps)},
            {"bound", row.accelerationMap}, {"parameters", keysOf(row.parameters)}, {"displaces", row.displaces},
            {"searches", row.searches}, {"canMiss", row.canMiss}, {"isExact", row.isExact}, {"paper", row.paper}, {"help", row.help}});
    };
    std::ranges::for_each(kTechniques, add);
    std::ranges::for_each(kObjectTechniques, add);
    return table;
}

Table maps()
{
    Table table;
    for (const BakedMapRow& row : kBakedMaps)
        table.push_back({{"key", row.key}, {"label", row.label}, {"unit", row.unit}, {"channels", row.channels}, {"help", row.help}});
    return table;
}

Table views()
{
    Table table;
    for (const ViewRow& row : kViews)
        table.push_back({{"key", row.key}, {"label", row.label}, {"unit", row.unit}, {"heat", row.isHeat}, {"help", row.help}});
    return table;
}

// "white is high, white on the surface".
std::string heightOf(const EngineFacts& engine)
{
    if (engine.property.empty())
        return "-";
    char zero[32];
    std::snprintf(zero, sizeof zero, "%g", double(engine.zero));
    return std::string(wordOf(engine.channel)) + (engine.isDepth ? ", white is deep" : ", white is high")
        + (engine.zeroIsFree ? ", any height on the mesh" : ", height " + std::string(zero) + " on the mesh");
}

// "100 x depth in tiles, 0.005 to 0.08".
std::string numberOf(const EngineFacts& engine)
{
    if (engine.property.empty())
        return "-";
    char text[128];
    std::snprintf(text, sizeof text, "%g x depth in %s", double(engine.factor), engine.of == DepthOf::Tile ? "tiles" : "m");
    std::string number = text;
    if (engine.min > 0.f || std::isfinite(engine.max)) {
        std::snprintf(text, sizeof text, ", %g to %g", double(engine.min), double(engine.max));
        number += text;
    }
    return number;
}

Table exports()
{
    Table table;
    for (const ExportRow& row : kExports) {
        const EngineFacts& engine = row.engine;
        table.push_back({{"key", row.key}, {"label", row.label}, {"suffix", row.suffix.empty() ? "folder" : row.suffix},
            {"files", namesInFolder(row)}, {"version", engine.version.empty() ? "-" : engine.version}, {"height", heightOf(engine)},
            {"property", engine.property.empty() ? "-" : engine.property}, {"value", numberOf(engine)},
            {"draws", engine.technique.empty() ? "-" : engine.technique}, {"limits", engine.limits.empty() ? "-" : engine.limits},
            {"help", row.help}});
    }
    return table;
}

Table actions()
{
    Table table;
    for (const ActionRow& row : kActions)
        table.push_back({{"key", row.key}, {"menu", row.menu}, {"label", row.label}, {"shortcut", row.shortcut}, {"help", row.help}});
    return table;
}

struct TableRow {
    std::string_view key, title;
    Table (*rows)();
};
constexpr TableRow kTables[]
    = {{"parameters", "Parameters", parameterTable}, {"techniques", "Techniques", techniques}, {"maps", "Baked maps", maps},
        {"views", "Views", views}, {"exports", "Export targets", exports}, {"actions", "Actions of the window", actions}};

std::string cell(const Json& value)
{
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    std::string text = value.is_string() ? value.get<std::string>() : value.is_array() ? std::string() : value.dump();
    if (value.is_array())
        for (const Json& word : value)
            text += (text.empty() ? "" : " ") + word.get<std::string>();
    for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2)
        text.insert(at, "\\");
    return text;
}

std::string markdown(const TableRow& table)
{
    const Table rows = table.rows();
    std::string head, rule, body;
    for (const auto& [name, value] : rows.front().items()) {
        head += "| " + name + ' ';
        rule += "|---";
    }
    for (const Json& row : rows) {
        for (const auto& [name, value] : row.items())
            body += "| " + cell(value) + ' ';
        body += "|\n";
    }
    return "## " + std::string(table.title) + "\n\n" + head + "|\n" + rule + "|\n" + body + '\n';
}

std::string plain(const TableRow& table)
{
    std::string text = std::string(table.title) + '\n';
    for (const Json& row : table.rows()) {
        std::string details;
        for (const auto& [name, value] : row.items())
            if (name != "key" && name != "help" && name != "label" && !cell(value).empty() && cell(value) != "-")
                details += (details.empty() ? "" : ", ") + name + ' ' + cell(value);
        text += "  " + row["key"].get<std::string>() + ": " + row["label"].get<std::string>()
            + (details.empty() ? "" : " (" + details + ')') + "\n      " + row["help"].get<std::string>() + '\n';
    }
    return text + '\n';
}

struct DescribeOptions {
    std::string table;
    bool json = false, markdown = false;
};

void describe(const DescribeOptions& options)
{
    Json all = Json::object();
    for (const TableRow& table : kTables) {
        if (!options.table.empty() && options.table != table.key)
            continue;
        if (options.json)
            all[std::string(table.key)] = table.rows();
        else
            std::fputs((options.markdown ? markdown(table) : plain(table)).c_str(), stdout);
    }
    if (options.json)
        std::puts(all.dump().c_str());
}

} // namespace

void addDescribe(CLI::App& app, int&)
{
    auto options = std::make_shared<DescribeOptions>();
    CLI::App* command = app.add_subcommand("describe", "The tables: parameters, techniques, maps, views, exports, actions");
    std::vector<std::string> keys;
    for (const TableRow& table : kTables)
        keys.emplace_back(table.key);
    command->add_option("TABLE", options->table, "One table; all when not given")->check(CLI::IsMember(keys));
    command->add_flag("--json", options->json, "As one JSON object");
    command->add_flag("--markdown", options->markdown, "As markdown tables");
    command->callback([options] { describe(*options); });
}

} // namespace relievo::cli
