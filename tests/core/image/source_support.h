// Heights of a source, for tests and benchmarks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/material.h"
#include "core/scene/resources.h"
#include "core/scene/source.h"
#include <string>

namespace relievo::test {

// Of a folder, an image or a key such as sample:bricks. Errors: those of openSource and loadMaterial; there is no height map.
inline Expected<HeightField> heightsOf(const std::string& source)
{
    const auto opened = openSource(source, State());
    if (!opened)
        return tl::unexpected(opened.error());
    const auto material = loadMaterial(opened->state.slots, opened->images);
    if (!material)
        return tl::unexpected(material.error());
    if (!material->height)
        return failure(source, "there is no height map");
    return *material->height;
}

} // namespace relievo::test
