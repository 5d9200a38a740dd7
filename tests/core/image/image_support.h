// Folders and pictures for the image tests.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/files/image_file.h"
#include "core/image/sets/texture_set.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <unistd.h>

namespace relievo::test {

// A folder that vanishes with the test.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "relievo-test-XXXXXX").string();
        m_path = ::mkdtemp(name.data());
    }
    ~TemporaryFolder()
    {
        std::error_code code;
        std::filesystem::permissions(m_path, std::filesystem::perms::owner_all, code);
        std::filesystem::remove_all(m_path, code);
    }
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

inline std::filesystem::path dataFolder()
{
    return RELIEVO_TEST_DATA;
}

// value(x, y, c) in [0, 1] for every channel value, stored in `type`.
inline Image makeImage(int width, int height, int channels, PixelType type, const std::function<float(int, int, int)>& value)
{
    Image image{width, height, channels, type, int(bytesOf(type)) * 8, type == PixelType::F32, {}};
    image.data.resize(image.texelCount() * std::size_t(channels) * bytesOf(type));
    std::byte* at = image.data.data();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c, at += bytesOf(type)) {
                const float v = value(x, y, c);
                const auto byte = std::uint8_t(type == PixelType::U8 ? std::lround(v * 255.f) : 0);
                const auto word = std::uint16_t(type == PixelType::U16 ? std::lround(v * 65535.f) : 0);
                const void* from = type == PixelType::U8 ? static_cast<const void*>(&byte)
                    : type == PixelType::U16             ? static_cast<const void*>(&word)
                                                         : &v;
                std::memcpy(at, from, bytesOf(type));
            }
    return image;
}

// Noise that uses every bit.
inline Image noiseImage(int width, int height, int channels, PixelType type, unsigned seed = 1)
{
    std::mt19937 random(seed);
    return makeImage(width, height, channels, type, [&](int, int, int) { return float(random() >> 8) / float(1 << 24); });
}

// A surface of gentle hills, its slopes seen as an OpenGL normal map: r = -dh/dx, g = +dh/dy (down).
inline float hill(int x, int y, int size)
{
    const float u = float(x) / float(size) * 6.2831853f, v = float(y) / float(size) * 6.2831853f;
    return 0.5f + 0.2f * std::sin(2 * u + v) + 0.2f * std::sin(3 * v - u);
}
inline Image hillHeights(int size, PixelType type)
{
    return makeImage(size, size, 1, type, [&](int x, int y, int) { return hill(x, y, size); });
}
inline float hillNormal(int x, int y, int c, int size, bool directX)
{
    const float scale = 8.f;
    const float nx = -scale * (hill(x + 1, y, size) - hill(x - 1, y, size));
    const float ny = (directX ? -scale : scale) * (hill(x, y + 1, size) - hill(x, y - 1, size));
    const float length = std::sqrt(nx * nx + ny * ny + 1);
    return (c == 0 ? nx : c == 1 ? ny : 1.f) / length * 0.5f + 0.5f;
}
inline Image hillNormals(int size, bool directX, PixelType type = PixelType::U8)
{
    return makeImage(size, size, 3, type, [&](int x, int y, int c) { return hillNormal(x, y, c, size, directX); });
}

inline std::string readAll(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}
inline void writeAll(const std::filesystem::path& file, const std::string& bytes)
{
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

inline bool tells(const Warnings& warnings, const std::string& code)
{
    return std::ranges::any_of(warnings, [&](const Warning& warning) { return warning.code == code; });
}

constexpr int kSetSize = 64; // of the pictures of a set

// Writes name -> image and opens the folder.
inline Expected<TextureSet> openSet(const TemporaryFolder& folder, const std::map<std::string, Image>& files)
{
    for (const auto& [name, image] : files)
        if (const auto written = writeImage(folder / name, image); !written)
            return tl::unexpected(written.error());
    return openTextureSet(folder.path());
}

} // namespace relievo::test
