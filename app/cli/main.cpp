// The program relievo: commands without a display, or the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/ground/shown_text.h"
#include "core/maps/map_cache.h"
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <tbb/global_control.h>
#include <unistd.h>

namespace relievo::cli {

namespace {

using AddCommand = void (*)(CLI::App&, int&);
struct CommandRow {
    std::string_view key;
    AddCommand add;
};
constexpr CommandRow kCommands[] = {{"render", addRender}, {"trace", addTrace}, {"inspect", addInspect}, {"bake", addBake},
    {"export", addExport}, {"describe", addDescribe}, {"info", addInfo}, {"report", addReport}, {"tune", addTune}, {"compare", addCompare},
    {"impostor", addImpostor}};

void warnOf(const char* variable, const char* value, const char* cure)
{
    std::fprintf(stderr, "relievo: warning: %s=%s %s\n", variable, shownText(value).c_str(), cure);
}

// RELIEVO_THREADS bounds the worker threads for as long as the value lives.
std::unique_ptr<tbb::global_control> boundedThreads()
{
    const char* text = std::getenv("RELIEVO_THREADS");
    if (!text || !*text)
        return {};
    int threads = 0;
    const char* end = text + std::strlen(text);
    if (const auto [at, code] = std::from_chars(text, end, threads); code != std::errc() || at != end || threads < 1) {
        warnOf("RELIEVO_THREADS", text, "is no number of threads and not used. Write one of at least 1.");
        return {};
    }
    return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
}

// Of those that the command may use.
void warnOfFolders(std::string_view command)
{
    if (command.starts_with('-') || command == "describe" || command == "info")
        return;
    std::error_code code;
    if (const char* folder = std::getenv("RELIEVO_SHADERS"); folder && *folder && !std::filesystem::is_directory(folder, code))
        warnOf("RELIEVO_SHADERS", folder, "is no folder: the shaders built in are used. Name the folder of the shaders' texts.");
    const auto cache = cacheFolder();
    if (const char* folder = std::getenv("RELIEVO_CACHE"); folder && *folder && cache) {
        std::filesystem::create_directories(*cache, code);
        if (!std::filesystem::is_directory(*cache, code) || ::access(cache->c_str(), W_OK) != 0)
            warnOf("RELIEVO_CACHE", folder, "cannot be written: baked maps are not kept. Name another folder, or \"off\".");
    }
}

// What a command printed may still have to be written, and the disk may be full.
bool wroteAll()
{
    errno = 0;
    const bool flushed = std::fflush(stdout) == 0;
    return flushed && !std::ferror(stdout) && std::cout.flush();
}

bool startsCommand(int argc, char** argv)
{
    if (argc < 2)
        return false;
    const std::string_view first = argv[1];
    return first == "--help" || first == "-h" || first == "--version" || std::ranges::count(kCommands, first, &CommandRow::key);
}

int run(int argc, char** argv)
{
    if (!startsCommand(argc, argv))
        return startEditor(argc, argv);
    std::signal(SIGPIPE, SIG_DFL); // who closes the pipe has what was wanted
    warnOfFolders(argv[1]);
    int exitCode = Done;
    CLI::App app(
        "Relievo: relief materials, seen, compared and exported.\nrelievo [SOURCE] opens the editor; the commands need no display.");
    app.set_version_flag("--version", std::string("relievo ") + RELIEVO_VERSION);
    app.require_subcommand(1);
    app.option_defaults()->always_capture_default(false);
    for (const CommandRow& row : kCommands)
        row.add(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return tell(app, error, argv[1][0] == '-' ? "" : argv[1]);
    }
    return exitCode;
}

} // namespace

} // namespace relievo::cli

int main(int argc, char** argv)
{
    const auto threads = relievo::cli::boundedThreads();
    try {
        const int code = relievo::cli::run(argc, argv);
        if (relievo::cli::wroteAll())
            return code;
        const std::string reason = errno != 0 ? std::string(" (") + std::strerror(errno) + ')' : std::string();
        std::fprintf(stderr, "relievo: error: stdout: the output could not be written%s. Free space where it goes.\n", reason.c_str());
        return relievo::cli::Failed;
    } catch (const std::bad_alloc&) {
        std::fputs("relievo: error: there is not enough memory. Use smaller maps or close other programs.\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "relievo: error: internal fault (%s). Please report it.\n", error.what());
    }
    return relievo::cli::Failed;
}
