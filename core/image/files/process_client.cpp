// Starting relievo-imageio and moving bytes to and from it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/process_client.h"
#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/env.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <boost/process/posix.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace relievo {
namespace {
constexpr std::chrono::seconds kPatience{20}; // without a byte moving
constexpr std::chrono::seconds kLastWords{1}; // for a killed process to be gone
constexpr int kPollMs = 50; // how often a cancel is looked for
constexpr int kPipeBytes = 1 << 20;

std::string helperPath()
{
    if (const char* set = std::getenv("RELIEVO_IMAGEIO"); set && *set)
        return set;
    std::error_code code;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", code);
    return (self.parent_path() / "relievo-imageio").string();
}

// What the variable holds already, and one thing more.
std::string withOption(const char* variable, const std::string& more)
{
    const char* set = std::getenv(variable);
    return set && *set ? std::string(set) + ":" + more : more;
}

// AddressSanitizer builds cannot be limited by address space: they watch their resident memory themselves.
std::string sanitizerOptions()
{
    return withOption("ASAN_OPTIONS", "hard_rss_limit_mb=" + std::to_string(imageio::kMemoryLimitMiB) + ":detect_leaks=0");
}

// Pictures are decoded into large pages where the system has them: touching that much memory by small ones takes long.
std::string largePages()
{
    return withOption("GLIBC_TUNABLES", "glibc.malloc.hugetlb=1");
}

// A dead process stays in the system's table until it is collected, and its time counts as ours only then. One that hangs in a file
// system is left behind.
void collect(pid_t id)
{
    const auto start = std::chrono::steady_clock::now();
    while (::waitpid(id, nullptr, WNOHANG) == 0 && std::chrono::steady_clock::now() - start < kLastWords)
        ::poll(nullptr, 0, 1);
}

void closeHandle(int& handle)
{
    if (handle >= 0)
        ::close(handle);
    handle = -1;
}
} // namespace

struct HelperProcess::Process {
    boost::process::child child;
};

HelperProcess::HelperProcess() = default;
HelperProcess::~HelperProcess()
{
    kill();
}

void HelperProcess::kill()
{
    closeHandle(m_in);
    closeHandle(m_out);
    if (!m_process)
        return;
    std::error_code code;
    if (m_process->child.running(code)) { // else it is collected, and its number may be another's by now
        ::kill(m_process->child.id(), SIGKILL);
        collect(m_process->child.id());
    }
    m_process->child.detach();
    m_process.reset();
}

int HelperProcess::id() const
{
    return m_process ? int(m_process->child.id()) : 0;
}

bool HelperProcess::fail(HelperTrouble trouble)
{
    m_trouble = trouble;
    kill();
    return false;
}

bool HelperProcess::hasEnded()
{
    std::error_code code;
    return m_in < 0 || (m_process && !m_process->child.running(code));
}

// Keeps our ends of a new connection. The numbers of the others are none that the helper knows its own by.
std::optional<HelperProcess::Ends> HelperProcess::connect()
{
    constexpr int kAbove = imageio::kTwinOut + 1;
    int in[2] = {-1, -1}, out[2] = {-1, -1};
    const bool made = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in) == 0 && ::pipe2(out, O_CLOEXEC) == 0;
    m_in = in[0], m_out = out[0];
    Ends ends;
    if (made) {
        ::fcntl(m_out, F_SETPIPE_SZ, kPipeBytes);
        ends = {::fcntl(in[1], F_DUPFD_CLOEXEC, kAbove), ::fcntl(out[1], F_DUPFD_CLOEXEC, kAbove)};
    }
    closeHandle(in[1]);
    closeHandle(out[1]);
    if (ends.in >= 0 && ends.out >= 0)
        return ends;
    closeHandle(ends.in);
    closeHandle(ends.out);
    return std::nullopt;
}

bool HelperProcess::ensureRunning(bool& fresh, HelperProcess* twin)
{
    namespace bp = boost::process;
    using bp::posix::fd;
    m_trouble = HelperTrouble::None;
    fresh = hasEnded();
    if (!fresh)
        return true;
    kill();
    if (twin)
        twin->kill();
    std::optional<Ends> own = connect(), others = own && twin ? twin->connect() : std::nullopt;
    if (!own)
        return fail(HelperTrouble::NotFound);
    std::error_code code;
    try {
        const auto start = [&](auto&&... more) {
            return bp::child(bp::exe = helperPath(), fd.bind(STDIN_FILENO, own->in), fd.bind(STDOUT_FILENO, own->out),
                bp::std_err > bp::null, bp::env["ASAN_OPTIONS"] = sanitizerOptions(), bp::env["GLIBC_TUNABLES"] = largePages(), more...,
                code);
        };
        m_process = std::make_unique<Process>();
        m_process->child = others
            ? start(bp::args = imageio::kWithTwin, fd.bind(imageio::kTwinIn, others->in), fd.bind(imageio::kTwinOut, others->out))
            : start();
    } catch (const std::exception&) {
        code = std::make_error_code(std::errc::no_such_process);
    }
    for (std::optional<Ends>* ends : {&own, &others})
        if (*ends) {
            closeHandle((*ends)->in);
            closeHandle((*ends)->out);
        }
    if (code && twin)
        twin->kill();
    return code ? fail(HelperTrouble::NotFound) : true;
}

// Waits until the handle is ready; false after trouble.
bool HelperProcess::wait(int handle, short events, const Progress& progress)
{
    const auto start = std::chrono::steady_clock::now();
    for (;;) {
        if (progress.cancelled())
            return fail(HelperTrouble::Cancelled);
        pollfd ready{handle, events, 0};
        const int count = ::poll(&ready, 1, kPollMs);
        if (count > 0)
            return true;
        if (count < 0 && errno != EINTR)
            return fail(HelperTrouble::Died);
        if (std::chrono::steady_clock::now() - start > kPatience)
            return fail(HelperTrouble::TimedOut);
    }
}

bool HelperProcess::greet(const Progress& progress)
{
    pid_t id = 0;
    if (!receive(std::as_writable_bytes(std::span(&id, 1)), progress))
        return false;
    m_process = std::make_unique<Process>();
    m_process->child = boost::process::child(id);
    return true;
}

bool HelperProcess::send(std::span<const std::byte> bytes, const Progress& progress)
{
    if (!m_process && !greet(progress))
        return false;
    while (!bytes.empty()) {
        if (!wait(m_in, POLLOUT, progress))
            return false;
        const ssize_t put = ::send(m_in, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (put < 0 && (errno == EINTR || errno == EAGAIN))
            continue;
        if (put <= 0)
            return fail(HelperTrouble::Died);
        bytes = bytes.subspan(std::size_t(put));
    }
    return true;
}

bool HelperProcess::receive(std::span<std::byte> bytes, const Progress& progress)
{
    while (!bytes.empty()) {
        if (!wait(m_out, POLLIN, progress))
            return false;
        const ssize_t got = ::read(m_out, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return fail(got == 0 && endedOutOfTime() ? HelperTrouble::OutOfTime : HelperTrouble::Died);
        bytes = bytes.subspan(std::size_t(got));
    }
    return true;
}

// Asked when its output has ended: then it has ended, too, or is just about to.
bool HelperProcess::endedOutOfTime()
{
    if (!m_process)
        return false;
    int status = 0;
    const pid_t ended = ::waitpid(m_process->child.id(), &status, 0);
    if (ended != m_process->child.id())
        return false;
    m_process->child.detach(); // collected: its number may be another's by now
    m_process.reset();
    return WIFEXITED(status) && WEXITSTATUS(status) == imageio::kOutOfTime;
}

} // namespace relievo
