// How long each map takes to bake: seconds by map and field at 1024 x 1024, growth from 256 to 4096, peak memory.
// Usage: bake_bench [--map KEY]... [--sizes N,N,...] [--growth] [-o PLOT.svg] [HEIGHT_MAP...]; --growth leaves out the fields at 1024.
// Text on stdout; the plot shows seconds over size with the line of N^2 log N.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/image/samples/samples.h"
#include "core/maps/maps.h"
#include "core/maps/surface/normal.h"
#include "tests/core/image/source_support.h"
#include "tests/core/maps/maps_support.h"
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <malloc.h>
#include <map>
#include <sstream>
#include <string>

using namespace relievo;

namespace {

struct Time {
    double wall = 0., cpu = 0.;
};

Time bakeTime(const BakedMapRow& row, const HeightField& field)
{
    const Image normals = row.bakeFromNormals ? normalFromHeight(field, 0.08f) : Image();
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    float depth = 0.f;
    const auto map = row.bakeFromNormals ? bakeMapFromNormals(row, normals, Wrap::Repeat, depth) : bakeMap(row, field, Parameters());
    if (!map)
        std::fprintf(stderr, "%s\n", message(map.error()).c_str());
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), double(std::clock() - cpu) / CLOCKS_PER_SEC};
}

// A line of /proc/self/status in MiB; writing 5 to clear_refs sets the peak back to what is in use.
long memoryMiB(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":"))
            return std::stol(line.substr(name.size() + 1)) / 1024;
    return 0;
}

HeightField sample(const SampleRow& row, int size)
{
    const Image image = row.make(size).height;
    return test::fieldOf(size, size, [&](int x, int y) { return image.value(x, y, 0); });
}

struct Named {
    std::string name;
    HeightField field;
};

std::vector<Named> fieldsAt(int size, const std::vector<std::string>& files)
{
    std::vector<Named> fields;
    for (const SampleRow& row : kSamples)
        fields.push_back({"sample:" + std::string(row.key), sample(row, size)});
    for (const test::HardField& hard : test::kHardFields)
        fields.push_back({hard.name, test::hardField(hard, size, size)});
    for (const std::string& file : files) {
        if (const auto heights = test::heightsOf(file))
            fields.push_back({file, *heights});
        else
            std::fprintf(stderr, "%s\n", message(heights.error()).c_str());
    }
    return fields;
}

using Seconds = std::map<int, double>; // CPU seconds by size

// Exponent e of seconds ~ (N^2 log N)^e by least squares in logarithms: at most 1 is no faster than N^2 log N.
double exponent(const Seconds& seconds)
{
    double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    for (const auto& [size, time] : seconds) {
        const double a = std::log(double(size) * size * std::log2(size)), b = std::log(std::max(time, 1e-6));
        n += 1.;
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

using Growth = std::map<std::string, std::map<std::string, Seconds>>; // by map and field

// Seconds over size, both logarithmic; a colour for each map, a line for each field.
std::string plot(const Growth& growth)
{
    constexpr double kLeft = 70., kTop = 20., kWidth = 480., kHeight = 400., kLow = -4., kHigh = 3.; // decades of seconds
    const auto x = [&](double size) { return kLeft + kWidth * std::log2(size / 256.) / 4.; };
    const auto y = [&](double seconds) { return kTop + kHeight * (kHigh - std::clamp(std::log10(seconds), kLow, kHigh)) / (kHigh - kLow); };
    std::ostringstream svg;
    svg << "<svg xmlns='http://www.w3.org/2000/svg' width='760' height='470' font-family='sans-serif' font-size='12'>\n"
           "<rect width='760' height='470' fill='white'/>\n";
    for (const int size : {256, 512, 1024, 2048, 4096})
        svg << "<text x='" << x(size) << "' y='438' text-anchor='middle'>" << size << "</text>\n";
    for (int decade = int(kLow); decade <= int(kHigh); ++decade)
        svg << "<text x='62' y='" << y(std::pow(10., decade)) + 4. << "' text-anchor='end'>" << std::pow(10., decade)
            << "</text>\n<line x1='70' x2='550' y1='" << y(std::pow(10., decade)) << "' y2='" << y(std::pow(10., decade))
            << "' stroke='#ddd'/>\n";
    svg << "<text x='310' y='458' text-anchor='middle'>texels a side; vertical: CPU seconds; dashed: N² log N</text>\n<polyline "
           "fill='none' stroke='black' stroke-dasharray='5 4' points='";
    for (const int size : {256, 512, 1024, 2048, 4096})
        svg << x(size) << ',' << y(double(size) * size * std::log2(size) * 5e-7) << ' ';
    svg << "'/>\n";
    int index = 0;
    for (const auto& [map, fields] : growth) {
        const std::string color = "hsl(" + std::to_string(index * 360 / int(growth.size())) + ",70%,42%)";
        svg << "<text x='565' y='" << 30 + 16 * index++ << "' fill='" << color << "'>" << map << "</text>\n";
        for (const auto& [field, seconds] : fields) {
            svg << "<polyline fill='none' stroke='" << color << "' points='";
            for (const auto& [size, time] : seconds)
                svg << x(size) << ',' << y(time) << ' ';
            svg << "'><title>" << map << ", " << field << "</title></polyline>\n";
        }
    }
    svg << "</svg>\n";
    return svg.str();
}

struct Options {
    std::vector<std::string> maps, files;
    bool growth = false; // only
    std::vector<int> sizes{256, 512, 1024, 2048, 4096};
    std::string plot;
};

Options parsed(int argc, char** argv)
{
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const std::string value = i + 1 < argc ? argv[i + 1] : "";
        if (word == "--map")
            options.maps.push_back(value), ++i;
        else if (word == "--growth")
            options.growth = true;
        else if (word == "-o")
            options.plot = value, ++i;
        else if (word == "--sizes") {
            options.sizes.clear();
            std::istringstream list(value);
            for (std::string size; std::getline(list, size, ',');)
                options.sizes.push_back(std::stoi(size));
            ++i;
        } else
            options.files.push_back(word);
    }
    return options;
}

} // namespace

int main(int argc, char** argv)
{
    const Options options = parsed(argc, argv);
    Growth growth;
    const std::vector<Named> fields = options.growth ? std::vector<Named>() : fieldsAt(1024, options.files);
    for (const BakedMapRow& row : kBakedMaps) {
        const std::string key(row.key);
        if (!options.maps.empty() && std::ranges::find(options.maps, key) == options.maps.end())
            continue;
        for (const Named& named : fields) {
            malloc_trim(0);
            std::ofstream("/proc/self/clear_refs") << 5;
            const long before = memoryMiB("VmRSS");
            const Time time = bakeTime(row, named.field);
            std::printf("%-18s %-44s %5dx%-5d %8.3f s  %8.3f CPU s  +%ld MiB\n", key.c_str(), named.name.c_str(), named.field.width(),
                named.field.height(), time.wall, time.cpu, std::max(0l, memoryMiB("VmHWM") - before));
            std::fflush(stdout);
        }
        for (const char* name : {"bricks", "rough hills", "noise", "low domes"}) {
            Seconds& seconds = growth[key][name];
            for (const int size : options.sizes) {
                const auto hard
                    = std::ranges::find_if(test::kHardFields, [&](const test::HardField& f) { return f.name == std::string(name); });
                const HeightField field
                    = hard == test::kHardFields.end() ? sample(*findSample(name), size) : test::hardField(*hard, size, size);
                seconds[size] = bakeTime(row, field).cpu;
                std::printf("%-18s %-20s %5d %10.3f CPU s\n", key.c_str(), name, size, seconds[size]);
                std::fflush(stdout);
            }
            if (seconds.size() > 1)
                std::printf("%-18s %-20s CPU seconds grow as (N^2 log N)^%.2f\n", key.c_str(), name, exponent(seconds));
        }
    }
    if (!options.plot.empty() && !writeAtomically(options.plot, plot(growth)))
        return 1;
}
