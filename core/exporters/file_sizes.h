// How large the files of an export will be, guessed without baking or encoding.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"

namespace relievo {

// Bytes of one of the files that `row.writes(job)` names; 0 for texts, which are small. From the sizes of the maps and what a format
// often makes of pictures: a rough guess, that noise or flat maps are far from.
double aboutBytes(const ExportRow& row, const ExportJob& job, const std::filesystem::path& file);

} // namespace relievo
