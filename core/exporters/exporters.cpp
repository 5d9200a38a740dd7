// Looking up a row of the export table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include <algorithm>

namespace relievo {

const ExportRow* findExport(std::string_view key)
{
    const auto found = std::ranges::find(kExports, key, &ExportRow::key);
    return found == kExports.end() ? nullptr : &*found;
}

} // namespace relievo
