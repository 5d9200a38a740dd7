// One row a parameter, with the default as JSON has it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/describe_parameters.h"
#include "core/state/parameters.h"

namespace relievo::cli {
using Json = nlohmann::ordered_json;

namespace {
Json valueJson(const ParameterRow& row, const Value& value)
{
    if (const bool* b = std::get_if<bool>(&value))
        return *b;
    if (const int* i = std::get_if<int>(&value); i && kindOf(row) == ValueKind::Whole)
        return *i;
    if (std::holds_alternative<float>(value))
        return Json::parse(toText(row, value));
    return toText(row, value);
}
} // namespace

Table parameterTable()
{
    Table table;
    for (const ParameterRow& row : kParameters)
        table.push_back({{"key", row.key}, {"label", row.label}, {"group", wordOf(row.group)}, {"kind", wordOf(kindOf(row))},
            {"default", valueJson(row, get(Parameters(), row))}, {"min", Json::parse(toText(kParameters[0], row.min))},
            {"max", Json::parse(toText(kParameters[0], row.max))}, {"unit", row.unit}, {"options", optionList(row, ' ')},
            {"help", row.help}});
    return table;
}

} // namespace relievo::cli
