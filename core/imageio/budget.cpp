// Limits of the process for one image.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/budget.h"
#include "core/image/files/imageio_protocol.h"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace relievo::imageio {
namespace {
constexpr double kMiB = 1 << 20;
#ifdef __SANITIZE_ADDRESS__
constexpr double kSlow = 10.; // such builds take that much longer
#else
constexpr double kSlow = 1.;
#endif
constexpr double kOpeningSeconds = 3., kSecondsPerMiB = 1.; // of the file
constexpr double kDecodingSeconds = 3., kSecondsPerPixelMiB = 0.25;
constexpr double kOpeningMiB = 192., kDecodingMiB = 384.; // beside what depends on sizes: buffers, stacks and heaps of threads
constexpr double kMostDeflated = 1032.; // bytes that one byte of deflated data can hold

void limitTime(double seconds)
{
    const double most = std::min(seconds * kSlow, 1e6);
    itimerval timer{{0, 0}, {time_t(most), suseconds_t((most - double(time_t(most))) * 1e6)}};
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

double usedMemory() // address space in bytes
{
    double pages = 0.;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * double(::sysconf(_SC_PAGESIZE));
}

// The hard limit stays where main has set it.
void limitMemory([[maybe_unused]] double bytes)
{
#ifndef __SANITIZE_ADDRESS__
    rlimit space{};
    ::getrlimit(RLIMIT_AS, &space);
    space.rlim_cur = bytes < double(space.rlim_max) ? rlim_t(bytes) : space.rlim_max;
    ::setrlimit(RLIMIT_AS, &space);
#endif
}

double sizeOf(const std::string& file)
{
    std::error_code code;
    const std::uintmax_t size = std::filesystem::file_size(file, code);
    return code ? 0. : double(size);
}

// Decoders that begin with the pixels, or that keep all of them, while they open a file.
bool decodesWhenOpened(const FormatRow& format)
{
    return format.name == "jpeg" || format.name == "webp" || format.name == "bmp";
}
} // namespace

Budget::Budget(const FormatRow& format, const std::string& file) : m_isDeflated(format.name == "png"), m_fileBytes(sizeOf(file))
{
    ::signal(SIGPROF, [](int) { ::_exit(kOutOfTime); });
    const bool isWhole = decodesWhenOpened(format);
    limitTime(kOpeningSeconds + kSecondsPerMiB * m_fileBytes / kMiB + (isWhole ? 60. : 0.));
    limitMemory(isWhole ? HUGE_VAL : usedMemory() + kOpeningMiB * kMiB + 4. * m_fileBytes);
}

Budget::~Budget()
{
    limitTime(0.); // no limit
    limitMemory(HUGE_VAL);
}

void Budget::allow(const OIIO::ImageSpec& promised)
{
    const double channels = double(promised.nchannels) * double(std::max<std::size_t>(promised.format.size(), 1));
    const double all = double(promised.width) * double(promised.height) * channels;
    const double pixels = m_isDeflated ? std::min(all, kMostDeflated * m_fileBytes) : all;
    limitTime(kOpeningSeconds + kDecodingSeconds + kSecondsPerMiB * m_fileBytes / kMiB + kSecondsPerPixelMiB * pixels / kMiB);
    limitMemory(usedMemory() + kDecodingMiB * kMiB + 4. * m_fileBytes + 8. * pixels);
}

} // namespace relievo::imageio
