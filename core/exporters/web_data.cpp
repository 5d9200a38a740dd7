// Packing maps, mesh and environment for a web page.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/web_data.h"
#include "core/exporters/map_images.h"
#include "core/exporters/written_pictures.h"
#include "core/ground/base64.h"
#include "core/image/environment/directions.h"
#include "core/image/environment/prefilter.h"
#include "core/mesh/edges/closed.h"
#include <cassert>
#include <glm/gtc/packing.hpp>

namespace relievo {
namespace {
template <class T> std::string numbers(const std::vector<T>& values)
{
    return base64(std::as_bytes(std::span(values)));
}

Expected<std::string> png(const ExportJob& job, const Image& image, bool srgb = false)
{
    const auto bytes = pngOf(job, image, srgb);
    if (!bytes)
        return tl::unexpected(bytes.error());
    return base64(**bytes);
}

// The high or the low bytes of one channel.
Image byteOf(const Image& image, int channel, bool high)
{
    Image plane = emptyImage(image.width, image.height, 1, PixelType::U8);
    for (std::size_t i = 0; i < plane.data.size(); ++i) {
        std::uint16_t code;
        std::memcpy(&code, image.data.data() + (i * std::size_t(image.channels) + std::size_t(channel)) * 2, 2);
        plane.data[i] = std::byte(high ? code >> 8 : code & 255);
    }
    return plane;
}
} // namespace

Expected<WebJson> webPlanes(const ExportJob& job, const Image& image)
{
    assert(image.type == PixelType::U16);
    WebJson planes = WebJson::array();
    for (int c = 0; c < image.channels; ++c)
        for (const bool high : {true, false}) {
            Expected<std::string> plane = png(job, byteOf(image, c, high));
            if (!plane)
                return tl::unexpected(plane.error());
            planes.push_back(std::move(*plane));
        }
    return WebJson{{"width", image.width}, {"height", image.height}, {"channels", image.channels}, {"planes", std::move(planes)}};
}

Expected<WebJson> webPicture(const ExportJob& job, const Image& image, bool srgb)
{
    Expected<std::string> picture = png(job, image, srgb);
    if (!picture)
        return tl::unexpected(picture.error());
    return WebJson{{"png", std::move(*picture)}, {"channels", image.channels}, {"srgb", srgb}};
}

Expected<WebJson> webBound(const ExportJob& job, const AccelerationMap& map)
{
    Expected<WebJson> bound = webPlanes(job, map.levels.front());
    if (bound) {
        (*bound)["sampler"] = map.form == MapForm::Codes ? "cellMap" : map.form == MapForm::Volume ? "distanceMap" : "boundMap";
        (*bound)["slices"] = map.slices;
    }
    return bound;
}

WebJson webMesh(const Mesh& mesh, const std::vector<char>& isPlain)
{
    std::vector<float> positions, normals, uvs;
    for (const Vertex& vertex : mesh.vertices) {
        positions.insert(positions.end(), {vertex.position.x, vertex.position.y, vertex.position.z});
        normals.insert(normals.end(), {vertex.normal.x, vertex.normal.y, vertex.normal.z});
        uvs.insert(uvs.end(), {vertex.uv.x, vertex.uv.y});
    }
    std::vector<std::uint32_t> indices;
    std::size_t relief = 0;
    for (const bool plain : {false, true}) {
        for (std::size_t i = 0; i < mesh.parts.size(); ++i)
            if (const MeshPart& part = mesh.parts[i]; (isPlain[i] != 0) == plain)
                indices.insert(
                    indices.end(), mesh.indices.begin() + part.firstIndex, mesh.indices.begin() + part.firstIndex + part.indexCount);
        if (!plain)
            relief = indices.size();
    }
    const bool isSmall = mesh.vertices.size() <= 65536;
    return {{"positions", numbers(positions)}, {"normals", numbers(normals)}, {"uvs", numbers(uvs)}, {"bits", isSmall ? 16 : 32},
        {"indices", isSmall ? numbers(std::vector<std::uint16_t>(indices.begin(), indices.end())) : numbers(indices)}, {"relief", relief},
        {"closed", isClosed(mesh)}};
}

WebJson webEnvironment(const Environment& environment)
{
    Cube sharp = environment.levels.front();
    while (sharp.side > kWebEnvironmentSide)
        sharp = halved(sharp);
    const std::vector<Cube> levels = sharp.side == environment.levels.front().side ? environment.levels : prefiltered(std::move(sharp));
    std::vector<std::uint32_t> texels;
    for (const Cube& cube : levels)
        for (const glm::vec3& radiance : cube.texels)
            texels.push_back(glm::packF3x9_E1x5(radiance));
    return {{"side", levels.front().side}, {"levels", levels.size()}, {"texels", numbers(texels)}};
}

} // namespace relievo
