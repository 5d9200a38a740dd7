// Prints how different two pictures look, 0 to 1: flip REFERENCE TEST; the mean of FLIP (core/analysis/image_metrics.h).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/image_metrics.h"
#include "core/image/files/image_file.h"
#include <cstdio>

using namespace relievo;

int main(int count, char** arguments)
{
    if (count != 3)
        return std::fprintf(stderr, "flip REFERENCE TEST\n"), 2;
    const auto reference = readImage(arguments[1]), test = readImage(arguments[2]);
    for (const auto* read : {&reference, &test})
        if (!*read)
            return std::fprintf(stderr, "%s\n", message(read->error()).c_str()), 1;
    if (reference->image.width != test->image.width || reference->image.height != test->image.height)
        return std::fprintf(stderr, "the pictures differ in size\n"), 1;
    std::printf("%.4f\n", Flip(reference->image).mean(test->image));
    return 0;
}
