// Asking the system.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/file_stamps.h"
#include "core/gltf/buffers.h"
#include "core/gltf/pictures.h"
#include "core/state/environments.h"
#include "core/state/sample_names.h"
#include "core/state/shapes.h"
#include <algorithm>
#include <sys/stat.h>

namespace relievo {
namespace fs = std::filesystem;
namespace {
std::int64_t nanoseconds(const timespec& time)
{
    return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

FileStamp stampOfFile(const fs::path& file)
{
    struct stat told = {};
    if (::stat(file.c_str(), &told) != 0 || !S_ISREG(told.st_mode))
        return {};
    return {true, told.st_size, nanoseconds(told.st_mtim), nanoseconds(told.st_ctim)};
}
} // namespace

FileStamp stampOf(const std::string& name)
{
    return stampOfFile(fileOfPicture(name));
}

FileStamps stampsOf(const State& state)
{
    FileStamps stamps;
    for (const MapSlot& slot : state.slots)
        if (!slot.empty() && !namesSample(slot.file))
            stamps[slot.file] = stampOf(slot.file);
    if (!isBuiltInMesh(state.mesh))
        stamps[state.mesh] = stampOf(state.mesh);
    for (const fs::path& file : buffersBeside(state.mesh))
        stamps[file.string()] = stampOfFile(file);
    if (!isBuiltInEnvironment(state.environment))
        stamps[state.environment] = stampOf(state.environment);
    return stamps;
}

FileStamps stampsIn(const fs::path& folder)
{
    FileStamps stamps;
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
        stamps[entry->path().string()] = stampOfFile(entry->path());
    return stamps;
}

FileNames namesOf(const FileStamps& stamps)
{
    FileNames names;
    for (const auto& [name, stamp] : stamps)
        names.insert(name);
    return names;
}

FileNames changedSince(const FileStamps& stamps)
{
    FileNames changed;
    for (const auto& [name, stamp] : stamps)
        if (stampOf(name) != stamp)
            changed.insert(name);
    return changed;
}

} // namespace relievo
