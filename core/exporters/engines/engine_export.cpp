// Targets by text: names first, then pictures, then the files that refer to them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/engine_export.h"
#include "core/analysis/engine_drawing.h"
#include "core/exporters/engines/shader_words.h"
#include "core/exporters/engines/template_values.h"
#include "core/exporters/map_images.h"
#include "core/exporters/new_files.h"
#include "core/exporters/written_pictures.h"
#include "core/ground/file.h"
#include "core/ground/hash.h"
#include "core/shader_text/program_text.h"
#include "core/state/lights.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace relievo {
namespace fs = std::filesystem;

namespace {
constexpr float kTerraces = 0.1f; // widths of a texel: steps of 8 bits that are higher show as terraces

struct TextureFile {
    const PackedTexture* texture;
    std::string name;
};
struct NamedText {
    std::string name;
    const TargetFile* file; // of the target
    TemplateValues values;
    Words more;
    std::string text; // filled in
};

// A name that stays in the folder.
Expected<void> checkName(const std::string& name, const std::string& where)
{
    const fs::path path(name);
    const bool leaves = path.is_absolute() || name.find('\\') != std::string::npos
        || std::ranges::any_of(path, [](const fs::path& part) { return part == ".."; });
    if (name.empty() || leaves || !path.has_filename())
        return failure(
            where, '"' + name + "\" is no name of a file in the folder that is exported to", "Name it without .. and without a / in front");
    return {};
}

std::string drawingTold(const ExportRow& row, const WrittenHeights& heights, const Parameters& parameters, const Progress& progress)
{
    const TechniqueRow* const technique = findTechnique(row.engine.technique);
    if (!technique || !heights.field)
        return {};
    const Expected<EngineDrawing> drawing = drawnBy(*technique, heights.with(parameters), *heights.field, kEngineAngle, progress);
    return drawing ? sentence(*technique, *drawing) : std::string();
}

class TextExport {
public:
    TextExport(const ExportRow& row, const ExportJob& job)
        : m_row(row)
        , m_job(job)
        , m_target(textOf(row))
        , m_parameters(parametersOf(job))
        , m_heights(writtenHeights(job, m_parameters))
        , m_values(valuesOf(row, job, m_heights, m_parameters))
    {
    }

    // Which textures are written, and what the templates say of them.
    Expected<void> nameTextures()
    {
        for (const PackedTexture& texture : m_target.textures)
            m_values.textures[texture.key]; // its name is known, also where it is not written
        for (const PackedTexture& texture : m_job.packing ? m_job.packing->textures : m_target.textures) {
            if (m_values.words.contains(texture.key) || m_values.switches.contains(texture.key))
                return failure(m_target.where + ": " + texture.key, "a texture cannot be called like a value", "Give it another key");
            Words& words = m_values.textures[texture.key];
            if (!isPresent(texture, m_job) || !isWanted(texture))
                continue;
            const Expected<std::string> name = filled(texture.file, onlyWords(), {}, m_target.where + ": textures", 0);
            if (!name)
                return tl::unexpected(name.error());
            if (auto good = checkName(*name, m_target.where + ": " + texture.key); !good)
                return good;
            words = {{"file", *name}, {"key", texture.key}, {"bits", std::to_string(texture.bits)},
                {"guid", hexHash(m_values.words["guid"] + ' ' + *name)}};
            m_textures.push_back({&texture, *name});
        }
        if (m_textures.empty())
            return failure(m_job.out.string(), "the material has no maps to write", "Open a texture set first");
        return {};
    }

    // The names of the texts; what is in them comes later, as it may take baking.
    Expected<void> nameTexts()
    {
        for (const TargetFile& file : m_target.files) {
            if (!file.eachTexture)
                if (auto done = name(file, m_values, {}); !done)
                    return done;
            for (const TextureFile& texture : m_textures)
                if (file.eachTexture)
                    if (auto done = name(file, valuesFor(*texture.texture), m_values.textures.at(texture.texture->key)); !done)
                        return done;
        }
        return {};
    }

    Expected<void> fillTexts()
    {
        for (NamedText& text : m_texts) {
            const TargetFile& file = *text.file;
            if (auto added = addShaders(text.values, file.text, m_job, m_heights, m_parameters); !added)
                return added;
            Expected<std::string> whole = filled(file.text, text.values, text.more, m_target.where, file.line);
            if (!whole)
                return tl::unexpected(whole.error());
            text.text = std::move(*whole);
        }
        return {};
    }

    std::vector<fs::path> files() const
    {
        std::vector<fs::path> files;
        for (const TextureFile& texture : m_textures)
            files.push_back(m_job.out / texture.name);
        for (const NamedText& text : m_texts)
            files.push_back(m_job.out / text.name);
        return files;
    }

    Expected<Exported> write()
    {
        if (auto free = checkFiles(); !free)
            return tl::unexpected(free.error());
        Exported exported{files(), warnings()};
        if (auto folder = m_made.makeFolder(m_job.out); !folder)
            return tl::unexpected(folder.error());
        float done = 0.f;
        for (const TextureFile& texture : m_textures) {
            m_job.progress.at(done++ / float(m_textures.size()));
            if (auto written = writeTexture(texture); !written)
                return tl::unexpected(written.error());
        }
        for (const NamedText& text : m_texts)
            if (auto written = makeWay(text.name).and_then([&](const fs::path& path) { return writeAtomically(path, text.text); });
                !written)
                return tl::unexpected(written.error());
        m_made.keep();
        return exported;
    }

private:
    bool isWanted(const PackedTexture& texture) const
    {
        const TechniqueRow* const technique = findTechnique(techniqueOf(m_job));
        const bool isExact = technique && technique->isExact;
        switch (texture.when) {
        case PackedTexture::When::Always:
            return true;
        case PackedTexture::When::EightBitsShow:
            return m_heights.coarseness(m_parameters) > kTerraces;
        case PackedTexture::When::ExactSearch:
            return isExact;
        case PackedTexture::When::FilteredSearch:
            return !isExact && technique && technique->needsHeights();
        case PackedTexture::When::Codes:
            return ownMapHoldsCodes(m_job);
        case PackedTexture::When::NoCodes:
            return !ownMapHoldsCodes(m_job);
        }
        return true;
    }

    TemplateValues onlyWords() const { return {m_values.words, m_values.switches, {}}; }

    TemplateValues valuesFor(const PackedTexture& texture) const
    {
        TemplateValues values = m_values;
        values.switches["isData"] = texture.holdsData();
        values.switches["isHeight"] = texture.holdsHeight();
        values.switches["isNormal"]
            = std::ranges::any_of(texture.channels, [](const PackedChannel& c) { return c.from == PackedChannel::From::Normal; });
        values.switches["isColor"] = texture.srgb;
        return values;
    }

    Expected<void> name(const TargetFile& file, const TemplateValues& values, const Words& more)
    {
        const Expected<std::string> name = filled(file.name, values, more, m_target.where, file.line - 1);
        if (!name)
            return tl::unexpected(name.error());
        if (auto good = checkName(*name, m_target.where + ':' + std::to_string(file.line - 1)); !good)
            return good;
        m_texts.push_back({*name, &file, values, more, {}});
        return {};
    }

    Expected<void> checkFiles() const
    {
        std::vector<fs::path> all = files();
        for (const fs::path& file : all)
            if (auto free = refuseToOverwriteSources(m_job, file); !free)
                return free;
        std::ranges::sort(all);
        if (const auto twice = std::ranges::adjacent_find(all); twice != all.end())
            return failure(
                m_target.where, "it names the file " + twice->filename().string() + " twice", "Give each file a name of its own");
        return {};
    }

    // The path of a file that is about to be written, its folder made.
    Expected<fs::path> makeWay(const std::string& name)
    {
        const fs::path path = m_job.out / name;
        if (path.parent_path() != m_job.out)
            if (auto folder = m_made.makeFolder(path.parent_path()); !folder)
                return tl::unexpected(folder.error());
        m_made.willMake(path);
        return path;
    }

    Expected<void> writeTexture(const TextureFile& texture)
    {
        const Expected<fs::path> path = makeWay(texture.name);
        if (!path)
            return tl::unexpected(path.error());
        std::string content;
        if (m_job.pictures) {
            content = contentOf(*texture.texture, m_job, m_heights, m_parameters);
            if (const auto bytes = bytesOf(*m_job.pictures, content))
                return writeAtomically(*path, *bytes);
        }
        const Image image = packed(*texture.texture, m_job, m_heights, m_parameters);
        if (m_job.progress.cancelled())
            return cancelled(m_job.out.string());
        if (auto written = writePicture(m_job, *path, image, texture.texture->srgb); !written)
            return written;
        if (m_job.pictures)
            (*m_job.pictures)[content] = {*path};
        return {};
    }

    Warnings warnings() const
    {
        Warnings told;
        const Material& material = *m_job.resources.material;
        const EngineFacts& engine = m_row.engine;
        if (!material.height) {
            told.push_back({"no-height", "The material has no height map: what is written holds no relief."});
            return told;
        }
        if (!material.map(MapKind::Normal) && m_job.cures.contains(Cure::Normals))
            told.push_back({"normal-made", "The normal map was made from the height map at the material's depth."});
        if (const std::string drawing = drawingTold(m_row, m_heights, m_parameters, m_job.progress); !drawing.empty())
            told.push_back({"engine-drawing", drawing + '.'});
        tellDepth(told);
        tellBits(told);
        if (const std::string left = techniqueLeftOut(m_target, m_job); !left.empty())
            told.push_back({"technique-left-out", left});
        if (hasLayers() && !says("fragment"))
            told.push_back({"layers-left-out",
                "Clear coat, sheen, transmission and anisotropy are left out: give them to the engine's material, if it has them."});
        if (!isOneDirectional(m_parameters) && says("fragment"))
            told.push_back({"lights-left-out", std::string(kLightsLeftOut)});
        if (const TechniqueRow* technique = findTechnique(techniqueOf(m_job));
            technique && readsHorizons(*technique, m_parameters) && says("fragment"))
            told.push_back({"horizons-left-out", std::string(kHorizonsLeftOut)});
        if (m_parameters.rotation != 0.f && !says("rotation"))
            told.push_back({"rotation-lost", std::string(m_row.label) + " is not told the material's turn: turn the UVs of the mesh."});
        if (!engine.limits.empty())
            told.push_back({"engine-limits", std::string(engine.limits)});
        return told;
    }

    bool hasLayers() const
    {
        return m_parameters.shading == Shading::MetallicRoughness && std::ranges::any_of(kParameters, [this](const ParameterRow& row) {
            return row.shader.place == ShaderPlace::Layer && !row.shader.files.front().empty()
                && variantOf(row, get(m_parameters, row)) != 0;
        });
    }

    bool says(const std::string& name) const
    {
        return std::ranges::any_of(
            m_target.files, [&](const TargetFile& file) { return file.text.find("{{" + name) != std::string::npos; });
    }

    void tellDepth(Warnings& told) const
    {
        const EngineFacts& engine = m_row.engine;
        if (engine.property.empty())
            return;
        const EngineDepth depth = engineDepth(engine, m_job, m_heights, m_parameters);
        char text[300];
        if (std::abs(depth.drawn - 1.f) > 1e-3f) {
            std::snprintf(text, sizeof text, "%.*s takes %g to %g: the relief will be %.3g times as deep as here.",
                int(engine.property.size()), engine.property.data(), double(engine.min), double(engine.max), double(depth.drawn));
            told.push_back({"depth-clamped", text});
        }
        const float lift = (m_heights.midlevel(m_parameters) - engine.zero) * depth.metres * depth.drawn;
        if (!engine.zeroIsFree && std::abs(lift) > 1e-3f * depth.metres) {
            std::snprintf(text, sizeof text, "Height %g lies on the surface there: the relief stands %.3g mm %s than here.",
                double(engine.zero), double(std::abs(lift)) * 1000., lift > 0.f ? "higher" : "lower");
            told.push_back({"zero-differs", text});
        }
    }

    void tellBits(Warnings& told) const
    {
        const auto isCoarse = [](const TextureFile& file) {
            return std::ranges::any_of(file.texture->channels, [&](const PackedChannel& c) {
                return c.from == PackedChannel::From::Height && c.part == PackedChannel::Part::All && file.texture->bits == 8;
            });
        };
        const auto isFine = [&](const TextureFile& file) { return file.texture->holdsHeight() && !isCoarse(file); };
        if (m_heights.coarseness(m_parameters) <= 0.f || std::ranges::none_of(m_textures, isCoarse)
            || std::ranges::any_of(m_textures, isFine))
            return;
        char text[300];
        std::snprintf(text, sizeof text, "The height is written in 8 bits, %s: a step is %.3g mm.",
            m_job.cures.contains(Cure::Dither) ? "dithered" : "not dithered",
            double(engineDepth(m_row.engine, m_job, m_heights, m_parameters).metres) * 1000. / 255.);
        told.push_back({"banding", text});
    }

    const ExportRow& m_row;
    const ExportJob& m_job;
    const TargetText& m_target;
    const Parameters m_parameters;
    WrittenHeights m_heights;
    TemplateValues m_values;
    std::vector<TextureFile> m_textures;
    std::vector<NamedText> m_texts;
    NewFiles m_made;
};
} // namespace

Expected<Exported> exportByText(const ExportRow& row, const ExportJob& job)
{
    TextExport target(row, job);
    const auto ready = target.nameTextures().and_then([&] { return target.nameTexts(); }).and_then([&] { return target.fillTexts(); });
    if (!ready)
        return tl::unexpected(ready.error());
    return target.write();
}

std::string drawingTold(const ExportRow& row, const ExportJob& job)
{
    const Parameters parameters = parametersOf(job);
    return drawingTold(row, writtenHeights(job, parameters), parameters, job.progress);
}

std::vector<fs::path> filesOfText(const ExportRow& row, const ExportJob& job)
{
    TextExport target(row, job);
    if (auto named = target.nameTextures().and_then([&] { return target.nameTexts(); }); !named)
        return {};
    return target.files();
}

} // namespace relievo
