// What decoding one image may take of time and memory: as much as its file's size and the pixels that its header promises can need.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/imageio/formats.h"
#include <OpenImageIO/imageio.h>
#include <string>

namespace relievo::imageio {

// Bounds this process while it lives, one at a time. Memory beyond it is refused, as std::bad_alloc or in the decoder's own words; when the
// time (of all threads, on the processor) is over, the process ends with the code kOutOfTime. The bounds are generous: they are for files
// of a few bytes that cost gigabytes. Under AddressSanitizer memory is not bounded.
class Budget {
public:
    Budget(const FormatRow& format, const std::string& file); // for opening the file
    ~Budget();
    Budget(const Budget&) = delete;
    Budget& operator=(const Budget&) = delete;
    void allow(const OIIO::ImageSpec& promised); // from now on for decoding it, too

private:
    bool m_isDeflated;
    double m_fileBytes;
};

} // namespace relievo::imageio
