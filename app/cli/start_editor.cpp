// relievo without a command: the options become a State, and the editor takes this process's place.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/handed_over.h"
#include "core/state/state_json.h"
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace relievo::cli {
namespace fs = std::filesystem;

namespace {

// Runs relievo-editor beside this program; returns only on failure.
int execute(std::vector<std::string> arguments)
{
    std::error_code code;
    const fs::path editor = fs::read_symlink("/proc/self/exe", code).parent_path() / "relievo-editor";
    arguments.insert(arguments.begin(), editor.string());
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    execv(editor.c_str(), argv.data());
    return tell(
        {{std::string("the editor cannot be started (") + std::strerror(errno) + ')', editor.string(), "Install it beside relievo"}});
}

bool isSource(const std::string& word)
{
    std::error_code code;
    return word.empty() || word.front() == '-' || isBuiltInSource(word) || fs::exists(word, code);
}

int noSuchSource(const std::string& word)
{
    return tell({{"there is no such file, folder or command", word, "relievo --help lists the commands"}, WrongUsage});
}

} // namespace

int startEditor(int argc, char** argv)
{
    StateOptions options;
    CLI::App app("Opens the editor");
    options.addTo(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (argc > 1 && !isSource(argv[1])) // the first word is the mistake, not what follows it
            return noSuchSource(argv[1]);
        return tell(app, error, "");
    }
    if (!isSource(options.source))
        return noSuchSource(options.source);
    if (!options.changesState())
        return execute(options.source.empty() ? std::vector<std::string>() : std::vector{options.source});

    if (options.source.empty())
        options.source = "sample:bricks";
    const auto opened = openState(options, {});
    if (!opened)
        return tell(opened.error());
    tell(opened->warnings, {});
    std::string folder
        = (fs::temp_directory_path() / kHandedOverFolder).string(); // nobody else's, under a name that cannot be known before
    if (!mkdtemp(folder.data()))
        return tell({{std::string("no folder can be made (") + std::strerror(errno) + ')', folder, "Free space there"}});
    const fs::path file = fs::path(folder) / kHandedOverFile;
    if (const auto written = writeState(opened->state, file); !written)
        return tell({written.error()});
    return execute({"--state-json", file.string()});
}

} // namespace relievo::cli
