// What the tests of mesh files share: files written for one test, and what must hold of any mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

namespace relievo {

// A folder that vanishes with the test.
struct Scratch {
    std::filesystem::path path;
    Scratch()
    {
        std::string name = (std::filesystem::temp_directory_path() / "relievo-mesh-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Scratch()
    {
        std::error_code code;
        std::filesystem::remove_all(path, code);
    }
    std::string write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return (path / name).string();
    }
};

inline Expected<Mesh> opened(const std::string& name, const std::string& bytes)
{
    const Scratch scratch;
    return openMesh(scratch.write(name, bytes));
}

inline bool told(const Mesh& mesh, std::string_view code)
{
    return std::ranges::any_of(mesh.warnings, [code](const Warning& w) { return w.code == code && !w.text.empty(); });
}

// Every promise of mesh.h that must hold whatever the file was.
inline void expectSound(const Mesh& mesh)
{
    ASSERT_FALSE(mesh.indices.empty());
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    EXPECT_GT(mesh.metresPerUV, 0.f);
    EXPECT_TRUE(std::isfinite(mesh.metresPerUV));
    for (const std::uint32_t index : mesh.indices)
        ASSERT_LT(index, mesh.vertices.size());
    for (const Vertex& v : mesh.vertices) {
        ASSERT_TRUE(std::isfinite(glm::dot(v.position, v.position)));
        ASSERT_NEAR(glm::length(v.normal), 1.f, 1e-3f);
        ASSERT_TRUE(std::isfinite(v.uv.x) && std::isfinite(v.uv.y));
        ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1.f, 1e-3f);
        ASSERT_EQ(std::abs(v.tangent.w), 1.f);
        ASSERT_GT(glm::length(glm::cross(glm::dvec3(v.dPdu), glm::dvec3(v.dPdv))), 0.0); // in float a tiny one is nothing
        ASSERT_TRUE(std::isfinite(glm::length(v.dPdu) + glm::length(v.dPdv)));
    }
    std::size_t covered = 0;
    for (const MeshPart& part : mesh.parts) {
        EXPECT_EQ(part.firstIndex, covered);
        covered += part.indexCount;
    }
    EXPECT_EQ(covered, mesh.indices.size());
}

inline void expectSentence(const Error& error, const std::string& name)
{
    EXPECT_NE(error.where.find(name), std::string::npos) << message(error);
    EXPECT_GT(error.what.size(), 5u);
    EXPECT_FALSE(error.hint.empty()) << message(error);
    EXPECT_EQ(error.what.find('\n'), std::string::npos);
}

inline constexpr const char* kQuad = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

// glTF with one triangle, its buffer in a data URI; `edit` replaces text in it.
inline std::string tinyGltf(const std::string& from = "", const std::string& to = "")
{
    std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,1,1]}],
"meshes":[{"name":"tri","primitives":[{"attributes":{"POSITION":0},"mode":4}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
    if (!from.empty())
        text.replace(text.find(from), from.size(), to);
    return text;
}

// Seeded mutations: bytes changed, pieces cut, doubled or numbers blown up.
inline std::string mutated(std::string bytes, std::mt19937& random)
{
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : std::size_t(random() % n); };
    for (std::size_t i = 0, edits = 1 + below(6); i < edits && !bytes.empty(); ++i) {
        const std::size_t at = below(bytes.size()), length = std::min(below(40), bytes.size() - at);
        switch (below(6)) {
        case 0:
            bytes[at] = char(random());
            break;
        case 1:
            bytes.erase(at, length);
            break;
        case 2:
            bytes.insert(at, bytes.substr(at, length));
            break;
        case 3:
            bytes.insert(at, "99999999999");
            break;
        case 4:
            bytes[at] = char(bytes[at] ^ char(1u << below(8)));
            break;
        default:
            bytes.resize(at);
        }
    }
    return bytes;
}

// Numbers and their bytes as a glTF buffer, written into a data URI.
class GltfBuffer {
public:
    // Appends, aligned to 4 bytes; the byte offset of what was appended.
    template <class T> std::size_t add(const std::vector<T>& values)
    {
        m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');
        const std::size_t at = m_bytes.size();
        m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        return at;
    }

    // Appends them as a buffer view of its own and an accessor; its number.
    template <class T>
    int accessor(const std::vector<T>& values, int componentType, const std::string& type, std::size_t components, bool normalized = false)
    {
        const std::size_t at = add(values);
        m_views += (m_count > 0 ? "," : "")
            + ("{\"buffer\":0,\"byteOffset\":" + std::to_string(at) + ",\"byteLength\":" + std::to_string(values.size() * sizeof(T)) + "}");
        m_accessors += (m_count > 0 ? "," : "")
            + ("{\"bufferView\":" + std::to_string(m_count) + ",\"componentType\":" + std::to_string(componentType)
                + ",\"count\":" + std::to_string(values.size() / components) + ",\"type\":\"" + type + "\""
                + (normalized ? ",\"normalized\":true" : "") + "}");
        return m_count++;
    }
    int floats(const std::vector<float>& values, const std::string& type, std::size_t components)
    {
        return accessor(values, 5126, type, components);
    }

    // A whole file: `members` are further members of the top level, each ending in a comma.
    std::string file(const std::string& members) const
    {
        return R"({"asset":{"version":"2.0"},)" + members + "\"accessors\":[" + m_accessors + "],\"bufferViews\":[" + m_views
            + "],\"buffers\":[{\"byteLength\":" + std::to_string(m_bytes.size()) + ",\"uri\":\"data:application/octet-stream;base64,"
            + base64(m_bytes) + "\"}]}";
    }

    static std::string base64(const std::string& bytes)
    {
        constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            const auto byte = [&](std::size_t k) { return k < bytes.size() ? std::uint32_t(static_cast<unsigned char>(bytes[k])) : 0u; };
            const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
            for (std::size_t k = 0; k < 4; ++k)
                text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
        }
        return text;
    }

private:
    std::string m_bytes, m_views, m_accessors;
    int m_count = 0;
};

} // namespace relievo
