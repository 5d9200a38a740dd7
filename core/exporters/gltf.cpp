// Export target "gltf": mesh and material as one .glb, relief in the extension RELIEVO_materials_relief.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/map_images.h"
#include "core/exporters/new_files.h"
#include "core/gltf/gltf_extensions.h"
#include "core/ground/file.h"
#include "core/maps/float_image.h"
#include "core/mesh/animation/pose.h"
#include "core/state/state_json.h"
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

namespace relievo {
namespace fs = std::filesystem;

namespace {
using Json = nlohmann::ordered_json;
constexpr int kFloat = 5126, kUint = 5125, kVertices = 34962, kIndices = 34963; // glTF's numbers for types and targets

std::optional<Mesh> atRest(const Mesh& mesh) // nothing when it does not move
{
    return mesh.deformation ? std::optional(posed(mesh, poseAt(mesh, -1, 0.f))) : std::nullopt;
}

class GltfWriter {
public:
    explicit GltfWriter(const ExportJob& job)
        : m_job(job)
        , m_parameters(effectiveParameters(job.state, 0))
        , m_material(*job.resources.material)
        , m_posed(atRest(*job.resources.mesh))
        , m_mesh(m_posed ? *m_posed : *job.resources.mesh)
    {
    }

    Expected<Exported> write()
    {
        m_document["asset"] = {{"version", "2.0"}, {"generator", "Relievo " RELIEVO_VERSION}};
        addMesh();
        m_job.progress.at(0.2f);
        Json material = {{"name", m_job.state.name}};
        for (const auto step :
            {&GltfWriter::addColor, &GltfWriter::addPacked, &GltfWriter::addNormal, &GltfWriter::addEmission, &GltfWriter::addRelief}) {
            if (m_job.progress.cancelled())
                return cancelled(m_job.out.string());
            if (Expected<void> added = (this->*step)(material); !added)
                return tl::unexpected(added.error());
        }
        m_job.progress.at(0.9f);
        m_document["materials"] = Json::array({material});
        if (m_hasPlainParts)
            m_document["materials"].push_back({{"name", "plain"},
                {"pbrMetallicRoughness",
                    {{"baseColorFactor", tinted(kColorWithoutMap)}, {"roughnessFactor", shortest(m_parameters.roughness)},
                        {"metallicFactor", 0.f}}}});
        tellLeftOut();
        const Json wrap = m_parameters.wrap == Wrap::Repeat ? 10497 : 33071;
        if (m_document.contains("textures"))
            m_document["samplers"] = Json::array({{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", wrap}, {"wrapT", wrap}}});
        if (!m_extensions.empty())
            m_document["extensionsUsed"] = m_extensions;
        return finished();
    }

private:
    // Appends to the binary chunk, aligned to four bytes, and returns its buffer view.
    std::size_t addView(const void* data, std::size_t bytes, int target = 0)
    {
        m_binary.resize((m_binary.size() + 3) / 4 * 4);
        Json view = {{"buffer", 0}, {"byteOffset", m_binary.size()}, {"byteLength", bytes}};
        if (target != 0)
            view["target"] = target;
        const auto* first = static_cast<const std::byte*>(data);
        m_binary.insert(m_binary.end(), first, first + bytes);
        m_document["bufferViews"].push_back(std::move(view));
        return m_document["bufferViews"].size() - 1;
    }

    std::size_t addAccessor(std::size_t view, std::size_t count, int componentType, const char* type)
    {
        m_document["accessors"].push_back({{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
        return m_document["accessors"].size() - 1;
    }

    template <class T> std::size_t addAttribute(const std::vector<T>& values, const char* type)
    {
        return addAccessor(addView(values.data(), values.size() * sizeof(T), kVertices), values.size(), kFloat, type);
    }

    // Tangents run along the texture's u as it lies on the mesh: the material may be turned, its normal map turns with it.
    glm::vec4 tangentOf(const Vertex& vertex) const
    {
        const float angle = glm::radians(m_parameters.rotation);
        if (angle == 0.f)
            return vertex.tangent;
        const glm::vec3 t(vertex.tangent), b = glm::cross(vertex.normal, t) * vertex.tangent.w; // b is image up
        return glm::vec4(glm::normalize(std::cos(angle) * t + std::sin(angle) * b), vertex.tangent.w);
    }

    void addMesh()
    {
        const Mesh& mesh = m_mesh;
        std::vector<glm::vec3> positions, normals;
        std::vector<glm::vec2> uvs;
        std::vector<glm::vec4> tangents;
        for (const Vertex& vertex : mesh.vertices) {
            positions.push_back(vertex.position);
            normals.push_back(vertex.normal);
            uvs.push_back(vertex.uv);
            tangents.push_back(tangentOf(vertex));
        }
        const std::size_t position = addAttribute(positions, "VEC3");
        glm::vec3 least = positions.front(), most = least;
        for (const glm::vec3& p : positions)
            least = glm::min(least, p), most = glm::max(most, p);
        const auto point = [](glm::vec3 p) { return Json::array({p.x, p.y, p.z}); };
        m_document["accessors"][position]["min"] = point(least);
        m_document["accessors"][position]["max"] = point(most);
        const Json attributes = {{"POSITION", position}, {"NORMAL", addAttribute(normals, "VEC3")},
            {"TANGENT", addAttribute(tangents, "VEC4")}, {"TEXCOORD_0", addAttribute(uvs, "VEC2")}};
        Json primitives = Json::array();
        const std::vector<char> plainOnes = plainParts(mesh, m_job.state.part);
        for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
            const MeshPart& part = mesh.parts[i];
            const std::size_t view = addView(mesh.indices.data() + part.firstIndex, part.indexCount * sizeof(std::uint32_t), kIndices);
            const bool plain = plainOnes[i] != 0;
            m_hasPlainParts = m_hasPlainParts || plain;
            primitives.push_back({{"attributes", attributes}, {"indices", addAccessor(view, part.indexCount, kUint, "SCALAR")},
                {"material", plain ? 1 : 0}});
        }
        m_document["meshes"] = Json::array({{{"name", mesh.name}, {"primitives", primitives}}});
        m_document["nodes"] = Json::array({{{"name", mesh.name}, {"mesh", 0}}});
        m_document["scenes"] = Json::array({{{"nodes", {0}}}});
        m_document["scene"] = 0;
    }

    // A texture of an 8-bit image, as what a material refers to it by.
    Expected<Json> addTexture(const Image& image, const std::string& name, bool srgb)
    {
        const Expected<std::vector<std::byte>> png = encodePng(image, srgb);
        if (!png)
            return tl::unexpected(png.error());
        m_document["images"].push_back({{"name", name}, {"mimeType", "image/png"}, {"bufferView", addView(png->data(), png->size())}});
        m_document["textures"].push_back({{"sampler", 0}, {"source", m_document["images"].size() - 1}});
        return reference(m_document["textures"].size() - 1);
    }

    Json reference(std::size_t texture)
    {
        Json info = {{"index", texture}};
        const Parameters& p = m_parameters;
        if (p.tiling == 1.f && p.offsetU == 0.f && p.offsetV == 0.f && p.rotation == 0.f)
            return info;
        // Its rotation turns the UVs counter-clockwise as seen on the image, which turns the image clockwise: the other way round.
        info["extensions"][kTransformExtension] = {{"offset", {shortest(p.offsetU), shortest(p.offsetV)}},
            {"rotation", shortest(-glm::radians(p.rotation))}, {"scale", {shortest(p.tiling), shortest(p.tiling)}}};
        use(kTransformExtension);
        return info;
    }

    void use(const char* extension)
    {
        if (std::ranges::find(m_extensions, extension) == m_extensions.end())
            m_extensions.push_back(extension);
    }

    Json tinted(float color) const
    {
        const glm::vec3 c = glm::vec3(m_parameters.tint) * color;
        return {shortest(c.x), shortest(c.y), shortest(c.z), 1.f};
    }

    Expected<void> addColor(Json& material)
    {
        Json& pbr = material["pbrMetallicRoughness"];
        pbr["baseColorFactor"] = tinted(m_material.map(MapKind::Color) ? 1.f : kColorWithoutMap);
        const std::optional<Image> color = baseColorImage(m_material, m_job.size);
        if (!color)
            return {};
        Expected<Json> texture = addTexture(*color, "color", true);
        if (!texture)
            return tl::unexpected(texture.error());
        pbr["baseColorTexture"] = *texture;
        if (m_material.map(MapKind::Opacity)) {
            material["alphaMode"] = "MASK";
            material["alphaCutoff"] = 0.5f;
        }
        return {};
    }

    Expected<void> addPacked(Json& material)
    {
        Json& pbr = material["pbrMetallicRoughness"];
        pbr["roughnessFactor"] = shortest(m_parameters.roughness);
        pbr["metallicFactor"] = m_material.map(MapKind::Metallic) ? shortest(m_parameters.metallic) : 0.;
        const std::optional<Image> packed = packedImage(m_material, m_job.size);
        if (!packed)
            return {};
        Expected<Json> texture = addTexture(*packed, "occlusion_roughness_metallic", false);
        if (!texture)
            return tl::unexpected(texture.error());
        pbr["metallicRoughnessTexture"] = *texture;
        if (m_material.map(MapKind::AmbientOcclusion)) {
            material["occlusionTexture"] = *texture;
            material["occlusionTexture"]["strength"] = shortest(m_parameters.aoStrength);
        }
        return {};
    }

    Expected<void> addNormal(Json& material)
    {
        const std::optional<Image> normal = normalImage(m_material, m_parameters, m_job.progress);
        if (!normal)
            return {};
        Expected<Json> texture = addTexture(eightBit(reduced(*normal, m_job.size, Averaging::Normals), false), "normal", false);
        if (!texture)
            return tl::unexpected(texture.error());
        material["normalTexture"] = *texture;
        material["normalTexture"]["scale"] = shortest(m_parameters.normalStrength);
        return {};
    }

    Expected<void> addEmission(Json& material)
    {
        const Image* emission = m_material.map(MapKind::Emission);
        if (!emission || m_parameters.emission <= 0.f)
            return {};
        // The texture holds no light above 1: what is brighter goes into the strength.
        Image light = reduced(*emission, m_job.size, Averaging::Srgb);
        const float most = std::max(brightest(light), 1.f), strength = most * m_parameters.emission;
        if (most > 1.f)
            for (float& value : floats(light))
                value /= most;
        Expected<Json> texture = addTexture(eightBit(light, true), "emission", true);
        if (!texture)
            return tl::unexpected(texture.error());
        material["emissiveTexture"] = *texture;
        const double factor = shortest(std::min(strength, 1.f));
        material["emissiveFactor"] = {factor, factor, factor};
        if (strength > 1.f) {
            material["extensions"][kBrighterExtension] = {{"emissiveStrength", shortest(strength)}};
            use(kBrighterExtension);
        }
        return {};
    }

    void tellLeftOut()
    {
        Warnings& warnings = m_exported.warnings;
        if (m_parameters.shading == Shading::BlinnPhong && m_material.map(MapKind::Specular))
            warnings.push_back({"gltf-specular", "glTF shades by metallic and roughness: the specular map is left out."});
        if (const auto& moved = m_job.resources.mesh->deformation; moved && !(moved->clips.empty() && moved->targets.empty()))
            warnings.push_back({"gltf-rest", "The mesh is written at rest, without its animations and targets."});
        if (m_material.height && !m_material.map(MapKind::Normal))
            warnings.push_back({"normal-made", "The normal map was made from the height map at the material's depth."});
    }

    Expected<void> addRelief(Json& material)
    {
        if (!m_material.height) {
            m_exported.warnings.push_back({"no-height", "The material has no height map: the file holds no relief."});
            return {};
        }
        Expected<Json> texture = addTexture(reduced(heightImage(*m_material.height, 8), m_job.size, Averaging::Plain), "height", false);
        if (!texture)
            return tl::unexpected(texture.error());
        const float measured = m_job.resources.mesh->metresPerUV;
        const std::string technique = m_job.state.panes.empty() ? Pane().technique : m_job.state.panes.front().technique;
        Json numbers = {{"depth", shortest(physicalDepth(m_parameters, measured))}, {"midlevel", shortest(m_parameters.midlevel)},
            {"metresPerUV", shortest(metresPerUV(m_parameters, measured))}, {"technique", technique}, {"minSteps", m_parameters.minSteps},
            {"maxSteps", m_parameters.maxSteps}, {"refineSteps", m_parameters.refineSteps}};
        if (const TechniqueRow* row = findTechnique(technique))
            numbers.update(searchJson(*row, m_parameters));
        Json relief = {{"heightTexture", *texture}};
        relief.update(numbers);
        material["extensions"][kReliefExtension] = relief;
        material["extras"]["relievo"] = numbers;
        use(kReliefExtension);
        m_exported.warnings.push_back({"gltf-height",
            "Viewers that do not know RELIEVO_materials_relief show the normal map only; the height map at 16 bits lies beside the file."});
        if (m_parameters.midlevel < 1.f)
            m_exported.warnings.push_back({"gltf-midlevel",
                "The mesh is written as it is, not pushed out: a reader of the extension must do that for a midlevel below 1."});
        return {};
    }

    static void put(std::vector<std::byte>& out, std::uint32_t value)
    {
        for (int shift = 0; shift < 32; shift += 8)
            out.push_back(std::byte(value >> shift & 0xffu));
    }

    // Ends, for every name that is passed over is a file: a_height.png, a_glb_height.png, a_glb2_height.png ...
    fs::path heightBeside() const
    {
        for (int n = 0;; ++n) {
            const std::string infix = n == 0 ? "" : n == 1 ? "_glb" : "_glb" + std::to_string(n);
            const fs::path file = m_job.out.parent_path() / (m_job.out.stem().string() + infix + "_height.png");
            if (refuseToOverwriteSources(m_job, file))
                return file;
        }
    }

    Expected<Exported> finished()
    {
        m_binary.resize((m_binary.size() + 3) / 4 * 4);
        m_document["buffers"] = Json::array({{{"byteLength", m_binary.size()}}});
        std::string text = m_document.dump(-1, ' ', false, Json::error_handler_t::replace);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::size_t total = 12 + 8 + text.size() + 8 + m_binary.size();
        if (total > 0xffffffffu)
            return failure(m_job.out.string(), "a .glb cannot hold more than 4 GiB", "Export smaller textures with --size");
        std::vector<std::byte> file;
        file.reserve(total);
        for (const std::uint32_t word : {0x46546C67u, 2u, std::uint32_t(total), std::uint32_t(text.size()), 0x4E4F534Au})
            put(file, word);
        const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
        file.insert(file.end(), bytes, bytes + text.size());
        put(file, std::uint32_t(m_binary.size()));
        put(file, 0x004E4942u);
        file.insert(file.end(), m_binary.begin(), m_binary.end());
        if (Expected<void> free = refuseToOverwriteSources(m_job, m_job.out); !free)
            return tl::unexpected(free.error());
        NewFiles made;
        made.willMake(m_job.out);
        if (Expected<void> written = writeAtomically(m_job.out, file); !written)
            return tl::unexpected(written.error());
        m_exported.files.push_back(m_job.out);
        if (!m_material.height) {
            made.keep();
            return std::move(m_exported);
        }
        const fs::path beside = heightBeside();
        made.willMake(beside);
        if (Expected<void> written = writeImage(beside, reduced(heightImage(*m_material.height, 16), m_job.size, Averaging::Plain));
            !written)
            return tl::unexpected(written.error());
        m_exported.files.push_back(beside);
        made.keep();
        return std::move(m_exported);
    }

    const ExportJob& m_job;
    Parameters m_parameters;
    const Material& m_material;
    const std::optional<Mesh> m_posed;
    const Mesh& m_mesh; // as it is written
    Json m_document = Json::object();
    std::vector<std::byte> m_binary;
    bool m_hasPlainParts = false;
    std::vector<std::string> m_extensions;
    Exported m_exported;
};
} // namespace

Expected<Exported> exportGltf(const ExportJob& job)
{
    return GltfWriter(job).write();
}

} // namespace relievo
