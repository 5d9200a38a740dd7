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
#include <filesystem>
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
    void addTo(CLI::App& command, std::vector<std::string>* sources = nullptr); // `sources`: takes several, instead of `source`
    void addMapsTo(CLI::App& command); // only --height, --depth-map, --color ...
    // The option of a file to write, and of one to read beside what the State names. openState refuses to open what an output would
    // replace. `file` must outlive the options and their copies.
    CLI::Option* addOutput(CLI::App& command, const std::string& name, std::string& file, const std::string& help);
    CLI::Option* addInput(CLI::App& command, const std::string& name, std::string& file, const std::string& help);
    std::vector<std::filesystem::path> filesRead() const; // but those that the State names
    bool givesMaps() const;
    bool changesState() const; // anything but SOURCE was given
    std::vector<const std::string*> outputs, inputs;
};

// What a search on given rays needs of a State: its first pane's technique and parameters, and the heights.
struct SearchInput {
    std::string technique;
    Parameters parameters;
    std::optional<HeightField> field; // with the State's wrap
    Warnings warnings;
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

// The State that the options describe, and its data. Files that are named and not there: an error when an option names them; a warning
// when the State names a mesh or environment, which openScene, needing them, makes an error.
Result<Opened> openState(const StateOptions& options, const Progress& progress);
Result<SearchInput> openHeights(const StateOptions& options, const Progress& progress);
Result<Scene> openScene(const StateOptions& options, const Progress& progress, bool isDrawn = true); // else without acceleration maps

// Progress on stderr when that is a terminal or was asked for.
Progress shownProgress(const Common& common);

// Prints "relievo: error: ..." and returns the exit code.
int tell(const Problem& problem);
int tell(const CLI::App& app, const CLI::ParseError& error, const std::string& command); // also help and version, when these were asked for
void tell(const Warnings& warnings, const Common& common); // on stderr
nlohmann::ordered_json warningsJson(const Warnings& warnings);
void print(const nlohmann::ordered_json& result); // one line on stdout; bytes that are no UTF-8 become U+FFFD, control characters escapes

// The end of a command: its warnings, and with --json what it found; or its error, and the exit code.
template <class Found, class ToJson> void conclude(const Result<Found>& found, const Common& common, int& exitCode, ToJson toJson)
{
    if (!found) {
        exitCode = tell(found.error());
        return;
    }
    tell(found->warnings, common);
    if (common.json)
        print(toJson(*found));
}

// One function a command: adds its subcommand to `app`; running it sets `exitCode`.
void addRender(CLI::App& app, int& exitCode);
void addTrace(CLI::App& app, int& exitCode);
void addInspect(CLI::App& app, int& exitCode);
void addBake(CLI::App& app, int& exitCode);
void addExport(CLI::App& app, int& exitCode);
void addDescribe(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addReport(CLI::App& app, int& exitCode);
void addTune(CLI::App& app, int& exitCode);
void addCompare(CLI::App& app, int& exitCode);
void addImpostor(CLI::App& app, int& exitCode);

// Starts the editor in place of this program; returns only when that failed.
int startEditor(int argc, char** argv);

} // namespace relievo::cli
