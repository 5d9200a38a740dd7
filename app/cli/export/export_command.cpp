// relievo export: rows of the export table, or a user's own, of one source or of many.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/export/export_batch.h"
#include "core/exporters/engines/target_text.h"
#include "core/exporters/exporters.h"
#include "core/exporters/map_images.h"
#include "core/ground/file.h"
#include "core/ground/hash.h"
#include "core/ground/shown_text.h"
#include "core/ground/text.h"
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <unistd.h>

namespace relievo::cli {

namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ExportOptions {
    Common common;
    StateOptions state;
    std::vector<std::string> sources, targets, with, without;
    std::string out, packing, shard;
    int size = 0, jobs = 1;
    bool resume = false;
    std::vector<std::string> given; // the arguments as typed, without sources, -o and those of the batch
};

// --target: keys and files.
Result<std::vector<const ExportRow*>> targetsOf(const ExportOptions& options)
{
    std::vector<const ExportRow*> rows;
    for (const std::string& name : options.targets) {
        const bool isFile = lowerSuffix(name) == ".json" || lowerSuffix(name) == ".tpl";
        if (isFile) {
            const auto own = ownTarget(name);
            if (!own)
                return problem(own.error());
            rows.push_back(*own);
        } else if (const ExportRow* row = findExport(name)) {
            rows.push_back(row);
        } else {
            return problem({"there is no such target", "--target " + name, "relievo describe exports lists them"}, WrongUsage);
        }
    }
    return rows;
}

Result<EnumSet<Cure>> curesOf(const ExportOptions& options)
{
    const auto named = [](const std::vector<std::string>& words, Cure cure) { return std::ranges::count(words, wordOf(cure)) > 0; };
    EnumSet<Cure> cures;
    std::string all;
    for (std::size_t i = 0; i < kChoices<Cure>; ++i) {
        const Cure cure = Cure(i);
        all += (i == 0 ? "There are " : ", ") + std::string(wordOf(cure));
        if ((kCures[cure].byDefault || named(options.with, cure)) && !named(options.without, cure))
            cures.insert(cure);
    }
    for (const auto& [option, words] : {std::pair("--with ", &options.with), std::pair("--without ", &options.without)})
        for (const std::string& word : *words)
            if (!choiceOf<Cure>(word))
                return problem({"there is no such cure", option + word, all}, WrongUsage);
    return cures;
}

Json entry(const std::string& source, std::string_view target)
{
    return {{"source", source}, {"target", target}, {"files", Json::array()}, {"warnings", Json::array()}, {"error", nullptr}};
}

// What goes where: the one target of one source to -o itself, several to folders in it.
fs::path placeOf(const ExportOptions& options, const ExportRow& row, std::size_t targets, const std::string& name)
{
    if (targets == 1)
        return options.out;
    const fs::path folder = fs::path(options.out) / std::string(row.key);
    return row.suffix.empty() ? folder : folder / (fileStem(name) + std::string(row.suffix));
}

struct Written {
    Json entries = Json::array();
    std::optional<Problem> failed; // the first that did
};

// All targets of one source. What they have in common is told with the first.
Result<Written> exportScene(const ExportOptions& options, const std::vector<const ExportRow*>& rows)
{
    for (const ExportRow* row : rows)
        if (rows.size() == 1 && !row->takes(options.out))
            return problem({"this target writes " + std::string(row->suffix)
                                   + (row->otherSuffix.empty() ? "" : " or " + std::string(row->otherSuffix)),
                               "-o " + options.out, "Give the file that suffix"},
                WrongUsage);
    std::optional<TargetText> packing;
    if (!options.packing.empty()) {
        auto read = readPacking(options.packing);
        if (!read)
            return problem(read.error());
        packing = std::move(*read);
    }
    const auto cures = curesOf(options);
    if (!cures)
        return tl::unexpected(cures.error());
    const Progress progress = shownProgress(options.common);
    const auto scene = openScene(options.state, progress.part(0.f, 0.5f), false); // targets bake of the heights that they write
    if (!scene)
        return tl::unexpected(scene.error());
    Written written;
    WrittenPictures pictures;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float from = 0.5f + 0.5f * float(i) / float(rows.size()), to = 0.5f + 0.5f * float(i + 1) / float(rows.size());
        const fs::path out = placeOf(options, *rows[i], rows.size(), scene->state.name);
        const auto exported = rows[i]->run({scene->state, scene->resources, out, options.size, progress.part(from, to),
            options.state.filesRead(), *cures, &pictures, packing ? &*packing : nullptr});
        Json told = entry(options.state.source, rows[i]->key);
        Warnings warnings = i == 0 ? scene->warnings : Warnings();
        if (exported) {
            for (const fs::path& file : exported->files)
                told["files"].push_back(file.string());
            warnings.insert(warnings.end(), exported->warnings.begin(), exported->warnings.end());
        } else {
            told["error"] = message(exported.error());
            if (!written.failed)
                written.failed = Problem{exported.error()};
        }
        told["warnings"] = warningsJson(warnings);
        tell(warnings, options.common);
        written.entries.push_back(std::move(told));
    }
    progress.at(1.f);
    return written;
}

int exportOne(const ExportOptions& options, const std::vector<const ExportRow*>& rows)
{
    const auto written = exportScene(options, rows);
    if (!written && (!options.common.json || written.error().exitCode == WrongUsage))
        return tell(written.error());
    Json entries = written ? written->entries : Json::array();
    if (!written)
        for (const ExportRow* row : rows) {
            entries.push_back(entry(options.state.source, row->key));
            entries.back()["error"] = message(written.error().error);
        }
    if (options.common.json)
        print(Json{{"exports", entries}});
    else if (!options.common.quiet)
        for (const Json& one : entries)
            for (const Json& file : one["files"])
                std::puts(isatty(STDOUT_FILENO) ? escaped(file.get<std::string>()).c_str() : file.get<std::string>().c_str());
    if (!written)
        return tell(written.error());
    return written->failed ? tell(*written->failed) : int(Done);
}

// K/N of --shard.
Result<std::pair<int, int>> shardOf(const std::string& text)
{
    int k = 1, n = 1, read = 0;
    if (!text.empty() && (std::sscanf(text.c_str(), "%d/%d%n", &k, &n, &read) != 2 || std::size_t(read) != text.size() || k < 1 || n < k))
        return problem({"it must be K/N with K from 1 to N", "--shard " + text, "2/4 is the second of four parts"}, WrongUsage);
    return std::pair(k, n);
}

std::string lineOf(const Json& one)
{
    const std::string source = one["source"].get<std::string>(), target = one["target"].get<std::string>();
    return source + (target.empty() ? "" : "  " + target) + "  "
        + (one["error"].is_null() ? one.value("unchanged", false) ? "unchanged" : std::to_string(one["files"].size()) + " files"
                                  : "failed");
}

void tellBatch(const Json& entries, const Common& common)
{
    if (common.json)
        return print(Json{{"exports", entries}});
    for (const Json& one : entries)
        if (!one["error"].is_null())
            std::fprintf(stderr, "relievo: error: %s\n", one["error"].get<std::string>().c_str());
}

// The arguments of the process that exports one source, and where to.
BatchTask taskOf(const ExportOptions& options, const std::vector<const ExportRow*>& rows, const std::string& source, const fs::path& folder)
{
    const bool isFile = rows.size() == 1 && !rows.front()->suffix.empty();
    const fs::path out = isFile ? folder / (folder.filename().string() + std::string(rows.front()->suffix)) : folder;
    BatchTask task{source, {"export", source, "-o", out.string(), "--json"}};
    task.arguments.insert(task.arguments.end(), options.given.begin(), options.given.end());
    return task;
}

int exportBatch(const ExportOptions& options, const std::vector<const ExportRow*>& rows, const std::vector<std::string>& sets)
{
    const auto shard = shardOf(options.shard);
    if (!shard)
        return tell(shard.error());
    std::string decides;
    for (const std::string& argument : options.given) { // files that they name may change
        const auto bytes = readBytes(argument);
        decides += argument + (bytes ? ' ' + hexHash(*bytes) : "") + '\n';
    }
    const std::vector<std::string> names = folderNames(sets); // of all shards alike
    std::vector<BatchTask> tasks;
    std::vector<std::pair<fs::path, std::string>> places; // of each task, and its hash
    Json entries = Json::array();
    for (std::size_t i = std::size_t(shard->first - 1); i < sets.size(); i += std::size_t(shard->second)) {
        const fs::path folder = fs::path(options.out) / names[i];
        const std::string hash = contentHash(sets[i], decides);
        if (options.resume && isUpToDate(folder, hash)) {
            entries.push_back(entry(sets[i], options.targets.size() == 1 ? rows.front()->key : ""));
            entries.back()["unchanged"] = true;
            continue;
        }
        std::error_code code;
        fs::remove(hashFile(folder), code); // until it is whole again
        tasks.push_back(taskOf(options, rows, sets[i], folder));
        places.emplace_back(folder, hash);
    }
    for (const Json& one : entries)
        if (!options.common.json && !options.common.quiet)
            std::puts(escaped(lineOf(one)).c_str());
    const Progress progress = shownProgress(options.common);
    std::size_t done = 0;
    const Json made = runBatch(tasks, options.jobs, [&](const Json& some, std::size_t task) {
        std::vector<fs::path> files;
        bool well = true;
        for (const Json& one : some) {
            well = well && one["error"].is_null();
            for (const Json& file : one["files"])
                files.emplace_back(file.get<std::string>());
            if (!options.common.json && !options.common.quiet)
                std::puts(escaped(lineOf(one)).c_str());
        }
        if (well) // where it cannot be remembered it is written again the next time
            (void)rememberHash(places[task].first, places[task].second, files);
        progress.at(float(++done) / float(tasks.size()));
    });
    entries.insert(entries.end(), made.begin(), made.end());
    tellBatch(entries, options.common);
    return std::ranges::all_of(entries, [](const Json& one) { return one["error"].is_null(); }) ? Done : Failed;
}

// The arguments that hold for each source of a batch.
std::vector<std::string> argumentsFor(const CLI::App& command)
{
    std::vector<std::string> arguments;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || option->get_positional() || name == "-o" || name == "--jobs" || name == "--resume" || name == "--shard"
            || name == "--json" || name == "--progress" || name == "--quiet")
            continue;
        for (const std::string& value : option->results()) {
            arguments.push_back(name);
            arguments.push_back(value);
        }
    }
    return arguments;
}

int exportAll(ExportOptions& options, const CLI::App& command)
{
    const auto rows = targetsOf(options);
    if (!rows)
        return tell(rows.error());
    const std::vector<std::string> sets = setsOf(options.sources);
    if (sets.size() > 1 || options.resume || !options.shard.empty()) {
        options.given = argumentsFor(command);
        return exportBatch(options, *rows, sets);
    }
    options.state.source = sets.empty() ? "" : sets.front();
    return exportOne(options, *rows);
}

} // namespace

void addExport(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand("export", "Writes materials for other programs");
    options->state.addTo(*command, &options->sources);
    options->common.addTo(*command);
    command
        ->add_option(
            "--target", options->targets, "What to write, see relievo describe exports; a .json or .tpl of your own; several by commas")
        ->required()
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("KEY|FILE[,...]");
    options->state
        .addOutput(*command, "-o", options->out, "File or folder to write, as the target wants; of several sources or targets a folder")
        ->required()
        ->type_name("FOLDER|FILE");
    command->add_option("--size", options->size, "Longest side of written textures in texels; each map's own when not given")
        ->check(CLI::Range(1, 16384))
        ->type_name("N");
    options->state.addInput(*command, "--packing", options->packing, "Textures to write in place of the target's, as JSON")
        ->type_name("FILE");
    command->add_option("--with", options->with, "Does more to what is written: bump names glTF's heights as EXT_materials_bump too")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("CURE[,...]");
    command
        ->add_option(
            "--without", options->without, "Leaves the maps as they are in one way: full-range, normals or dither; several by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("CURE[,...]");
    command->add_option("--jobs", options->jobs, "Sources that are exported at once")->check(CLI::Range(1, 256))->type_name("N");
    command->add_flag("--resume", options->resume, "Writes only what is missing or has changed");
    command->add_option("--shard", options->shard, "Only part K of N of the sources")->type_name("K/N");
    command->callback([options, command, &exitCode] { exitCode = exportAll(*options, *command); });
}

} // namespace relievo::cli
