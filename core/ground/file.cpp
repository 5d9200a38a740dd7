// Reading files whole, and replacing them so that nothing is ever half-written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace relievo {
namespace fs = std::filesystem;

namespace {
template <class Container> Expected<Container> readWhole(const fs::path& file, std::size_t limit)
{
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status))
        return failure(ErrorCode::NotFound, file.string(), "there is no such file", "Check the path");
    if (fs::is_directory(status))
        return failure(file.string(), "this is a folder, not a file", "Name a file in it");
    if (!fs::is_regular_file(status))
        return failure(file.string(), "this is a pipe or a device, not a file", "Save its content to a file first");
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in)
        return failure(ErrorCode::Unreadable, file.string(), std::string("the file cannot be read (") + std::strerror(errno) + ")",
            "Check its permissions");
    const auto size = in.tellg();
    if (size < 0 || std::size_t(size) > limit)
        return failure(file.string(), "the file is too large", "The limit is " + std::to_string(limit >> 20) + " MiB");
    Container content;
    content.resize(std::size_t(size));
    in.seekg(0);
    in.read(reinterpret_cast<char*>(content.data()), size);
    if (in.gcount() != size)
        return failure(ErrorCode::Unreadable, file.string(), "the file could not be read to its end", "Check the disk");
    return content;
}

// Closes and removes the temporary file unless it was renamed into place.
struct Temporary {
    fs::path path;
    int handle = -1;
    ~Temporary()
    {
        if (handle >= 0)
            ::close(handle);
        if (!path.empty())
            ::unlink(path.c_str());
    }
};

tl::unexpected<Error> writeFailure(const fs::path& file)
{
    const int code = errno;
    const bool isFull = code == ENOSPC || code == EDQUOT;
    const char* hint = isFull ? "Free some space or choose another disk"
        : code == ENOENT      ? "Create the folder first"
                              : "Choose a folder that you may write to";
    return failure(isFull ? ErrorCode::NoSpace : ErrorCode::NotWritable, file.string(),
        std::string("the file cannot be written (") + std::strerror(code) + ")", hint);
}

bool writeAll(int handle, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(handle, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        bytes = bytes.subspan(std::size_t(written));
    }
    return true;
}

Expected<void> writeThrough(const fs::path& file, std::span<const std::byte> bytes)
{
    const int handle = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (handle < 0)
        return writeFailure(file);
    const Temporary open{{}, handle};
    return writeAll(handle, bytes) ? Expected<void>() : writeFailure(file);
}

// Where the file's links lead, though nothing need be there yet.
Expected<fs::path> targetOf(fs::path file)
{
    constexpr int kMostLinks = 40; // as the system follows
    std::error_code code;
    for (int links = 0; fs::is_symlink(fs::symlink_status(file, code)); ++links) {
        if (links == kMostLinks) {
            errno = ELOOP;
            return writeFailure(file);
        }
        file = file.parent_path() / fs::read_symlink(file, code);
    }
    return file;
}

// mkstemp makes files private: a saved file keeps the old one's rights, a new one gets those that any new file would get.
mode_t modeFor(const fs::path& target)
{
    struct stat old = {};
    if (::stat(target.c_str(), &old) == 0)
        return old.st_mode & 0777;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}
} // namespace

fs::path absolutePath(const fs::path& file)
{
    std::error_code code;
    const fs::path path = fs::absolute(file, code);
    if (code)
        return file;
    fs::path plain;
    for (const fs::path& part : path)
        if (part == "..") { // the parent of where a link leads, not of the link
            const fs::path above = fs::weakly_canonical(plain / part, code);
            plain = code ? plain.parent_path() : above;
        } else if (!part.empty() && part != ".")
            plain /= part;
    return plain;
}

Expected<std::string> readText(const fs::path& file, std::size_t limit)
{
    return readWhole<std::string>(file, limit);
}
Expected<std::vector<std::byte>> readBytes(const fs::path& file, std::size_t limit)
{
    return readWhole<std::vector<std::byte>>(file, limit);
}

Expected<void> writeAtomically(const fs::path& file, std::span<const std::byte> bytes)
{
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (fs::is_directory(status))
        return failure(file.string(), "this is a folder, not a file", "Name a file");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return writeThrough(file, bytes);
    const Expected<fs::path> target = targetOf(file);
    if (!target)
        return tl::unexpected(target.error());
    std::string name = (target->parent_path() / kTemporaryName).string(); // short, whatever the file's name
    Temporary temporary;
    temporary.handle = ::mkstemp(name.data());
    if (temporary.handle < 0)
        return writeFailure(file);
    temporary.path = name;
    if (!writeAll(temporary.handle, bytes))
        return writeFailure(file);
    if (::fchmod(temporary.handle, modeFor(*target)) != 0 || ::fsync(temporary.handle) != 0)
        return writeFailure(file);
    if (::rename(name.c_str(), target->c_str()) != 0)
        return writeFailure(file);
    temporary.path.clear();
    return {};
}

Expected<void> writeAtomically(const fs::path& file, std::string_view text)
{
    return writeAtomically(file, std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace relievo
