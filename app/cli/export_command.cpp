// relievo export: a row of the export table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/exporters/exporters.h"
#include "core/ground/shown_text.h"
#include "core/ground/text.h"
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace relievo::cli {

namespace {

struct ExportOptions {
    Common common;
    StateOptions state;
    std::string out, target;
    int size = 0;
};

Result<Exported> exportScene(const ExportOptions& options)
{
    const ExportRow* row = findExport(options.target);
    if (!row)
        return problem({"there is no such target", "--target " + options.target, "relievo describe exports lists them"}, WrongUsage);
    if (!row->suffix.empty() && lowerSuffix(options.out) != row->suffix)
        return problem({"this target writes " + std::string(row->suffix), "-o " + options.out, "Give the file that suffix"}, WrongUsage);
    const Progress progress = shownProgress(options.common);
    const auto scene = openScene(options.state, progress.part(0.f, 0.5f));
    if (!scene)
        return tl::unexpected(scene.error());
    auto exported
        = row->run({scene->state, scene->resources, options.out, options.size, progress.part(0.5f, 1.f), options.state.filesRead()});
    if (!exported)
        return problem(exported.error());
    progress.at(1.f);
    exported->warnings.insert(exported->warnings.begin(), scene->warnings.begin(), scene->warnings.end());
    return *exported;
}

} // namespace

void addExport(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand("export", "Writes the material for another program");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_option("--target", options->target, "What to write, see relievo describe exports")->required()->type_name("KEY");
    options->state.addOutput(*command, "-o", options->out, "File or folder to write, as the target wants")
        ->required()
        ->type_name("FOLDER|FILE");
    command->add_option("--size", options->size, "Longest side of written textures in texels; each map's own when not given")
        ->check(CLI::Range(1, 16384))
        ->type_name("N");
    command->callback([options, &exitCode] {
        const auto exported = exportScene(*options);
        if (!exported) {
            exitCode = tell(exported.error());
            return;
        }
        tell(exported->warnings, options->common);
        auto files = nlohmann::ordered_json::array();
        for (const auto& file : exported->files)
            files.push_back(file.string());
        if (options->common.json)
            print(nlohmann::ordered_json{{"files", files}, {"warnings", warningsJson(exported->warnings)}});
        else if (!options->common.quiet)
            for (const auto& file : exported->files)
                std::puts(isatty(STDOUT_FILENO) ? escaped(file.string()).c_str() : file.c_str());
    });
}

} // namespace relievo::cli
