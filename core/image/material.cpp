// Loading the maps that the slots name.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/material.h"
#include "core/gltf/pictures.h"
#include "core/image/map_image.h"
#include "core/image/pixels.h"
#include "core/image/samples/hard_cases.h"
#include "core/image/samples/samples.h"
#include "core/image/sets/file_names.h"
#include <algorithm>
#include <charconv>
#include <mutex>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {
namespace fs = std::filesystem;
namespace {
constexpr std::string_view kSamplePrefix = "sample:";
constexpr std::string_view kHardPrefix = "hard-";
constexpr int kLargestSample = 8192; // texels a side

struct SampleName {
    std::string key;
    int size = kSampleSize;
};

std::optional<SampleName> sampleName(std::string_view text)
{
    if (!text.starts_with(kSamplePrefix))
        return std::nullopt;
    text.remove_prefix(kSamplePrefix.size());
    SampleName name;
    const std::size_t at = std::min(text.find('@'), text.size());
    name.key = text.substr(0, at);
    if (at < text.size()) {
        const std::string_view digits = text.substr(at + 1);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), name.size);
        if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || name.size < 1 || name.size > kLargestSample)
            return std::nullopt;
    }
    return name;
}

const Image* sampleMap(const Sample& sample, MapKind kind)
{
    const Image* image = kind == MapKind::Height ? &sample.height
        : kind == MapKind::Color                 ? &sample.color
        : kind == MapKind::Roughness             ? &sample.roughness
        : kind == MapKind::Metallic              ? &sample.metallic
                                                 : nullptr;
    return image && !image->data.empty() ? image : nullptr;
}

std::string fileName(const MapSlot& slot)
{
    return sampleName(slot.file) ? slot.file : fs::path(slot.file).filename().string();
}

// Files and samples by name, each made once.
class Sources {
public:
    Sources(const DecodedImages& decoded, const Progress& progress) : m_progress(progress)
    {
        for (const auto& [file, read] : decoded)
            m_files[file.string()] = read;
    }

    void load(const std::vector<std::string>& names)
    {
        std::vector<std::string> missing;
        for (const std::string& name : names)
            if (!m_files.contains(name) && std::ranges::find(missing, name) == missing.end())
                missing.push_back(name);
        std::mutex mutex;
        std::size_t ready = 0;
        oneapi::tbb::parallel_for(
            std::size_t(0), missing.size(), [&](std::size_t i) { loadOne(missing[i], mutex, ready, missing.size()); });
    }

    Expected<DecodedFile> image(const MapSlot& slot, MapKind kind) const
    {
        if (const auto sample = m_samples.find(slot.file); sample != m_samples.end()) {
            const Image* map = sampleMap(*sample->second, kind);
            if (!map)
                return failure(slot.file, "this sample has no " + std::string(row(kind).key) + " map");
            return std::make_shared<const ImageRead>(ImageRead{*map, {}});
        }
        if (const auto error = m_errors.find(slot.file); error != m_errors.end())
            return tl::unexpected(error->second);
        return m_files.at(slot.file);
    }

private:
    void loadOne(const std::string& name, std::mutex& mutex, std::size_t& ready, std::size_t count)
    {
        std::shared_ptr<const Sample> sample;
        Expected<ImageRead> read = cancelled(name);
        if (m_progress.cancelled()) {
        } else if (name.starts_with(kSamplePrefix))
            sample = makeSample(name, read);
        else
            read = readImage(name, Progress{{}, m_progress.stop});
        const std::scoped_lock lock(mutex);
        if (sample)
            m_samples[name] = std::move(sample);
        else if (read)
            m_files[name] = std::make_shared<const ImageRead>(std::move(*read));
        else
            m_errors[name] = read.error();
        m_progress.at(0.8f * float(++ready) / float(count));
    }

    static std::shared_ptr<const Sample> makeSample(const std::string& name, Expected<ImageRead>& trouble)
    {
        const std::optional<SampleName> parsed = sampleName(name);
        const SampleRow* row = parsed ? findSample(parsed->key) : nullptr;
        if (row)
            return std::make_shared<const Sample>(row->make(parsed->size));
        if (const HardCaseRow* hard
            = parsed && parsed->key.starts_with(kHardPrefix) ? findHardCase(parsed->key.substr(kHardPrefix.size())) : nullptr)
            return std::make_shared<const Sample>(hardCaseSample(*hard, parsed->size));
        trouble = failure(ErrorCode::NotFound, name, "there is no such built-in sample", "Choose one from the list of samples");
        return nullptr;
    }

    const Progress& m_progress;
    std::map<std::string, DecodedFile> m_files;
    std::map<std::string, std::shared_ptr<const Sample>> m_samples;
    std::map<std::string, Error> m_errors;
};

// How every warning about a file begins: a later load recognises by it what belongs to maps it takes over.
std::string prefixOf(const MapSlot& slot)
{
    return fileName(slot) + ": ";
}

std::string leftOut(MapKind kind)
{
    std::string label(row(kind).label);
    label[0] = char(label[0] - 'A' + 'a');
    return ": the " + label + " map is left out";
}

void addOnce(Warnings& warnings, const Warning& warning)
{
    if (std::ranges::find(warnings, warning) == warnings.end())
        warnings.push_back(warning);
}

class Loader {
public:
    Loader(const MapSlots& slots, const Material* previous) : m_previous(previous) { m_material.slots = slots; }

    // Takes over what did not change and names the files of the rest.
    std::vector<std::string> filesToLoad()
    {
        std::vector<std::string> files;
        for (const MapKindRow& kindRow : kMapKinds)
            if (!slot(kindRow.kind).empty() && !takeOver(kindRow.kind))
                files.push_back(slot(kindRow.kind).file);
        return files;
    }

    void convertAll(const Sources& sources)
    {
        std::array<Warnings, kMapKindCount> told;
        oneapi::tbb::parallel_for(std::size_t(0), kMapKindCount, [&](std::size_t i) {
            if (!slot(MapKind(i)).empty() && !m_takenOver[i])
                convertOne(MapKind(i), sources, told[i]);
        });
        for (const Warnings& warnings : told)
            for (const Warning& warning : warnings)
                addOnce(m_material.warnings, warning);
    }

    Expected<Material> finish()
    {
        const auto& slots = m_material.slots;
        const bool wanted = std::ranges::any_of(slots, [](const MapSlot& s) { return !s.empty(); });
        const bool got = m_material.height || std::ranges::any_of(m_material.maps, [](const auto& map) { return map != nullptr; });
        if (wanted && !got)
            return tl::unexpected(*m_firstError);
        return std::move(m_material);
    }

private:
    const MapSlot& slot(MapKind kind) const { return m_material.slots[std::size_t(kind)]; }

    bool takeOver(MapKind kind)
    {
        const std::size_t at = std::size_t(kind);
        if (!m_previous || m_previous->slots[at] != slot(kind))
            return false;
        const bool isHeight = kind == MapKind::Height;
        if (isHeight ? !m_previous->height.has_value() : !m_previous->maps[at])
            return false;
        if (isHeight)
            m_material.height = m_previous->height;
        else
            m_material.maps[at] = m_previous->maps[at];
        for (const Warning& warning : m_previous->warnings)
            if (warning.text.starts_with(prefixOf(slot(kind))) && !warning.code.starts_with("map-"))
                addOnce(m_material.warnings, warning);
        return m_takenOver[at] = true;
    }

    void convertOne(MapKind kind, const Sources& sources, Warnings& warnings)
    {
        const Expected<DecodedFile> decoded = sources.image(slot(kind), kind);
        if (!decoded)
            return drop(kind, decoded.error(), warnings);
        warnings = (*decoded)->warnings;
        const std::string file = fileName(slot(kind));
        if (!hasChannel((*decoded)->image, slot(kind).channel))
            return leaveOut(kind, warnings);
        if (kind == MapKind::Height) {
            m_material.height = heightOf((*decoded)->image, slot(kind), file, warnings);
            return;
        }
        const bool namedRelief = guessFromName(fs::path(file).stem().string()).packing == Packing::Relief;
        auto map = mapOf(kind, *decoded, slot(kind), file, namedRelief, warnings);
        if (!map)
            return drop(kind, map.error(), warnings);
        m_material.maps[std::size_t(kind)] = std::move(*map);
    }

    // Another channel in its place would be another map.
    void leaveOut(MapKind kind, Warnings& warnings)
    {
        warnings.push_back(channelMissing(kind, slot(kind)));
        const std::scoped_lock lock(m_mutex);
        if (!m_firstError)
            m_firstError = Error{"it has no alpha channel", slot(kind).file, "Choose a channel that it has"};
    }

    void drop(MapKind kind, const Error& error, Warnings& warnings)
    {
        const bool missing = slot(kind).file.starts_with(kSamplePrefix) || !pictureMayExist(slot(kind).file);
        warnings.push_back(
            {missing ? "map-missing" : "map-broken", prefixOf(slot(kind)) + error.what + " (" + slot(kind).file + ")" + leftOut(kind)});
        const std::scoped_lock lock(m_mutex);
        if (!m_firstError)
            m_firstError = error;
    }

    const Material* m_previous;
    Material m_material;
    std::array<bool, kMapKindCount> m_takenOver = {};
    std::mutex m_mutex;
    std::optional<Error> m_firstError;
};
} // namespace

Warning channelMissing(MapKind kind, const MapSlot& slot)
{
    return {"channel-missing", prefixOf(slot) + "it has no alpha channel" + leftOut(kind)};
}

Expected<Material> loadMaterial(const MapSlots& slots, const DecodedImages& decoded, const Material* previous, const Progress& progress)
{
    Loader loader(slots, previous);
    Sources sources(decoded, progress);
    sources.load(loader.filesToLoad());
    if (progress.cancelled())
        return cancelled("");
    loader.convertAll(sources);
    progress.at(1.f);
    return loader.finish();
}

} // namespace relievo
