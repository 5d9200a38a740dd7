// The file in which `relievo` hands a state over to `relievo-editor`: in a new folder below that of temporary files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace relievo {

inline constexpr const char* kHandedOverFolder = "relievo-state-XXXXXX"; // X: letters and digits
inline constexpr const char* kHandedOverFile = "handed-over.json";

} // namespace relievo
