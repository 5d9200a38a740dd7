// Texture units that are not handed out one after the other, as those of the material's maps are (at most 11).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace relievo {

inline constexpr int kBorderUnit = 11, kPoseUnit = 12, kMorphUnit = 13, kShadowUnit = 14;
inline constexpr int kExactUnit = kShadowUnit; // the view that measures is not lit
inline constexpr int kUploadUnit = 15; // no program reads it: an upload must not take the place of a map that is bound already

} // namespace relievo
