// What the commands share: options that change the State, and how results, warnings and errors are told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/scene/resources.h"
#include "core/scene/source.h"
#include "core/state/state.h"
#include <CLI/App.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::cli {

// resources/help/command-line.md, "Exit codes".
enum Exit { Done = 0, Failed = 1, WrongUsage = 2, MissedTarget = 3 };

// Options of every command.
struct Common {
    bool json = false, quiet = false, progress = false;
    void addTo(CLI::App& command);
};

// Options that choose and change the State, in the order in which they apply
// (resources/help/command-line.md, "Options that change the State").
struct StateOptions {
    std::string source, preset, technique, mesh, environment, camera, depthMap;
    std::vector<std::string> set;
    std::map<std::string, std::string> maps; // by map kind's key
    void addTo(CLI::App& command);
    void addMapsTo(CLI::App& command); // only --height, --depth-map, --color ...
    bool givesMaps() const;
    bool changesState() const; // anything but SOURCE was given
};

struct Scene {
    State state;
    Resources resources;
    Warnings warnings;
};
// A wrong option's value must end with exit code 2: its error is marked here.
struct Problem {
    Error error;
    int exitCode = Failed;
};
template <class T> using Result = tl::expected<T, Problem>;
inline tl::unexpected<Problem> problem(Error error, int code = Failed)
{
    return tl::unexpected(Problem{std::move(error), code});
}

// The State that the options describe, and its data.
Result<Opened> openState(const StateOptions& options, const Progress& progress);
Result<Scene> openScene(const StateOptions& options, const Progress& progress);

// Progress on stderr when that is a terminal or was asked for.
Progress shownProgress(const Common& common);

// Prints "relievo: error: ..." and returns the exit code.
int tell(const Problem& problem);
void tell(const Warnings& warnings, const Common& common); // on stderr
nlohmann::ordered_json warningsJson(const Warnings& warnings);
void print(const nlohmann::ordered_json& result); // one line on stdout; bytes of file names that are no UTF-8 become U+FFFD

// One function a command: adds its subcommand to `app`; running it sets `exitCode`.
void addRender(CLI::App& app, int& exitCode);
void addTrace(CLI::App& app, int& exitCode);
void addBake(CLI::App& app, int& exitCode);
void addExport(CLI::App& app, int& exitCode);
void addDescribe(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addReport(CLI::App& app, int& exitCode);
void addTune(CLI::App& app, int& exitCode);
void addCompare(CLI::App& app, int& exitCode);

// Starts the editor in place of this program; returns only when that failed.
int startEditor(int argc, char** argv);

} // namespace relievo::cli
