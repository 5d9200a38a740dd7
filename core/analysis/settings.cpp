// From a technique's row to the settings worth measuring.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/settings.h"
#include <algorithm>
#include <cctype>

namespace relievo {

namespace {

bool isStepCount(const ParameterRow& row)
{
    return kindOf(row) == ValueKind::Whole && row.key != "refineSteps";
}
bool isSwitch(const ParameterRow& row)
{
    return kindOf(row) == ValueKind::Switch;
}

std::string withSmallInitial(std::string_view label)
{
    std::string text(label);
    if (!text.empty())
        text[0] = char(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

// " 32+6" for equal step counts, " 8-32+6" for a range, "" for a search without steps.
std::string stepsText(const TechniqueRow& technique, const Parameters& parameters)
{
    int least = 1 << 30, most = 0;
    for (const ParameterRow& row : kParameters)
        if (searchesBy(technique, row) && isStepCount(row)) {
            const int steps = std::get<int>(get(parameters, row));
            least = std::min(least, steps), most = std::max(most, steps);
        }
    if (most == 0)
        return {};
    const std::string refined = technique.parameters.contains(&Parameters::refineSteps) ? '+' + std::to_string(parameters.refineSteps) : "";
    return ' ' + (least < most ? std::to_string(least) + '-' : "") + std::to_string(most) + refined;
}

SearchSetting labelled(const TechniqueRow& technique, const Parameters& parameters, std::string_view extra = {})
{
    const std::string label(technique.label), more(extra);
    return {&technique, label + stepsText(technique, parameters) + more, label + more, parameters};
}

Parameters withSteps(const TechniqueRow& technique, Parameters parameters, int steps)
{
    for (const ParameterRow& row : kParameters)
        if (searchesBy(technique, row) && isStepCount(row))
            set(parameters, row, clamped(row, steps));
    return parameters;
}

bool hasSteps(const TechniqueRow& technique)
{
    return std::ranges::any_of(kParameters, [&](const ParameterRow& row) { return searchesBy(technique, row) && isStepCount(row); });
}

} // namespace

std::vector<SearchSetting> settingsOf(const TechniqueRow& technique, const Parameters& base, std::span<const int> steps)
{
    Parameters plain = base;
    plain.heightMips = false;
    std::vector<Parameters> stepped;
    for (const int count : steps)
        if (hasSteps(technique))
            stepped.push_back(withSteps(technique, plain, count));
    if (stepped.empty())
        stepped.push_back(plain);
    stepped.erase(std::unique(stepped.begin(), stepped.end()), stepped.end()); // counts beyond a row's range

    std::vector<SearchSetting> settings;
    for (const Parameters& parameters : stepped)
        settings.push_back(labelled(technique, parameters));
    for (const ParameterRow& row : kParameters)
        for (const Parameters& parameters : stepped) {
            if (!searchesBy(technique, row) || !isSwitch(row))
                continue;
            Parameters turned = parameters;
            const bool on = !std::get<bool>(get(parameters, row));
            set(turned, row, on);
            settings.push_back(labelled(technique, turned, (on ? ", " : ", no ") + withSmallInitial(row.label)));
        }
    return settings;
}

SearchSetting plainSetting(const TechniqueRow& technique, const Parameters& base)
{
    Parameters plain = base;
    plain.heightMips = false;
    return labelled(technique, plain);
}

SearchSetting mostExactSetting(const Parameters& base)
{
    const auto exact = std::ranges::find_if(kTechniques, [](const TechniqueRow& row) { return row.isExact && !row.file.empty(); });
    const TechniqueRow& technique = exact == kTechniques.end() ? *findTechnique("relief") : *exact;
    Parameters parameters = plainSetting(technique, base).parameters;
    for (const ParameterRow& row : kParameters)
        if (searchesBy(technique, row) && (isStepCount(row) || row.key == "refineSteps"))
            set(parameters, row, int(row.max));
    return labelled(technique, parameters);
}

State withSetting(const State& state, const SearchSetting& setting)
{
    State changed = ofFirstPane(state);
    for (const ParameterRow& row : kParameters)
        if (searchesBy(*setting.technique, row))
            set(changed.parameters, row, get(setting.parameters, row));
    changed.panes.front().technique = setting.technique->key;
    return changed;
}

std::string parametersText(const SearchSetting& setting)
{
    std::string text;
    for (const ParameterRow& row : kParameters)
        if (searchesBy(*setting.technique, row))
            text += (text.empty() ? "" : " ") + std::string(row.key) + '=' + toText(row, get(setting.parameters, row));
    return text;
}

Expected<std::vector<const TechniqueRow*>> techniquesNamed(std::span<const std::string> keys)
{
    std::vector<const TechniqueRow*> rows;
    for (const std::string& key : keys) {
        const TechniqueRow* row = findTechnique(key);
        if (!row)
            return failure(ErrorCode::NotFound, key, "there is no such technique", "relievo describe techniques lists them");
        if (row->file.empty())
            return failure(key, "this technique is what the others are measured against", "Name others");
        if (!std::ranges::count(rows, row))
            rows.push_back(row);
    }
    for (const TechniqueRow& row : kTechniques)
        if (keys.empty() && isChoice(row))
            rows.push_back(&row);
    return rows;
}

} // namespace relievo
