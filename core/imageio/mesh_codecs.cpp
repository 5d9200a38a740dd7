// Draco by libdraco, EXT_meshopt_compression by meshoptimizer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/mesh_codecs.h"
#include <algorithm>
#include <cstring>
#include <draco/compression/decode.h>
#include <meshoptimizer.h>
#include <new>

namespace relievo::imageio {
namespace {
constexpr std::size_t kBlock = std::size_t(1) << 24; // bytes sent or taken at once
constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 30; // of one piece, compressed or not
const Refusal kDamaged{"its compressed triangles cannot be decoded", "Export it again, or without compression"};

bool take(Channel& channel, std::uint64_t size, std::vector<std::byte>& bytes)
{
    if (size > kMostBytes)
        throw std::bad_alloc();
    bytes.resize(size);
    return channel.receive(bytes);
}

void answer(Channel& channel, std::span<const std::byte> bytes)
{
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), kBlock)))
        channel.send(Message::Data, bytes.first(std::min(bytes.size(), kBlock)));
    channel.done({});
}

bool decodeMeshopt(const MeshoptRequest& request, std::span<const std::byte> bytes, std::vector<std::byte>& out)
{
    const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
    const std::size_t count = request.count, stride = request.stride;
    switch (MeshoptMode(request.mode)) {
    case MeshoptMode::Attributes:
        return stride % 4 == 0 && stride <= 256 && meshopt_decodeVertexBuffer(out.data(), count, stride, from, bytes.size()) == 0;
    case MeshoptMode::Triangles:
        return count % 3 == 0 && (stride == 2 || stride == 4)
            && meshopt_decodeIndexBuffer(out.data(), count, stride, from, bytes.size()) == 0;
    case MeshoptMode::Indices:
        return (stride == 2 || stride == 4) && meshopt_decodeIndexSequence(out.data(), count, stride, from, bytes.size()) == 0;
    }
    return false;
}

bool undoFilter(const MeshoptRequest& request, std::vector<std::byte>& out)
{
    const std::size_t count = request.count, stride = request.stride;
    switch (MeshoptFilter(request.filter)) {
    case MeshoptFilter::None:
        return true;
    case MeshoptFilter::Octahedral:
        if (stride == 4 || stride == 8)
            meshopt_decodeFilterOct(out.data(), count, stride);
        return stride == 4 || stride == 8;
    case MeshoptFilter::Quaternion:
        if (stride == 8)
            meshopt_decodeFilterQuat(out.data(), count, stride);
        return stride == 8;
    case MeshoptFilter::Exponential:
        meshopt_decodeFilterExp(out.data(), count, stride);
        return true;
    }
    return false;
}

// Values of one attribute for each point, in the type that the file's accessor has.
template <class T> bool putValues(const draco::PointAttribute& attribute, std::uint32_t points, std::size_t components, std::byte* out)
{
    std::vector<T> values(components);
    for (std::uint32_t i = 0; i < points; ++i, out += components * sizeof(T)) {
        if (!attribute.ConvertValue<T>(attribute.mapped_index(draco::PointIndex(i)), std::int8_t(components), values.data()))
            return false;
        std::memcpy(out, values.data(), components * sizeof(T));
    }
    return true;
}

std::size_t bytesOf(std::uint64_t componentType) // as glTF numbers them
{
    return componentType == 5120 || componentType == 5121 ? 1 : componentType == 5122 || componentType == 5123 ? 2 : 4;
}

bool putAttribute(const draco::Mesh& mesh, const DracoAttribute& wanted, std::vector<std::byte>& out)
{
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(std::uint32_t(wanted.id));
    const std::size_t components = wanted.components;
    if (!attribute || components < 1 || components > 4)
        return false;
    const std::size_t at = out.size(), size = bytesOf(wanted.componentType) * components * mesh.num_points();
    if (at + size > kMostBytes)
        throw std::bad_alloc();
    out.resize(at + size);
    switch (wanted.componentType) {
    case 5120:
        return putValues<std::int8_t>(*attribute, mesh.num_points(), components, out.data() + at);
    case 5121:
        return putValues<std::uint8_t>(*attribute, mesh.num_points(), components, out.data() + at);
    case 5122:
        return putValues<std::int16_t>(*attribute, mesh.num_points(), components, out.data() + at);
    case 5123:
        return putValues<std::uint16_t>(*attribute, mesh.num_points(), components, out.data() + at);
    case 5125:
        return putValues<std::uint32_t>(*attribute, mesh.num_points(), components, out.data() + at);
    case 5126:
        return putValues<float>(*attribute, mesh.num_points(), components, out.data() + at);
    default:
        return false;
    }
}

void putNumber(std::vector<std::byte>& out, std::uint32_t number)
{
    const auto bytes = std::as_bytes(std::span(&number, 1));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

bool decodeDraco(const DracoRequest& request, std::span<const std::byte> bytes, std::vector<std::byte>& out)
{
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
        return false;
    const draco::Mesh& mesh = *decoded.value();
    if (std::uint64_t(mesh.num_faces()) * 12 > kMostBytes)
        throw std::bad_alloc();
    putNumber(out, mesh.num_points());
    putNumber(out, mesh.num_faces());
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : mesh.face(face))
            putNumber(out, point.value());
    return std::ranges::all_of(request.attributes, [&](const DracoAttribute& wanted) { return putAttribute(mesh, wanted, out); });
}
} // namespace

void answerMeshopt(Channel& channel, const MeshoptRequest& request)
{
    std::vector<std::byte> bytes, out;
    if (!take(channel, request.size, bytes))
        return;
    if (request.stride < 1 || request.stride > 256 || request.count > kMostBytes / request.stride)
        return channel.fail(kDamaged);
    out.resize(request.count * request.stride);
    if (!decodeMeshopt(request, bytes, out) || !undoFilter(request, out))
        return channel.fail(kDamaged);
    answer(channel, out);
}

void answerDraco(Channel& channel, const DracoRequest& request)
{
    std::vector<std::byte> bytes, out;
    if (!take(channel, request.size, bytes))
        return;
    if (!decodeDraco(request, bytes, out))
        return channel.fail(kDamaged);
    answer(channel, out);
}

} // namespace relievo::imageio
