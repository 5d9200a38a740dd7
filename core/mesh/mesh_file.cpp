// Opening meshes by name or file, and describing them as JSON.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/foreign_file.h"
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include "core/mesh/mesh.h"
#include "core/mesh/readers/raw_mesh.h"
#include "core/mesh/shapes/shapes.h"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace relievo {

namespace {
struct ReaderRow {
    std::string_view suffix; // lower case
    Expected<RawMesh> (*read)(const std::filesystem::path&, const Progress&);
};
constexpr ReaderRow kReaders[] = {
    {".gltf", readGltf},
    {".glb", readGltf},
    {".obj", readObj},
    {".ply", readPly},
    {".stl", readStl},
    {".off", readOff},
};
} // namespace

Expected<Mesh> openMesh(const std::string& nameOrFile, const Progress& progress)
{
    if (std::optional<Mesh> shape = makeShape(nameOrFile))
        return std::move(*shape);
    const std::filesystem::path file = thatLooksLike(nameOrFile).value_or(nameOrFile);
    const std::string suffix = lowerSuffix(file);
    if (std::optional<Error> foreign = foreignFile(file))
        return tl::unexpected(std::move(*foreign));
    for (const ReaderRow& row : kReaders) {
        if (row.suffix != suffix)
            continue;
        Expected<RawMesh> raw = row.read(file, progress);
        if (!raw)
            return tl::unexpected(raw.error());
        if (raw->name.empty())
            raw->name = file.stem().string();
        progress.at(0.5f);
        return buildMesh(std::move(*raw), nameOrFile, progress);
    }
    std::string cure = "Use ";
    for (const std::string_view shape : kShapes)
        cure += std::string(shape) + ", ";
    return failure(nameOrFile, "this is neither a built-in shape nor a mesh file that can be read",
        cure + "or a .gltf, .glb, .obj, .ply, .stl or .off file");
}

std::string meshJson(const Mesh& mesh)
{
    using Json = nlohmann::ordered_json;
    const auto point = [](glm::vec3 p) { return Json::array({p.x, p.y, p.z}); };
    Json parts = Json::array(), warnings = Json::array();
    for (const MeshPart& part : mesh.parts)
        parts.push_back({{"name", part.name}, {"material", part.material}, {"triangles", part.indexCount / 3}});
    for (const Warning& warning : mesh.warnings)
        warnings.push_back({{"code", warning.code}, {"text", warning.text}});
    Json json = {{"name", mesh.name}, {"vertices", mesh.fileVertices}, {"triangles", mesh.indices.size() / 3}, {"parts", parts},
        {"uvs", mesh.fileHasUVs}, {"normals", mesh.fileHasNormals}, {"tangents", mesh.fileHasTangents},
        {"bounds", Json::array({point(mesh.boundsMin), point(mesh.boundsMax)})}, {"warnings", warnings}};
    for (const AnimationClip& clip : mesh.deformation ? mesh.deformation->clips : std::vector<AnimationClip>())
        json["clips"].push_back({{"name", clip.name}, {"seconds", clip.seconds}});
    for (const MorphTarget& target : mesh.deformation ? mesh.deformation->targets : std::vector<MorphTarget>())
        json["targets"].push_back(target.name);
    for (const MeshMaterial& material : mesh.materials) {
        Json maps = Json::object();
        for (const MapKindRow& row : kMapKinds)
            if (const MapSlot& slot = material.maps[std::size_t(row.kind)]; !slot.empty())
                maps[std::string(row.key)] = std::filesystem::path(slot.file).filename().string();
        json["materials"].push_back({{"name", material.name}, {"maps", maps}});
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::vector<char> plainParts(const Mesh& mesh, std::string_view chosen)
{
    const bool known = !chosen.empty() && std::ranges::find(mesh.parts, chosen, &MeshPart::material) != mesh.parts.end();
    std::vector<char> plain;
    for (const MeshPart& part : mesh.parts)
        plain.push_back(part.relief == 0.f || (known && part.material != chosen));
    return plain;
}

} // namespace relievo
