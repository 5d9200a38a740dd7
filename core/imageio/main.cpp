// relievo-imageio: the small program that decodes and encodes image files for the editor, within limits, so that a bad file cannot hurt it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/text.h"
#include "core/imageio/channel.h"
#include "core/imageio/mesh_codecs.h"
#include "core/imageio/picture.h"
#include "core/imageio/read.h"
#include "core/imageio/write.h"
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <malloc.h>
#include <new>
#include <poll.h>
#include <sched.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace {
using namespace relievo::imageio;

void limitMemory()
{
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    ::mallopt(M_ARENA_MAX, 2); // each arena reserves 64 MiB of address space
#ifndef __SANITIZE_ADDRESS__ // its shadow memory alone is larger; the editor sets its hard_rss_limit_mb instead
    const rlimit space{kMemoryLimitMiB << 20, kMemoryLimitMiB << 20};
    ::setrlimit(RLIMIT_AS, &space);
#endif
}

void configureLibrary()
{
    const int threads = int(std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
    OIIO::attribute("threads", threads);
    OIIO::attribute("exr_threads", threads);
    OIIO::attribute("limits:imagesize_MB", 16384);
    OIIO::attribute("limits:channels", 1024);
}

// The editor may be gone while a decoder hangs.
void endWhenAbandoned()
{
    std::thread([] {
        pollfd closed{STDIN_FILENO, 0, 0};
        while (::poll(&closed, 1, -1) < 0 || !(closed.revents & (POLLHUP | POLLERR | POLLNVAL))) { }
        ::_exit(0);
    }).detach();
}

// Image libraries may print; stdout belongs to the conversation.
int takeStdout()
{
    const int out = ::dup(STDOUT_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    return out;
}

// From here on there are two processes, both the editor's children, so that it hears of the end of each.
void becomeTwo()
{
#ifndef __SANITIZE_ADDRESS__ // which watches memory in a thread of its own, and the copy would have none; the editor starts it then
    if (::syscall(SYS_clone, CLONE_PARENT | SIGCHLD, nullptr, nullptr, nullptr, nullptr) == 0) {
        ::dup2(kTwinIn, STDIN_FILENO);
        ::dup2(kTwinOut, STDOUT_FILENO);
        const pid_t id = ::getpid();
        if (::write(STDOUT_FILENO, &id, sizeof id) != sizeof id)
            ::_exit(0);
    }
#endif
    ::close(kTwinIn);
    ::close(kTwinOut);
}

WriteRequest writeRequest(PacketReader& packet)
{
    WriteRequest request;
    request.suffix = packet.text();
    for (std::uint64_t* number : {&request.width, &request.height, &request.channels, &request.type, &request.srgb})
        *number = packet.number();
    request.channelNames = packet.text();
    return request;
}

DracoRequest dracoRequest(PacketReader& packet)
{
    DracoRequest request{packet.number(), {}};
    while (packet.ok() && !packet.atEnd()) {
        DracoAttribute& attribute = request.attributes.emplace_back();
        for (std::uint64_t* number : {&attribute.id, &attribute.components, &attribute.componentType})
            *number = packet.number();
    }
    return request;
}

void answer(Channel& channel, Message message, std::span<const std::byte> bytes)
{
    PacketReader packet(bytes);
    if (message == Message::Write)
        return answerWrite(channel, writeRequest(packet));
    if (message == Message::Meshopt) {
        MeshoptRequest request;
        for (std::uint64_t* number : {&request.size, &request.count, &request.stride, &request.mode, &request.filter})
            *number = packet.number();
        return answerMeshopt(channel, request);
    }
    if (message == Message::Draco)
        return answerDraco(channel, dracoRequest(packet));
    const std::string file = packet.text();
    if (message == Message::ReadBytes || message == Message::InfoBytes)
        return answerReadBytes(channel, packet.number(), message == Message::InfoBytes);
    answerRead(channel, {file, relievo::lowerSuffix(file).erase(0, 1), packet.text()}, message == Message::Info);
}

// A refusal in the middle of a reply is fine: the editor drops what came before.
bool answerSafely(Channel& channel, Message message, std::span<const std::byte> bytes)
{
    try {
        answer(channel, message, bytes);
        return true;
    } catch (const std::bad_alloc&) {
        channel.fail(tooMuchMemory());
    } catch (const std::exception&) {
        channel.fail({"the image library gave up on it", "The file is damaged: export it again from the program that made it"});
    }
    return message == Message::Info || message == Message::Read; // their input may be only half taken
}
} // namespace

int main(int argc, char** argv)
{
    limitMemory();
    if (argc > 1 && std::string_view(argv[1]) == kWithTwin)
        becomeTwo();
    Channel channel(STDIN_FILENO, takeStdout());
    endWhenAbandoned();
    configureLibrary();
    Frame frame;
    while (channel.receive(std::as_writable_bytes(std::span(&frame, 1)))) {
        if (frame.size > kMaxPacket)
            return 1;
        std::vector<std::byte> packet(frame.size);
        if (!channel.receive(packet) || !answerSafely(channel, frame.message, packet))
            break;
    }
    ::_exit(0); // no need to take the image libraries down one by one
}
