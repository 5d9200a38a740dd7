// The table of parameters as relievo describe tells it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <nlohmann/json.hpp>
#include <vector>

namespace relievo::cli {

// A table as rows of named cells; values keep their kind for JSON.
using Table = std::vector<nlohmann::ordered_json>;

Table parameterTable();

} // namespace relievo::cli
