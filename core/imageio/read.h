// Decoding an image file into a stream of rows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/imageio/channel.h"
#include <string>

namespace relievo::imageio {

// Largest image that is read at all; what exceeds kMaxSide or kMaxTexels is box-reduced on the way.
inline constexpr int kMaxFileSide = 1 << 17; // texels
inline constexpr double kMaxFileTexels = double(1 << 30);

// Answers Info (headerOnly) or Read. The format is recognised by content; suffix (lower case, no dot) helps where it has no mark.
void answerRead(Channel& channel, const std::string& file, const std::string& suffix, bool headerOnly);
void answerReadBytes(Channel& channel, std::uint64_t size);

} // namespace relievo::imageio
