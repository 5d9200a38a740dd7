// Writing a target that is a text: its textures, and its files from their templates.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"

namespace relievo {

Expected<Exported> exportByText(const ExportRow& row, const ExportJob& job);
std::vector<std::filesystem::path> filesOfText(const ExportRow& row, const ExportJob& job); // none where a name cannot be made

} // namespace relievo
