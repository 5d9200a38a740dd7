// The editor's end of a helper process: started on first use, spoken to in frames, killed when it hangs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/files/imageio_protocol.h"
#include <chrono>
#include <memory>
#include <optional>
#include <span>

namespace relievo {

enum class HelperTrouble { None, NotFound, Died, OutOfTime, TimedOut, Cancelled }; // OutOfTime: it ended itself (kOutOfTime)

// Tells a hanging helper from a hanging file: two fresh helpers in a row that timed out are no file's fault.
class HangGuard {
public:
    using Clock = std::chrono::steady_clock;
    // Whether not to ask at all. After a while it may be tried again.
    bool refuses(Clock::time_point now) const { return m_inARow >= 2 && now - m_last < std::chrono::minutes(1); }
    void note(HelperTrouble trouble, bool fresh, Clock::time_point now)
    {
        m_inARow = trouble != HelperTrouble::TimedOut ? 0 : m_inARow + (fresh ? 1 : 0);
        m_last = now;
    }

private:
    int m_inARow = 0; // fresh helpers that timed out
    Clock::time_point m_last;
};

// Not thread safe: one conversation at a time (the caller locks).
class HelperProcess {
public:
    HelperProcess();
    ~HelperProcess(); // kills it
    HelperProcess(const HelperProcess&) = delete;
    HelperProcess& operator=(const HelperProcess&) = delete;

    // Starts it unless it runs. False: trouble() is NotFound. `fresh` tells whether it was started by this very call. Started anew it
    // brings `twin` along, which has ended, or nullptr: a copy of the new process, as its libraries take as long to load as many an image.
    bool ensureRunning(bool& fresh, HelperProcess* twin = nullptr);
    bool hasEnded();
    // Both give up when nothing moves for 20 s, when the process dies, or when `progress` is cancelled; then it is killed.
    bool send(std::span<const std::byte> bytes, const Progress& progress);
    bool receive(std::span<std::byte> bytes, const Progress& progress);

    HelperTrouble trouble() const { return m_trouble; }
    void kill(); // the next ensureRunning starts a new one
    int id() const; // process id, 0 when none runs or it has not told it yet

private:
    struct Ends { // of the helper
        int in = -1, out = -1;
    };
    std::optional<Ends> connect();
    bool wait(int handle, short events, const Progress& progress);
    bool greet(const Progress& progress); // a twin tells its id first
    bool fail(HelperTrouble trouble);
    bool endedOutOfTime();
    struct Process;
    std::unique_ptr<Process> m_process; // of a twin only when its id is known
    int m_in = -1, m_out = -1; // our ends of its stdin (a socket, so that a dead reader raises no SIGPIPE) and stdout (a pipe)
    HelperTrouble m_trouble = HelperTrouble::None;
};

std::size_t imageHelperCount(); // how many may work at once: as many as there are threads to ask them, 2 at most
// Process id of the image helper that gets requests that come one by one, 0 when none runs; for tests that take it down.
int imageHelperId();

} // namespace relievo
