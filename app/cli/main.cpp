// The program relievo: commands without a display, or the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <tbb/global_control.h>

namespace relievo::cli {

namespace {

using AddCommand = void (*)(CLI::App&, int&);
struct CommandRow {
    std::string_view key;
    AddCommand add;
};
constexpr CommandRow kCommands[] = {{"render", addRender}, {"trace", addTrace}, {"bake", addBake}, {"export", addExport},
    {"describe", addDescribe}, {"info", addInfo}, {"report", addReport}, {"tune", addTune}, {"compare", addCompare}};

// RELIEVO_THREADS bounds the worker threads for as long as the value lives.
std::unique_ptr<tbb::global_control> boundedThreads()
{
    const char* text = std::getenv("RELIEVO_THREADS");
    const int threads = text ? std::atoi(text) : 0;
    if (threads < 1)
        return {};
    return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
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
        return app.exit(error) == 0 ? Done : WrongUsage;
    }
    return exitCode;
}

} // namespace

} // namespace relievo::cli

int main(int argc, char** argv)
{
    const auto threads = relievo::cli::boundedThreads();
    try {
        return relievo::cli::run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("relievo: error: there is not enough memory. Use smaller maps or close other programs.\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "relievo: error: internal fault (%s). Please report it.\n", error.what());
    }
    return relievo::cli::Failed;
}
