// The least that reading a texture set can cost: OpenImageIO alone, each file in its own precision.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenImageIO/imageio.h>
#include <vector>

int main(int argc, char** argv)
{
    for (int i = 1; i < argc; ++i) {
        const auto in = OIIO::ImageInput::open(argv[i]);
        if (!in)
            return 1;
        const OIIO::ImageSpec spec = in->spec();
        std::vector<char> pixels(spec.image_bytes(true));
        if (!in->read_image(0, 0, 0, spec.nchannels, spec.format, pixels.data()))
            return 1;
    }
}
