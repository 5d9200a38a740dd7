// Buffer views by meshoptimizer, primitives by Draco.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/compression/gltf_compression.h"
#include "core/gltf/gltf_extensions.h"
#include "core/gltf/gltf_values.h"
#include "core/image/files/mesh_codec.h"
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>

namespace relievo {
namespace {
constexpr std::size_t kMostBytes = std::size_t(2) << 30; // of all that is decoded from one file
const char* const kHint = "Check the file with a glTF validator and export it again";

class Decompressor {
public:
    Decompressor(tinygltf::Model& model, const std::string& where, const Progress& progress)
        : m_model(model)
        , m_where(where)
        , m_progress(progress)
    {
    }

    Expected<void> run()
    {
        const std::size_t views = m_model.bufferViews.size();
        for (std::size_t i = 0; i < views; ++i)
            if (const auto found = m_model.bufferViews[i].extensions.find(kMeshoptExtension);
                found != m_model.bufferViews[i].extensions.end())
                if (Expected<void> done = decodeView(i, found->second); !done)
                    return done;
        for (tinygltf::Mesh& mesh : m_model.meshes)
            for (tinygltf::Primitive& primitive : mesh.primitives)
                if (const auto found = primitive.extensions.find(kDracoExtension); found != primitive.extensions.end())
                    if (Expected<void> done = decodePrimitive(primitive, found->second); !done)
                        return done;
        return {};
    }

private:
    tl::unexpected<Error> damaged(const std::string& what) const { return failure(ErrorCode::Unreadable, m_where, what, kHint); }

    std::optional<std::span<const std::byte>> bytesOf(int buffer, double offset, double length) const
    {
        if (buffer < 0 || std::size_t(buffer) >= m_model.buffers.size())
            return std::nullopt;
        const std::vector<unsigned char>& data = m_model.buffers[std::size_t(buffer)].data;
        if (!(offset >= 0 && length > 0 && offset + length <= double(data.size())))
            return std::nullopt;
        return std::as_bytes(std::span(data)).subspan(std::size_t(offset), std::size_t(length));
    }

    // A buffer of its own for bytes that were decoded; its number.
    Expected<int> addBuffer(std::span<const std::byte> bytes)
    {
        m_decoded += bytes.size();
        if (m_decoded > kMostBytes)
            return failure(ErrorCode::Unreadable, m_where, "more is compressed in it than can be held", "Split it");
        if (m_progress.cancelled())
            return cancelled(m_where);
        tinygltf::Buffer& buffer = m_model.buffers.emplace_back();
        buffer.data.resize(bytes.size());
        std::memcpy(buffer.data.data(), bytes.data(), bytes.size());
        return int(m_model.buffers.size()) - 1;
    }

    template <std::size_t n> static std::optional<std::uint64_t> choice(const std::array<const char*, n>& names, const std::string& name)
    {
        const auto found = std::ranges::find(names, name);
        return found == names.end() ? std::nullopt : std::optional(std::uint64_t(found - names.begin()));
    }

    Expected<void> decodeView(std::size_t index, const tinygltf::Value& extension)
    {
        constexpr std::array kModes = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
        constexpr std::array kFilters = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
        const std::string filter = textOf(member(extension, "filter"));
        const auto mode = choice(kModes, textOf(member(extension, "mode"))), undo = choice(kFilters, filter.empty() ? "NONE" : filter);
        const auto bytes = bytesOf(indexOf(member(extension, "buffer"), -1), numberOf(member(extension, "byteOffset"), 0),
            numberOf(member(extension, "byteLength"), 0));
        const int count = indexOf(member(extension, "count"), 0), stride = indexOf(member(extension, "byteStride"), 0);
        if (!mode || !undo || !bytes || count < 1 || stride < 1)
            return damaged("its buffer view " + std::to_string(index) + " is compressed in a way that makes no sense");
        const Expected<std::vector<std::byte>> decoded
            = decodeMeshopt({0, std::uint64_t(count), std::uint64_t(stride), *mode, *undo}, *bytes, m_where);
        if (!decoded)
            return tl::unexpected(decoded.error());
        const Expected<int> buffer = addBuffer(*decoded);
        if (!buffer)
            return tl::unexpected(buffer.error());
        tinygltf::BufferView& view = m_model.bufferViews[index];
        view.buffer = *buffer;
        view.byteOffset = 0;
        view.byteLength = decoded->size();
        return {};
    }

    // An attribute of a primitive, as it is asked for and where its accessor is.
    struct Wanted {
        std::string key;
        int accessor = -1;
        imageio::DracoAttribute attribute;
        std::size_t bytes() const
        {
            return std::size_t(std::max(tinygltf::GetComponentSizeInBytes(std::uint32_t(attribute.componentType)), 0))
                * std::size_t(attribute.components);
        }
    };

    Expected<std::vector<Wanted>> attributesOf(const tinygltf::Primitive& primitive, const tinygltf::Value& ids) const
    {
        std::vector<Wanted> all;
        for (const auto& [key, accessor] : primitive.attributes) {
            const int id = indexOf(member(ids, key.c_str()), -1);
            if (id < 0)
                continue; // stored beside the compressed ones
            if (accessor < 0 || std::size_t(accessor) >= m_model.accessors.size())
                return damaged("the attribute " + key + " names an accessor that does not exist");
            const tinygltf::Accessor& as = m_model.accessors[std::size_t(accessor)];
            const int components = tinygltf::GetNumComponentsInType(std::uint32_t(as.type));
            Wanted wanted{
                key, accessor, {std::uint64_t(id), std::uint64_t(std::max(components, 0)), std::uint64_t(std::max(as.componentType, 0))}};
            if (components < 1 || components > 4 || wanted.bytes() == 0)
                return damaged("the attribute " + key + " is compressed in a way that makes no sense");
            all.push_back(std::move(wanted));
        }
        return all;
    }

    Expected<void> decodePrimitive(tinygltf::Primitive& primitive, const tinygltf::Value& extension)
    {
        const Expected<std::vector<Wanted>> wanted = attributesOf(primitive, member(extension, "attributes"));
        if (!wanted)
            return tl::unexpected(wanted.error());
        const int view = indexOf(member(extension, "bufferView"), -1);
        if (view < 0 || std::size_t(view) >= m_model.bufferViews.size())
            return damaged("compressed triangles name a buffer view that does not exist");
        const tinygltf::BufferView& from = m_model.bufferViews[std::size_t(view)];
        const auto bytes = bytesOf(from.buffer, double(from.byteOffset), double(from.byteLength));
        if (!bytes)
            return damaged("compressed triangles reach beyond their buffer");
        imageio::DracoRequest request;
        for (const Wanted& one : *wanted)
            request.attributes.push_back(one.attribute);
        const Expected<std::vector<std::byte>> decoded = decodeDraco(request, *bytes, m_where);
        return decoded ? place(primitive, *wanted, *decoded) : tl::unexpected(decoded.error());
    }

    // Accessors for the decoded bytes: triangles, then attribute after attribute.
    Expected<void> place(tinygltf::Primitive& primitive, const std::vector<Wanted>& attributes, std::span<const std::byte> decoded)
    {
        std::array<std::uint32_t, 2> counts = {}; // points, triangles
        std::size_t expected = sizeof counts;
        if (decoded.size() >= sizeof counts) {
            std::memcpy(counts.data(), decoded.data(), sizeof counts);
            expected += std::size_t(counts[1]) * 12;
            for (const Wanted& one : attributes)
                expected += one.bytes() * counts[0];
        }
        if (decoded.size() != expected)
            return damaged("its compressed triangles hold other numbers than they should");
        const Expected<int> buffer = addBuffer(decoded);
        if (!buffer)
            return tl::unexpected(buffer.error());
        std::size_t at = sizeof counts;
        tinygltf::Accessor indices;
        indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        indices.type = TINYGLTF_TYPE_SCALAR;
        primitive.indices = addAccessor(indices, std::size_t(counts[1]) * 3, *buffer, at, std::size_t(counts[1]) * 12);
        primitive.mode = TINYGLTF_MODE_TRIANGLES; // strips were taken apart
        at += std::size_t(counts[1]) * 12;
        for (const Wanted& one : attributes) {
            const tinygltf::Accessor as = m_model.accessors[std::size_t(one.accessor)];
            primitive.attributes[one.key] = addAccessor(as, counts[0], *buffer, at, one.bytes() * counts[0]);
            at += one.bytes() * counts[0];
        }
        return {};
    }

    int addAccessor(tinygltf::Accessor as, std::size_t count, int buffer, std::size_t offset, std::size_t bytes)
    {
        tinygltf::BufferView& view = m_model.bufferViews.emplace_back();
        view.buffer = buffer;
        view.byteOffset = offset;
        view.byteLength = bytes;
        as.bufferView = int(m_model.bufferViews.size()) - 1;
        as.byteOffset = 0;
        as.count = count;
        m_model.accessors.push_back(std::move(as));
        return int(m_model.accessors.size()) - 1;
    }

    tinygltf::Model& m_model;
    const std::string& m_where;
    const Progress& m_progress;
    std::size_t m_decoded = 0; // bytes
};
} // namespace

Expected<void> decompress(tinygltf::Model& model, const std::string& where, const Progress& progress)
{
    return Decompressor(model, where, progress).run();
}

} // namespace relievo
