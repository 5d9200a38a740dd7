// Export target "gltf": mesh and material as one .glb, or as .gltf and .bin, and the height map at 16 bits beside it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/gltf_material.h"
#include "core/exporters/gltf_mesh.h"
#include "core/exporters/map_images.h"
#include "core/exporters/new_files.h"
#include "core/exporters/written_pictures.h"
#include "core/ground/file.h"
#include "core/ground/text.h"
#include "core/mesh/animation/pose.h"
#include <algorithm>

namespace relievo {
namespace fs = std::filesystem;

namespace {
std::optional<Mesh> atRest(const Mesh& mesh) // nothing when it does not move
{
    return mesh.deformation ? std::optional(posed(mesh, poseAt(mesh, -1, 0.f))) : std::nullopt;
}

void tellLeftOut(const ExportJob& job, const Parameters& parameters, Warnings& warnings)
{
    const Material& material = *job.resources.material;
    if (parameters.shading == Shading::BlinnPhong && material.map(MapKind::Specular))
        warnings.push_back({"gltf-specular", "glTF shades by metallic and roughness: the specular map is left out."});
    if (const auto& moved = job.resources.mesh->deformation; moved && !(moved->clips.empty() && moved->targets.empty()))
        warnings.push_back({"gltf-rest", "The mesh is written at rest, without its animations and targets."});
    if (material.height && !material.map(MapKind::Normal))
        warnings.push_back({"normal-made", "The normal map was made from the height map at the material's depth."});
}

// Ends, for every name that is passed over is a file: a_height.png, a_glb_height.png, a_glb2_height.png ...
fs::path heightBeside(const ExportJob& job)
{
    for (int n = 0;; ++n) {
        const std::string infix = n == 0 ? "" : n == 1 ? "_glb" : "_glb" + std::to_string(n);
        const fs::path file = job.out.parent_path() / (job.out.stem().string() + infix + "_height.png");
        if (refuseToOverwriteSources(job, file))
            return file;
    }
}

bool isText(const ExportJob& job)
{
    return lowerSuffix(job.out) == ".gltf";
}
fs::path binaryOf(const ExportJob& job)
{
    return fs::path(job.out).replace_extension(".bin");
}

Expected<void> writeGltf(const ExportJob& job, GlbFile& file, NewFiles& made)
{
    made.willMake(job.out);
    if (!isText(job)) {
        const Expected<std::vector<std::byte>> glb = file.bytes(job.out.string());
        return glb ? writeAtomically(job.out, *glb) : tl::unexpected(glb.error());
    }
    const std::string text = file.text(binaryOf(job).filename().string());
    made.willMake(binaryOf(job));
    if (Expected<void> written = writeAtomically(binaryOf(job), file.binary()); !written)
        return written;
    return writeAtomically(job.out, text);
}

// All files or none.
Expected<std::vector<fs::path>> writeFiles(const ExportJob& job, GlbFile& file)
{
    std::vector<fs::path> files{job.out};
    if (isText(job))
        files.push_back(binaryOf(job));
    for (const fs::path& one : files)
        if (Expected<void> free = refuseToOverwriteSources(job, one); !free)
            return tl::unexpected(free.error());
    NewFiles made;
    if (Expected<void> folder = made.makeFolder(job.out.parent_path()); !folder)
        return tl::unexpected(folder.error());
    if (Expected<void> written = writeGltf(job, file, made); !written)
        return tl::unexpected(written.error());
    if (const std::optional<HeightField>& height = job.resources.material->height) {
        files.push_back(heightBeside(job));
        made.willMake(files.back());
        const Expected<void> written = writePicture(job, files.back(), reduced(heightImage(*height, 16), job.size, Averaging::Plain));
        if (!written)
            return tl::unexpected(written.error());
    }
    made.keep();
    return files;
}
} // namespace

std::vector<fs::path> filesOfGltf(const ExportJob& job)
{
    std::vector<fs::path> files{job.out};
    if (isText(job))
        files.push_back(binaryOf(job));
    if (job.resources.material->height)
        files.push_back(heightBeside(job));
    return files;
}

Expected<Exported> exportGltf(const ExportJob& job)
{
    const Parameters parameters = effectiveParameters(job.state, 0);
    const std::optional<Mesh> rest = atRest(*job.resources.mesh);
    const Mesh& mesh = rest ? *rest : *job.resources.mesh;
    const std::vector<char> isPlain = plainParts(mesh, job.state.part);
    Exported exported;
    GlbFile file;
    file.json["asset"] = {{"version", "2.0"}, {"generator", "Relievo " RELIEVO_VERSION}};
    addMesh(file, mesh, isPlain, parameters.rotation);
    job.progress.at(0.2f);
    if (Expected<void> added = addMaterial(file, job, parameters, exported.warnings); !added)
        return tl::unexpected(added.error());
    if (std::ranges::any_of(isPlain, [](char plain) { return plain != 0; }))
        addPlainMaterial(file, parameters);
    tellLeftOut(job, parameters, exported.warnings);
    job.progress.at(0.9f);
    Expected<std::vector<fs::path>> files = writeFiles(job, file);
    if (!files)
        return tl::unexpected(files.error());
    exported.files = std::move(*files);
    return exported;
}

} // namespace relievo
