// The helper's end of the conversation: whole frames in from stdin and out to the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/files/imageio_protocol.h"
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace relievo::imageio {

// A refusal in words for the user; `what` is one clause without full stop.
struct Refusal {
    std::string what, hint;
};

class Channel {
public:
    Channel(int in, int out) : m_in(in), m_out(out) { }
    bool receive(std::span<std::byte> bytes); // false: the editor is gone
    void send(Message message, std::span<const std::byte> bytes); // ends the process when the editor is gone
    void fail(const Refusal& refusal);
    void done(const std::vector<std::pair<std::string, std::string>>& warnings); // (code, text)

private:
    void write(const void* data, std::size_t size);
    int m_in, m_out;
};

} // namespace relievo::imageio
