// The editor's end of a helper process: started on first use, spoken to in frames, killed when it hangs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/error.h"
#include "core/image/imageio_protocol.h"
#include "core/progress.h"
#include <memory>

namespace relievo {

enum class HelperTrouble { None, NotFound, Died, TimedOut, Cancelled };

// Not thread safe: one conversation at a time (the caller locks).
class HelperProcess {
public:
    HelperProcess();
    ~HelperProcess(); // kills it
    HelperProcess(const HelperProcess&) = delete;
    HelperProcess& operator=(const HelperProcess&) = delete;

    // Starts it unless it runs. False: trouble() is NotFound. `fresh` tells whether it was started by this very call.
    bool ensureRunning(bool& fresh);
    // Both give up when nothing moves for 20 s, when the process dies, or when `progress` is cancelled; then it is killed.
    bool send(std::span<const std::byte> bytes, const Progress& progress);
    bool receive(std::span<std::byte> bytes, const Progress& progress);

    HelperTrouble trouble() const { return m_trouble; }
    void kill(); // the next ensureRunning starts a new one
    int id() const; // process id, 0 when none runs

private:
    bool wait(int handle, short events, const Progress& progress);
    bool fail(HelperTrouble trouble);
    struct Process;
    std::unique_ptr<Process> m_process;
    int m_in = -1, m_out = -1; // our ends of its stdin (a socket, so that a dead reader raises no SIGPIPE) and stdout (a pipe)
    HelperTrouble m_trouble = HelperTrouble::None;
};

// Process id of the running image helper, 0 when none runs; for tests that take it down.
int imageHelperId();

} // namespace relievo
