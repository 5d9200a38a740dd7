// Every mesh and every damaged file beside the checkout: opened or refused in one sentence, never worse.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "tests/program/run.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const fs::path kData = RELIEVO_TEST_DATA;
#ifdef __SANITIZE_ADDRESS__ // some three times slower; an eighth more memory for its shadow, and 256 MiB of what was freed in each process
constexpr int kSeconds = 90;
constexpr long kMemoryMiB = 4 * 1024;
#else
constexpr int kSeconds = 30; // the image helper is given up after 20 without progress
constexpr long kMemoryMiB = 3 * 1024;
#endif

bool listed(const std::string& list, const fs::path& file)
{
    return file.has_extension() && (" " + list + " ").find(" " + file.extension().string() + " ") != std::string::npos;
}
bool isImage(const fs::path& file)
{
    return listed(".png .tif .exr .tga .dds .hdr", file);
}
bool isMesh(const fs::path& file)
{
    return listed(".gltf .glb .obj .ply .off .stl", file);
}

// All meshes, and the images that stand for themselves: those in meshes/ are textures.
std::vector<fs::path> filesBelow(const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code code;
    for (const auto& entry : fs::recursive_directory_iterator(folder, code))
        if ((isImage(entry.path()) && folder.filename() != "meshes") || isMesh(entry.path()))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// The folders of broken/, and the sound meshes.
std::vector<std::string> folders()
{
    std::vector<std::string> names;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(kData / "broken", code))
        if (entry.is_directory())
            names.push_back("broken/" + entry.path().filename().string());
    if (fs::exists(kData / "meshes", code))
        names.push_back("meshes");
    std::sort(names.begin(), names.end());
    return names;
}

std::string quoted(const fs::path& file)
{
    return '"' + file.string() + '"';
}

// A sanitizer's report is a fault unless it begins in a library: a decoder that breaks is what the helper process is for.
bool accusesUs(const std::string& report)
{
    if (report.find("runtime error:") != report.npos || report.find("LeakSanitizer") != report.npos)
        return true;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        const bool runtime
            = line.find("libsanitizer") != line.npos || line.find("libasan") != line.npos || line.find("libc.so") != line.npos;
        if (line.starts_with("    #") && !runtime)
            return line.find("(/lib") == line.npos && line.find("(/usr/lib") == line.npos;
    }
    return report.find("rss limit") == report.npos; // of unknown origin
}

// Collects what the sanitizers of the programs and of their helpers say, whose stderr nobody sees.
class SanitizerReports {
public:
    explicit SanitizerReports(const TestFolder& folder) : m_folder(folder / "reports")
    {
        fs::create_directories(m_folder);
        set("ASAN_OPTIONS");
        set("UBSAN_OPTIONS");
        set("LSAN_OPTIONS");
    }
    ~SanitizerReports()
    {
        for (const auto& [name, value] : m_before)
            value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    }

    // What accuses our code since the last call; "" for nothing.
    std::string take()
    {
        std::string text;
        for (const auto& entry : fs::directory_iterator(m_folder)) {
            const std::string report = relievo::readText(entry.path()).value_or("");
            if (accusesUs(report))
                text += report;
            fs::remove(entry.path());
        }
        return text;
    }

private:
    void set(const std::string& name)
    {
        const char* before = getenv(name.c_str());
        m_before.emplace_back(name, before ? before : "");
        setenv(name.c_str(), ((before ? before + std::string(":") : "") + "log_path=" + (m_folder / "report").string()).c_str(), 1);
    }
    fs::path m_folder;
    std::vector<std::pair<std::string, std::string>> m_before;
};

// Exit code 0 with a result, or 1 with one sentence that names the file.
void expectSound(const ProgramRun& run, const fs::path& file, SanitizerReports& reports)
{
    EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 1) << file << " ends with " << run.exitCode << ' ' << run.err;
    EXPECT_LT(peakMemoryMiB(), kMemoryMiB) << file;
    EXPECT_EQ(reports.take(), "") << file;
    if (run.exitCode != 1)
        return;
    EXPECT_EQ(run.err.rfind("relievo: error: ", 0), 0u) << run.err;
    EXPECT_NE(run.err.find(file.filename().string()), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.err.find("internal fault"), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "") << file;
}

// Something is to be seen, and every value is a number.
void expectPicture(const fs::path& picture, const fs::path& file)
{
    const auto read = relievo::readImage(picture);
    ASSERT_TRUE(read) << file;
    const relievo::Image& image = read->image;
    float low = INFINITY, high = -INFINITY;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c) {
                const float value = image.value(x, y, c);
                ASSERT_TRUE(std::isfinite(value)) << file << " at " << x << ", " << y;
                low = c == 0 ? std::min(low, value) : low;
                high = c == 0 ? std::max(high, value) : high;
            }
    EXPECT_LT(low, high) << file;
}

class BrokenFolder : public testing::TestWithParam<std::string> { };

} // namespace

TEST(BrokenFiles, AreThere)
{
    if (folders().empty())
        GTEST_SKIP() << "no broken files and no meshes at " << kData;
    SUCCEED();
}

// `info` of a file that opens tells what is in it, or what is wrong with it.
TEST_P(BrokenFolder, InfoOpensOrRefuses)
{
    TestFolder folder("broken_info");
    SanitizerReports reports(folder);
    const bool mustOpen = GetParam().find("_valid_") != std::string::npos;
    for (const fs::path& file : filesBelow(kData / GetParam())) {
        const ProgramRun run = runRelievo("info --json " + quoted(file), kSeconds);
        expectSound(run, file, reports);
        if (mustOpen) {
            EXPECT_EQ(run.exitCode, 0) << run.err;
        }
        if (run.exitCode != 0)
            continue;
        const json found = json::parse(run.out, nullptr, false);
        ASSERT_TRUE(found.is_object()) << run.out;
        EXPECT_TRUE(isMesh(file) ? found.value("triangles", 0) > 0 : found["maps"].size() == 1u) << run.out;
    }
}

// What `info` opens, `render` shows, by itself (images) or as a mesh under a sample; nothing else is left behind.
TEST_P(BrokenFolder, RenderShowsOrRefuses)
{
    TestFolder folder("broken_render");
    SanitizerReports reports(folder);
    const fs::path out = folder / "out";
    fs::create_directories(out);
    for (const fs::path& file : filesBelow(kData / GetParam())) {
        const std::string source = isMesh(file) ? "sample:bricks@64 --mesh " + quoted(file) : quoted(file);
        // Display values, and linear floats where NaN would show.
        for (const fs::path& picture : isMesh(file) ? std::vector{out / "x.exr"} : std::vector{out / "x.png", out / "x.exr"}) {
            const ProgramRun run = runRelievo("render " + source + " --size 64x48 --samples 1 -o " + picture.string(), kSeconds);
            expectSound(run, file, reports);
            if (run.exitCode != 0)
                break;
            expectPicture(picture, file);
            fs::remove(picture);
        }
        EXPECT_TRUE(fs::is_empty(out)) << file;
    }
}

INSTANTIATE_TEST_SUITE_P(BrokenFiles, BrokenFolder, testing::ValuesIn(folders()), [](const auto& instance) {
    std::string name = instance.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BrokenFolder);

TEST(BrokenFiles, NastyFloatsAreRepairedAndTold)
{
    const fs::path nasty = kData / "broken/exr_valid_but_nasty";
    if (!fs::exists(nasty))
        GTEST_SKIP() << "no broken files at " << nasty;
    for (const char* name : {"AllHalfValues.exr", "BrightRingsNanInf.exr"}) {
        const ProgramRun run = runRelievo("info " + quoted(nasty / name), kSeconds);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_NE(run.out.find("not a number"), std::string::npos) << run.out;
    }
    for (const char* name : {"t05.exr", "t09.exr"})
        EXPECT_NE(runRelievo("info " + quoted(nasty / name), kSeconds).out.find("display window"), std::string::npos) << name;
}
