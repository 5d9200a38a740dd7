// Asking the helper process relievo-imageio: one request, one reply.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/files/imageio_protocol.h"

namespace relievo::imageio {

// What is sent after the request's packet, without copying it.
using Payload = std::span<const std::byte>;

struct Reply {
    HeaderReply header;
    std::vector<std::string> layers;
    std::vector<std::byte> data;
    Warnings warnings;
};

// Waits for the helper, which answers in turn. Errors name `where`; they speak of an image. Safe to call from several threads.
Expected<Reply> ask(Message message, const PacketWriter& packet, Payload payload, const std::string& where, const Progress& progress);

} // namespace relievo::imageio
