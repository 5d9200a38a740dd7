// Frames over file descriptors.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/channel.h"
#include <cerrno>
#include <unistd.h>

namespace relievo::imageio {

bool Channel::receive(std::span<std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t got = ::read(m_in, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        bytes = bytes.subspan(std::size_t(got));
    }
    return true;
}

void Channel::write(const void* data, std::size_t size)
{
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t put = ::write(m_out, at, size);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0)
            ::_exit(0); // nobody listens any more
        at += put;
        size -= std::size_t(put);
    }
}

void Channel::send(Message message, std::span<const std::byte> bytes)
{
    const Frame frame{message, std::uint32_t(bytes.size())};
    write(&frame, sizeof frame);
    write(bytes.data(), bytes.size());
}

void Channel::fail(const Refusal& refusal)
{
    PacketWriter packet;
    packet.put(refusal.what);
    packet.put(refusal.hint);
    send(Message::Failed, packet.bytes());
}

void Channel::done(const std::vector<std::pair<std::string, std::string>>& warnings)
{
    PacketWriter packet;
    for (const auto& [code, text] : warnings) {
        packet.put(code);
        packet.put(text);
    }
    send(Message::Done, packet.bytes());
}

} // namespace relievo::imageio
