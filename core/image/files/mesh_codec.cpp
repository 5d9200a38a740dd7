// Requests about meshes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/mesh_codec.h"
#include "core/image/files/helper_requests.h"

namespace relievo {
using namespace imageio;

namespace {
Expected<std::vector<std::byte>> decoded(Message message, const PacketWriter& packet, Payload compressed, const std::string& name)
{
    Expected<Reply> reply = ask(message, packet, compressed, name, {});
    if (reply)
        return std::move(reply->data);
    if (reply.error().code == ErrorCode::Unreadable) // told as of a picture
        reply.error()
            = {"its compressed triangles could not be decoded", name, "Export it again, or without compression", ErrorCode::Unreadable};
    return tl::unexpected(reply.error());
}
} // namespace

Expected<std::vector<std::byte>> decodeMeshopt(const MeshoptRequest& request, Payload compressed, const std::string& name)
{
    PacketWriter packet;
    for (const std::uint64_t number : {std::uint64_t(compressed.size()), request.count, request.stride, request.mode, request.filter})
        packet.put(number);
    return decoded(Message::Meshopt, packet, compressed, name);
}

Expected<std::vector<std::byte>> decodeDraco(const DracoRequest& request, Payload compressed, const std::string& name)
{
    PacketWriter packet;
    packet.put(std::uint64_t(compressed.size()));
    for (const DracoAttribute& attribute : request.attributes)
        for (const std::uint64_t number : {attribute.id, attribute.components, attribute.componentType})
            packet.put(number);
    return decoded(Message::Draco, packet, compressed, name);
}

} // namespace relievo
