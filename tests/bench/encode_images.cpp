// The least that writing pictures can cost: OpenImageIO alone, each file that is given encoded once more from its pixels, in its own
// format and precision and as the editor sets it. Prints the CPU ms of encoding; decoding is not counted.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <cstdio>
#include <ctime>
#include <vector>

namespace {
double cpuMs()
{
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

bool encode(const char* format, const OIIO::ImageSpec& spec, const std::vector<char>& pixels)
{
    OIIO::Filesystem::IOVecOutput memory;
    const auto out = OIIO::ImageOutput::create(format);
    return out && out->set_ioproxy(&memory) && out->open(format, spec) && out->write_image(spec.format, pixels.data()) && out->close();
}
} // namespace

int main(int argc, char** argv)
{
    double spent = 0;
    for (int i = 1; i < argc; ++i) {
        const auto in = OIIO::ImageInput::open(argv[i]);
        if (!in)
            return 1;
        OIIO::ImageSpec spec(in->spec().width, in->spec().height, in->spec().nchannels, in->spec().format);
        std::vector<char> pixels(spec.image_bytes());
        if (!in->read_image(0, 0, 0, spec.nchannels, spec.format, pixels.data()))
            return 1;
        const char* const format = in->format_name();
        if (std::string_view(format) == "jpeg")
            spec.attribute("Compression", "jpeg:95");
        const double before = cpuMs();
        if (!encode(format, spec, pixels)) {
            std::fprintf(stderr, "%s cannot be encoded\n", argv[i]);
            return 1;
        }
        spent += cpuMs() - before;
    }
    std::printf("%.0f\n", spent);
}
