// Looking up a row of the export table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/exporters/engines/engine_export.h"
#include "core/exporters/engines/target_text.h"
#include "core/ground/text.h"
#include "core/scene/inputs.h"
#include <algorithm>

namespace relievo {

const ExportRow* findExport(std::string_view key)
{
    const auto found = std::ranges::find(kExports, key, &ExportRow::key);
    return found == kExports.end() ? nullptr : &*found;
}

bool ExportRow::takes(const std::filesystem::path& out) const
{
    const std::string given = lowerSuffix(out);
    return suffix.empty() || given == suffix || (!otherSuffix.empty() && given == otherSuffix);
}

Expected<Exported> ExportRow::run(const ExportJob& job) const
{
    if (job.resources.mesh && job.resources.mesh->object)
        return failure(job.state.name, "a relief object is no material that could be written",
            "Its pictures and NAME" + std::string(kObjectSuffix) + " are what others read: relievo impostor has written them");
    return code ? code(job) : exportByText(*this, job);
}

std::vector<std::filesystem::path> ExportRow::writes(const ExportJob& job) const
{
    return codeWrites ? codeWrites(job) : filesOfText(*this, job);
}

std::vector<std::string> namesInFolder(const ExportRow& row)
{
    std::vector<std::string> names;
    if (!row.suffix.empty())
        return names;
    if (row.code) {
        for (const MapKindRow& kind : kMapKinds)
            names.push_back("NAME_" + std::string(kind.fileName) + ".png");
        names.push_back("relief.json");
        return names;
    }
    const auto named = [](std::string name, const std::string& tag, const std::string& word) {
        if (const std::size_t at = name.find(tag); at != std::string::npos)
            name.replace(at, tag.size(), word);
        return name;
    };
    const TargetText& text = textOf(row);
    for (const PackedTexture& texture : text.textures)
        names.push_back(named(texture.file, "{{name}}", "NAME"));
    for (const TargetFile& file : text.files)
        if (!file.eachTexture)
            names.push_back(named(file.name, "{{name}}", "NAME"));
    for (const TargetFile& file : text.files)
        for (const PackedTexture& texture : text.textures)
            if (file.eachTexture)
                names.push_back(named(file.name, "{{file}}", named(texture.file, "{{name}}", "NAME")));
    return names;
}

EnumSet<Cure> curesUsedBy(const ExportRow& row, const TargetText* packing)
{
    EnumSet<Cure> used;
    if (row.code == exportGltf)
        used.insert(Cure::Bump);
    if (row.code)
        return used;
    for (const PackedTexture& texture : (packing ? *packing : textOf(row)).textures) {
        if (texture.holdsData())
            used.insert(Cure::FullRange);
        for (const PackedChannel& channel : texture.channels) {
            if (channel.from == PackedChannel::From::Normal)
                used.insert(Cure::Normals);
            if (channel.from == PackedChannel::From::Height && channel.part == PackedChannel::Part::All && texture.bits == 8)
                used.insert(Cure::Dither);
        }
    }
    return used;
}

Parameters parametersOf(const ExportJob& job)
{
    return effectiveParameters(job.state, 0);
}

std::string techniqueOf(const ExportJob& job)
{
    return job.state.panes.empty() ? Pane().technique : job.state.panes.front().technique;
}

Expected<void> refuseToOverwriteSources(const ExportJob& job, const std::filesystem::path& file)
{
    std::vector<std::filesystem::path> read = filesOf(job.state);
    const auto add = [&read](const std::vector<std::filesystem::path>& more) { read.insert(read.end(), more.begin(), more.end()); };
    add(job.alsoRead);
    if (job.resources.mesh)
        for (const MeshMaterial& material : job.resources.mesh->materials)
            add(filesOf(material.maps));
    return refuseToReplace(read, file);
}

} // namespace relievo
