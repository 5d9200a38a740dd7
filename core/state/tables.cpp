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
    const auto ofObjects = std::ranges::find(kObjectTechniques, key, &TechniqueRow::key);
    return found != kTechniques.end() ? &*found : ofObjects != kObjectTechniques.end() ? &*ofObjects : nullptr;
}

const ViewRow* findView(std::string_view key)
{
    const auto found = std::ranges::find(kViews, key, &ViewRow::key);
    return found == kViews.end() ? nullptr : &*found;
}

} // namespace relievo
