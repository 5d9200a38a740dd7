// Encoding rows of pixels into the bytes of an image file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/imageio/channel.h"

namespace relievo::imageio {

// Takes the pixels that follow the request, and answers with the encoded file's bytes.
void answerWrite(Channel& channel, const WriteRequest& request);

} // namespace relievo::imageio
