// What the image library lacks of DDS: uncompressed formats of 16 and 32 bits, and headers that it does not know around data that it does.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/imageio/channel.h"
#include "core/imageio/memory_file.h"
#include <OpenImageIO/imageio.h>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

namespace relievo::imageio {

// How a DDS file is to be opened. All empty: by the library, as it is.
struct DdsPlan {
    std::unique_ptr<OIIO::ImageInput> input; // reads it in place of the library's own reader
    std::shared_ptr<MemoryFile> rewritten; // the same picture under a header that the library knows
    bool premultiplied = false; // its colours, by its alpha
    std::string kind; // of the format, for messages: "DXGI format 99"
};

// The refusal says that this kind is not read, never that the file is damaged.
tl::expected<DdsPlan, Refusal> planDds(const std::string& file);
Refusal unknownDds(const std::string& kind);

} // namespace relievo::imageio
