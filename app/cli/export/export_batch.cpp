// Batches: sources found, outputs remembered, processes run.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/export/export_batch.h"
#include "core/exporters/map_images.h"
#include "core/ground/file.h"
#include "core/ground/hash.h"
#include "core/ground/text.h"
#include "core/image/sets/set_plan.h"
#include "core/scene/inputs.h"
#include "core/state/state_json.h"
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace relievo::cli {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
void collect(const fs::path& folder, std::set<fs::path>& seen, std::vector<std::string>& sets)
{
    std::error_code code;
    const fs::path real = fs::canonical(folder, code);
    if (code || !seen.insert(real).second)
        return;
    std::vector<fs::path> below;
    bool hasPictures = false;
    for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
        std::error_code ignored;
        if (at->is_directory(ignored))
            below.push_back(at->path());
        else if (at->is_regular_file(ignored))
            hasPictures = hasPictures || isPicture(at->path());
    }
    if (hasPictures)
        return sets.push_back(folder.string());
    std::ranges::sort(below);
    for (const fs::path& next : below)
        collect(next, seen, sets);
}

std::vector<fs::path> filesOfSource(const std::string& source)
{
    std::error_code code;
    std::vector<fs::path> files;
    if (lowerSuffix(source) == ".relievo") {
        files.emplace_back(source);
        if (const auto read = readState(State(), source))
            for (const fs::path& file : filesOf(read->state))
                files.push_back(file);
        return files;
    }
    const fs::path folder = fs::is_directory(source, code) ? fs::path(source) : fs::path(source).parent_path();
    for (fs::directory_iterator at(folder.empty() ? "." : folder, code), end; !code && at != end; at.increment(code))
        if (std::error_code ignored; at->is_regular_file(ignored))
            files.push_back(at->path());
    std::ranges::sort(files);
    return files;
}

// What the program printed, and how it ended.
struct Ended {
    std::string printed;
    int status = -1;
};
Ended runSelf(const std::vector<std::string>& arguments)
{
    Ended ended;
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return ended;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0); // its errors stand in what it prints
    std::vector<char*> words = {const_cast<char*>("relievo")};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    pid_t process = 0;
    const int failed = ::posix_spawn(&process, "/proc/self/exe", &actions, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    char buffer[4096];
    for (ssize_t size = 0; !failed && ((size = ::read(ends[0], buffer, sizeof buffer)) > 0 || (size < 0 && errno == EINTR));)
        if (size > 0)
            ended.printed.append(buffer, std::size_t(size));
    ::close(ends[0]);
    while (!failed && ::waitpid(process, &ended.status, 0) < 0 && errno == EINTR) { }
    return ended;
}

// The entries that a process printed, one for each of its targets.
Json entriesOf(const BatchTask& task)
{
    const Ended ended = runSelf(task.arguments);
    const Json printed = Json::parse(ended.printed, nullptr, false);
    if (printed.is_object() && printed.contains("exports"))
        return printed["exports"];
    const std::string how = WIFSIGNALED(ended.status) ? " by signal " + std::to_string(WTERMSIG(ended.status)) : "";
    return Json::array({{{"source", task.source}, {"target", ""}, {"files", Json::array()}, {"warnings", Json::array()},
        {"error", task.source + ": the export ended before it was done" + how + ". Export it alone to see why"}}});
}
} // namespace

std::vector<std::string> setsOf(const std::vector<std::string>& sources)
{
    std::set<fs::path> seen;
    std::vector<std::string> sets;
    for (const std::string& source : sources) {
        std::error_code code;
        const std::size_t before = sets.size();
        if (fs::is_directory(source, code))
            collect(source, seen, sets);
        if (sets.size() == before && !(fs::is_directory(source, code) && seen.size() > 1)) // told by whoever opens it
            sets.push_back(source);
    }
    return sets;
}

std::vector<std::string> folderNames(const std::vector<std::string>& sources)
{
    std::set<std::string> taken;
    std::vector<std::string> names;
    for (const std::string& source : sources) {
        std::error_code code;
        const fs::path path = absolutePath(source).lexically_normal();
        const fs::path last = path.has_filename() ? path : path.parent_path();
        const std::string stem = fileStem((fs::is_directory(path, code) ? last.filename() : last.stem()).string());
        std::string name = stem;
        for (int i = 2; !taken.insert(lowered(name)).second; ++i)
            name = stem + '_' + std::to_string(i);
        names.push_back(name);
    }
    return names;
}

std::string contentHash(const std::string& source, const std::string& options)
{
    std::string all = RELIEVO_VERSION "\n" + options + '\n' + source;
    for (const fs::path& file : filesOfSource(source))
        if (const auto bytes = readBytes(file))
            all += '\n' + file.string() + ' ' + hexHash(*bytes);
    return hexHash(all);
}

fs::path hashFile(const fs::path& out)
{
    return out / ".relievo-export.json";
}

bool isUpToDate(const fs::path& out, const std::string& hash)
{
    const Expected<std::string> text = readText(hashFile(out));
    const Json written = text ? Json::parse(*text, nullptr, false) : Json();
    if (!written.is_object() || written.value("hash", "") != hash || !written.contains("files") || !written["files"].is_array())
        return false;
    return std::ranges::all_of(written["files"], [&](const Json& file) {
        std::error_code code;
        return file.is_string() && fs::exists(out / file.get<std::string>(), code);
    });
}

Expected<void> rememberHash(const fs::path& out, const std::string& hash, const std::vector<fs::path>& files)
{
    Json names = Json::array();
    for (const fs::path& file : files)
        names.push_back(file.lexically_relative(out).generic_string());
    return writeAtomically(
        hashFile(out), Json{{"hash", hash}, {"files", names}}.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

Json runBatch(const std::vector<BatchTask>& tasks, int jobs, const std::function<void(const Json&, std::size_t)>& done)
{
    std::vector<Json> entries(tasks.size());
    std::atomic<std::size_t> next = 0;
    std::mutex telling;
    {
        std::vector<std::jthread> workers;
        for (int i = 0; i < std::min(jobs, int(tasks.size())); ++i)
            workers.emplace_back([&] {
                for (std::size_t at = 0; (at = next++) < tasks.size();) {
                    entries[at] = entriesOf(tasks[at]);
                    const std::scoped_lock lock(telling);
                    done(entries[at], at);
                }
            });
    }
    Json all = Json::array();
    for (const Json& some : entries)
        for (const Json& entry : some)
            all.push_back(entry);
    return all;
}

} // namespace relievo::cli
