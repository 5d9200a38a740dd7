// glTF accessors: strides, normalized integers and sparse substitutes, never beyond a buffer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/gltf_accessor.h"
#include <algorithm>
#include <cstring>
#include <limits>

namespace relievo {

namespace {
// Elements that may be made without a byte of file behind them (an accessor of zeros).
constexpr std::size_t kMostZeros = std::size_t(1) << 24;
const char* const kHint = "Check the file with a glTF validator and export it again";

struct Failing {
    const std::string& where;
    std::string name;
    tl::unexpected<Error> operator()(const std::string& what) const
    {
        return failure(ErrorCode::Unreadable, where, name + ' ' + what, kHint);
    }
};

// `count` elements of `bytes` each, `stride` apart.
struct Slice {
    const unsigned char* data = nullptr;
    std::size_t stride = 0;
};

Expected<Slice> sliceOf(
    const tinygltf::Model& model, int view, std::size_t offset, std::size_t count, std::size_t bytes, const Failing& fail)
{
    if (view < 0 || std::size_t(view) >= model.bufferViews.size())
        return fail("names the buffer view " + std::to_string(view) + ", which does not exist");
    const tinygltf::BufferView& span = model.bufferViews[std::size_t(view)];
    if (span.buffer < 0 || std::size_t(span.buffer) >= model.buffers.size())
        return fail("lies in a buffer that does not exist");
    const std::vector<unsigned char>& buffer = model.buffers[std::size_t(span.buffer)].data;
    if (span.byteOffset > buffer.size() || span.byteLength > buffer.size() - span.byteOffset)
        return fail("lies in a buffer view that reaches beyond its buffer");
    const std::size_t stride = span.byteStride == 0 ? bytes : span.byteStride;
    const bool fits = offset <= span.byteLength
        && (count == 0
            || (bytes <= span.byteLength - offset && (count - 1) <= (span.byteLength - offset - bytes) / std::max(stride, std::size_t(1))));
    if (!fits)
        return fail("reaches beyond its buffer view");
    return Slice{buffer.data() + span.byteOffset + offset, stride};
}

template <class T> float normalizedOf(const unsigned char* at, bool normalized)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    if constexpr (std::is_integral_v<T>) {
        if (normalized)
            return std::max(float(value) / float(std::numeric_limits<T>::max()), -1.f);
    }
    return float(value);
}

using Decode = float (*)(const unsigned char*, bool);
struct ComponentRow {
    int type;
    std::size_t bytes;
    Decode decode;
};
constexpr ComponentRow kComponents[] = {
    {TINYGLTF_COMPONENT_TYPE_BYTE, 1, normalizedOf<std::int8_t>},
    {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 1, normalizedOf<std::uint8_t>},
    {TINYGLTF_COMPONENT_TYPE_SHORT, 2, normalizedOf<std::int16_t>},
    {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, 2, normalizedOf<std::uint16_t>},
    {TINYGLTF_COMPONENT_TYPE_FLOAT, 4, normalizedOf<float>},
};

std::uint32_t unsignedOf(const unsigned char* at, std::size_t bytes)
{
    std::uint32_t value = 0;
    std::memcpy(&value, at, bytes); // glTF is little-endian, as are the machines this runs on
    return value;
}

std::size_t indexBytes(int componentType)
{
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ? 1
        : componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
        : componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? 4
                                                                  : 0;
}

Expected<const tinygltf::Accessor*> accessorAt(const tinygltf::Model& model, int index, const Failing& fail)
{
    if (index < 0 || std::size_t(index) >= model.accessors.size())
        return fail("does not exist");
    return &model.accessors[std::size_t(index)];
}

Expected<void> putSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, int components, const ComponentRow& component,
    std::vector<float>& values, const Failing& fail)
{
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || std::size_t(sparse.count) > accessor.count || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
        return fail("has more sparse values than elements");
    const std::size_t count = std::size_t(sparse.count), bytes = indexBytes(sparse.indices.componentType);
    if (bytes == 0)
        return fail("has sparse indices of a type that is not allowed");
    const std::size_t elementBytes = component.bytes * std::size_t(components);
    const Expected<Slice> indices = sliceOf(model, sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), count, bytes, fail);
    const Expected<Slice> substitutes
        = sliceOf(model, sparse.values.bufferView, std::size_t(sparse.values.byteOffset), count, elementBytes, fail);
    if (!indices || !substitutes)
        return tl::unexpected(indices ? substitutes.error() : indices.error());
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t target = unsignedOf(indices->data + i * indices->stride, bytes);
        if (target >= accessor.count)
            return fail("has a sparse index beyond its elements");
        for (std::size_t k = 0; k < std::size_t(components); ++k)
            values[target * std::size_t(components) + k]
                = component.decode(substitutes->data + i * substitutes->stride + k * component.bytes, accessor.normalized);
    }
    return {};
}
} // namespace

Expected<std::vector<float>> readFloats(const tinygltf::Model& model, int index, int components, const std::string& where)
{
    const Failing fail{where, "accessor " + std::to_string(index)};
    const Expected<const tinygltf::Accessor*> found = accessorAt(model, index, fail);
    if (!found)
        return tl::unexpected(found.error());
    const tinygltf::Accessor& accessor = **found;
    const auto* component
        = std::ranges::find_if(kComponents, [&accessor](const ComponentRow& row) { return row.type == accessor.componentType; });
    if (component == std::end(kComponents) || tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)) != components)
        return fail("is not of the type that its use asks for");
    const bool zeros = accessor.bufferView < 0;
    if (zeros && accessor.count > kMostZeros)
        return fail("claims more elements than its data hold");
    Slice slice;
    const std::size_t bytes = component->bytes * std::size_t(components);
    if (!zeros) {
        const Expected<Slice> checked = sliceOf(model, accessor.bufferView, accessor.byteOffset, accessor.count, bytes, fail);
        if (!checked)
            return tl::unexpected(checked.error());
        slice = *checked;
    }
    std::vector<float> values(accessor.count * std::size_t(components), 0.f);
    for (std::size_t i = 0; !zeros && i < accessor.count; ++i)
        for (std::size_t k = 0; k < std::size_t(components); ++k)
            values[i * std::size_t(components) + k]
                = component->decode(slice.data + i * slice.stride + k * component->bytes, accessor.normalized);
    if (accessor.sparse.isSparse)
        if (Expected<void> put = putSparse(model, accessor, components, *component, values, fail); !put)
            return tl::unexpected(put.error());
    return values;
}

Expected<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int index, const std::string& where)
{
    const Failing fail{where, "accessor " + std::to_string(index)};
    const Expected<const tinygltf::Accessor*> found = accessorAt(model, index, fail);
    if (!found)
        return tl::unexpected(found.error());
    const tinygltf::Accessor& accessor = **found;
    const std::size_t bytes = indexBytes(accessor.componentType);
    if (bytes == 0 || accessor.type != TINYGLTF_TYPE_SCALAR || accessor.sparse.isSparse)
        return fail("is not of a type that indices may have");
    const Expected<Slice> slice = sliceOf(model, accessor.bufferView, accessor.byteOffset, accessor.count, bytes, fail);
    if (!slice)
        return tl::unexpected(slice.error());
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i)
        indices[i] = unsignedOf(slice->data + i * slice->stride, bytes);
    return indices;
}

} // namespace relievo
