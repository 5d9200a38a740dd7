// Running the programs as a user does.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

struct ProgramRun {
    int exitCode = -1;
    std::string out, err;
};

// Runs `relievo ARGUMENTS` through the shell; a crash gives an exit code above 128, more than `seconds` gives 124.
inline ProgramRun runRelievo(const std::string& arguments, int seconds = 60)
{
    const std::filesystem::path errors = std::filesystem::temp_directory_path() / ("relievo_err_" + std::to_string(getpid()));
    ProgramRun run;
    FILE* pipe
        = popen(("timeout " + std::to_string(seconds) + " " RELIEVO_BIN "/relievo " + arguments + " 2>" + errors.string()).c_str(), "r");
    std::array<char, 4096> buffer;
    for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        run.out.append(buffer.data(), n);
    const int status = pclose(pipe);
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (FILE* file = fopen(errors.c_str(), "r")) {
        for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), file)) > 0;)
            run.err.append(buffer.data(), n);
        fclose(file);
    }
    std::filesystem::remove(errors);
    return run;
}

// The largest resident memory of any program that has ended so far, helpers included; MiB.
inline long peakMemoryMiB()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_maxrss >> 10;
}

// A folder of the test's own, removed at its end.
struct TestFolder {
    std::filesystem::path path;
    explicit TestFolder(const std::string& name)
        : path(std::filesystem::temp_directory_path() / ("relievo_test_" + name + '_' + std::to_string(getpid())))
    {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~TestFolder()
    {
        std::error_code code;
        std::filesystem::permissions(path, std::filesystem::perms::owner_all, code);
        std::filesystem::remove_all(path, code);
    }
    std::string operator/(const std::string& name) const { return (path / name).string(); }
};
