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

struct ReadRequest {
    std::string file;
    std::string suffix; // lower case, no dot: helps where a format has no mark; else it is recognised by its content
    std::string layer; // of an EXR file, "" for the first one
};

// Answers Info (headerOnly) or Read.
void answerRead(Channel& channel, const ReadRequest& request, bool headerOnly);
void answerReadBytes(Channel& channel, std::uint64_t size, bool headerOnly);

} // namespace relievo::imageio
