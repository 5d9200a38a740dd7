// Look-ups by key in the tables of techniques and views.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <algorithm>

namespace relievo {

const TechniqueRow* findTechnique(std::string_view key)
{
    const auto found = std::ranges::find(kTechniques, key, &TechniqueRow::key);
    return found == kTechniques.end() ? nullptr : &*found;
}

bool searchesBy(const TechniqueRow& technique, const ParameterRow& row)
{
    return row.group == Group::Search && row.key != "heightMips" && listHas(technique.parameters, row.key);
}

const ViewRow* findView(std::string_view key)
{
    const auto found = std::ranges::find(kViews, key, &ViewRow::key);
    return found == kViews.end() ? nullptr : &*found;
}

float heatRange(const Parameters& parameters, std::string_view view)
{
    const ViewRow* row = findView(view);
    return view == "fetches" ? parameters.fetchRange : row && row->isAgainstExact ? parameters.errorRange : 1.f;
}

} // namespace relievo
