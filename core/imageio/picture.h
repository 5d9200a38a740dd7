// An image file that was opened and judged readable: its header, and how its pixels are to be fetched.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/imageio/budget.h"
#include "core/imageio/channel.h"
#include "core/imageio/formats.h"
#include <OpenImageIO/imageio.h>
#include <memory>
#include <tl/expected.hpp>

namespace relievo::imageio {

// A rectangle of texels.
struct Window {
    int x = 0, y = 0, width = 0, height = 0; // texels; y down
    bool operator==(const Window&) const = default;
};

struct Picture {
    std::unique_ptr<Budget> budget; // before what it bounds
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    const FormatRow* format = nullptr;
    PixelType type = PixelType::U8;
    int channels = 1; // that are read, at most 4
    Window data; // pixels the file holds
    Window shown; // pixels the image is made of; those outside `data` are 0
    int factorX = 1, factorY = 1; // box reduction
    HeaderReply header;
    std::vector<std::pair<std::string, std::string>> warnings; // (code, text)
};

tl::expected<Picture, Refusal> openPicture(const std::string& file, const std::string& suffix);

// When memory is refused, whether by the Budget or the system.
Refusal tooMuchMemory();

// The library's own words, made into one clause without paths.
Refusal refusalFrom(const FormatRow& format, std::string libraryText, const std::string& file);

} // namespace relievo::imageio
