// How large the files of an export will be, guessed without baking, from a few rows of each picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"

namespace relievo {

// Bytes of one of the files that `row.writes(job)` names; 0 for texts, which are small. PNG: what some rows of it take, encoded; within
// some 20 % of real sets. Other formats, and maps that were baked first, by what is usual: those may be far off.
double aboutBytes(const ExportRow& row, const ExportJob& job, const std::filesystem::path& file);

} // namespace relievo
