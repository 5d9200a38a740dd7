// An image file that was opened and judged readable: its header, and how its pixels are to be fetched.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/imageio/budget.h"
#include "core/imageio/channel.h"
#include "core/imageio/formats.h"
#include "core/imageio/memory_file.h"
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
    std::shared_ptr<MemoryFile> rewritten; // that is read in place of the file
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    const FormatRow* format = nullptr;
    int part = 0, firstChannel = 0; // of the file, where the channels lie that are read
    PixelType type = PixelType::U8;
    int channels = 1; // that are read, at most 4
    bool threeBytes = false; // whole numbers of 24 bits, whose bytes the library takes in the wrong order
    bool inverted = false; // white is the smallest number, and the library leaves it so
    Window data; // pixels the file holds
    Window shown; // pixels the image is made of; those outside `data` are 0
    int factorX = 1, factorY = 1; // box reduction
    HeaderReply header;
    std::vector<std::string> layers; // names of an EXR file's layers, when there are several
    std::vector<std::pair<std::string, std::string>> warnings; // (code, text)
};

// layer: by its name, of an EXR file; "" for the first one.
tl::expected<Picture, Refusal> openPicture(const std::string& file, const std::string& suffix, const std::string& layer);

// When memory is refused, whether by the Budget or the system.
Refusal tooMuchMemory();

// The library's own words, made into one clause without paths.
Refusal refusalFrom(const FormatRow& format, std::string libraryText, const std::string& file);

} // namespace relievo::imageio
