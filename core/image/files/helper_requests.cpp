// Requests to the helper processes: several side by side, each in turn with its own helper; replies checked, crashes told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/helper_requests.h"
#include "core/image/files/image_file.h"
#include "core/image/files/process_client.h"
#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <oneapi/tbb/global_control.h>

namespace relievo {
using namespace imageio;

namespace {
constexpr std::size_t kMostHelpers = 2;

struct Helpers {
    std::mutex mutex;
    std::condition_variable freed;
    std::array<HelperProcess, kMostHelpers> processes;
    std::array<bool, kMostHelpers> isTaken = {};
    HangGuard hangs;
};
Helpers& helpers()
{
    static Helpers all;
    return all;
}

// A helper for one request. Those that come one by one all get the first one.
class Turn {
public:
    Turn()
    {
        std::unique_lock lock(m_all.mutex);
        m_all.freed.wait(lock, [this] { return (m_at = firstFree()) < kMostHelpers; });
        m_all.isTaken[m_at] = true;
    }
    ~Turn()
    {
        const std::scoped_lock lock(m_all.mutex);
        m_all.isTaken[m_at] = false;
        m_all.freed.notify_one();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    HelperProcess& process() { return m_all.processes[m_at]; }
    bool hangs() const
    {
        const std::scoped_lock lock(m_all.mutex);
        return m_all.hangs.refuses(HangGuard::Clock::now());
    }
    void note(HelperTrouble trouble, bool fresh)
    {
        const std::scoped_lock lock(m_all.mutex);
        m_all.hangs.note(trouble, fresh, HangGuard::Clock::now());
    }
    // The first one that is started brings the others along.
    bool ensureRunning(bool& fresh)
    {
        const std::scoped_lock lock(m_all.mutex);
        const std::size_t other = 1 - m_at;
        const bool both = imageHelperCount() > 1 && !m_all.isTaken[other] && m_all.processes[other].hasEnded();
        return process().ensureRunning(fresh, both ? &m_all.processes[other] : nullptr);
    }

private:
    std::size_t firstFree() const
    {
        for (std::size_t i = 0; i < imageHelperCount(); ++i)
            if (!m_all.isTaken[i])
                return i;
        return kMostHelpers;
    }
    Helpers& m_all = helpers();
    std::size_t m_at = 0;
};

// A conversation that broke: either an answer in words, or the helper is in trouble.
struct Broken {
    std::string what, hint;
    HelperTrouble trouble = HelperTrouble::None;
};

Error inWords(const Broken& broken, bool writes, const std::string& where)
{
    const char* const cure = writes ? "Free memory, or write a smaller picture" : "The file is probably damaged: export it again";
    const ErrorCode code = writes ? ErrorCode::NotWritable : ErrorCode::Unreadable;
    switch (broken.trouble) {
    case HelperTrouble::None:
        return {broken.what, where, broken.hint, code};
    case HelperTrouble::NotFound:
        return {"the program relievo-imageio, which reads and writes images, could not be started", where,
            "Install it beside relievo, or set RELIEVO_IMAGEIO to its path"};
    case HelperTrouble::OutOfTime:
        return {"decoding it takes far longer than an image of its size can need", where, cure, code};
    case HelperTrouble::TimedOut:
        return {"the image library made no progress for 20 seconds", where, cure, code};
    case HelperTrouble::Cancelled:
        return cancelled(where).value();
    case HelperTrouble::Died:
        break;
    }
    return {"the image library crashed or ran out of memory on this file", where, cure, code};
}

class Conversation {
public:
    Conversation(HelperProcess& process, const Progress& progress) : m_process(process), m_progress(progress) { }

    tl::expected<Reply, Broken> run(Message message, const PacketWriter& packet, Payload payload)
    {
        const Frame frame{message, std::uint32_t(packet.bytes().size())};
        if (!m_process.send(std::as_bytes(std::span(&frame, 1)), m_progress) || !m_process.send(packet.bytes(), m_progress)
            || !m_process.send(payload, m_progress))
            return trouble();
        for (;;) {
            Frame reply{};
            if (!m_process.receive(std::as_writable_bytes(std::span(&reply, 1)), m_progress))
                return trouble();
            if (reply.message == Message::Done || reply.message == Message::Failed)
                return finish(reply);
            if (!(reply.message == Message::Header ? takeHeader(reply) : reply.message == Message::Data && takeData(reply)))
                return trouble();
        }
    }

private:
    // A reply out of protocol is as good as a crash: nothing that follows can be trusted.
    tl::unexpected<Broken> trouble()
    {
        m_process.kill();
        const HelperTrouble known = m_process.trouble();
        return tl::unexpected(Broken{"", "", known == HelperTrouble::None ? HelperTrouble::Died : known});
    }

    bool takePacket(const Frame& frame, std::vector<std::byte>& bytes)
    {
        bytes.resize(std::min(frame.size, kMaxPacket));
        return frame.size <= kMaxPacket && m_process.receive(bytes, m_progress);
    }

    tl::expected<Reply, Broken> finish(const Frame& frame)
    {
        std::vector<std::byte> bytes;
        if (!takePacket(frame, bytes))
            return trouble();
        PacketReader packet(bytes);
        if (frame.message == Message::Failed) {
            Broken broken;
            broken.what = packet.text();
            broken.hint = packet.text();
            return tl::unexpected(broken);
        }
        while (packet.ok() && !packet.atEnd()) {
            Warning warning;
            warning.code = packet.text();
            warning.text = packet.text();
            m_reply.warnings.push_back(std::move(warning));
        }
        return std::move(m_reply);
    }

    bool takeHeader(const Frame& frame)
    {
        std::vector<std::byte> bytes;
        if (!takePacket(frame, bytes))
            return false;
        PacketReader packet(bytes);
        HeaderReply& header = m_reply.header;
        for (std::uint64_t* number : numbers(header))
            *number = packet.number();
        if (!packet.ok() || header.channels < 1 || header.channels > 4 || header.type > 2 || header.width * header.height > kMaxTexels)
            return false;
        while (packet.ok() && !packet.atEnd())
            m_reply.layers.push_back(packet.text());
        m_expected = std::size_t(header.width * header.height * header.channels) * bytesOf(PixelType(header.type));
        return true;
    }

    // Pixels go straight to where they stay; memory is touched only as they come.
    bool takeData(const Frame& frame)
    {
        const std::size_t at = m_reply.data.size();
        if (frame.size > kMaxData || (m_expected > 0 && at + frame.size > m_expected))
            return false;
        if (m_expected > 0)
            m_reply.data.reserve(m_expected);
        m_reply.data.resize(at + frame.size);
        if (!m_process.receive(std::span(m_reply.data).subspan(at), m_progress))
            return false;
        if (m_expected > 0)
            m_progress.at(float(m_reply.data.size()) / float(m_expected));
        return true;
    }

    HelperProcess& m_process;
    const Progress& m_progress;
    Reply m_reply;
    std::size_t m_expected = 0; // bytes of pixels; 0 while unknown
};

} // namespace

// A helper that has worked before may have been hurt by an earlier file: only a fresh one's death is this file's fault.
Expected<Reply> imageio::ask(
    Message message, const PacketWriter& packet, Payload payload, const std::string& where, const Progress& progress)
{
    Turn turn;
    if (turn.hangs())
        return failure(ErrorCode::Unreadable, where, "the program relievo-imageio, which reads and writes images, hangs",
            "Install it again, or set RELIEVO_IMAGEIO to another one; it is tried again after a minute");
    for (;;) {
        bool fresh = false;
        if (!turn.ensureRunning(fresh))
            return tl::unexpected(inWords({"", "", HelperTrouble::NotFound}, message == Message::Write, where));
        tl::expected<Reply, Broken> reply = Conversation(turn.process(), progress).run(message, packet, payload);
        turn.note(reply ? HelperTrouble::None : reply.error().trouble, fresh);
        if (reply)
            return std::move(*reply);
        if (fresh || reply.error().trouble != HelperTrouble::Died)
            return tl::unexpected(inWords(reply.error(), message == Message::Write, where));
    }
}

std::size_t imageHelperCount()
{
    using oneapi::tbb::global_control;
    return std::min(kMostHelpers, global_control::active_value(global_control::max_allowed_parallelism));
}

int imageHelperId()
{
    Turn turn; // no other thread has its process then
    return turn.process().id();
}

void startImageHelpers()
{
    Turn turn;
    bool fresh = false;
    turn.ensureRunning(fresh);
}

} // namespace relievo
