// Opening a texture set: names first, then channels, then pixels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/texture_set.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/name_forms.h"
#include "core/image/pixels.h"
#include "core/image/sets/convention.h"
#include "core/image/sets/set_candidates.h"
#include "core/image/sets/set_measure.h"
#include "core/image/sets/set_plan.h"
#include <algorithm>
#include <array>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

namespace relievo {
namespace fs = std::filesystem;
namespace {
constexpr double kNormalShare = 0.8; // of texels that are unit vectors, as in relief textures

class Opener {
public:
    Opener(SetPlan plan, const fs::path& source, const Progress& progress, const EarlySet& early)
        : m_plan(std::move(plan))
        , m_source(source)
        , m_progress(progress)
        , m_early(early)
    {
        m_set.name = m_plan.name;
        m_set.folder = m_plan.folder;
        m_set.warnings = m_plan.warnings;
        for (const NamedFile& file : m_plan.files)
            if (file.file == m_source)
                m_resolution = file.guess.resolution;
    }

    Expected<TextureSet> run()
    {
        readHeaders();
        // Pixels may take roles away, and then another file gets its turn.
        std::vector<Choice> choices;
        do {
            choices = chooseMaps(m_candidates);
            decode(choices);
        } while (lookAtPixels() && !m_progress.cancelled());
        if (m_progress.cancelled())
            return cancelled(m_source.string());
        if (choices.empty())
            return tl::unexpected(m_firstError.value_or(Error{"none of the images can be used", m_source.string(),
                m_set.warnings.empty() ? "See the warnings of each" : m_set.warnings.front().text}));
        findAlphaHeight(choices);
        fill(choices);
        measureMaps(m_set, named(choices));
        tellUnused(choices);
        return std::move(m_set);
    }

private:
    void broken(const fs::path& file, const Error& error)
    {
        if (!m_firstError || file == m_source)
            m_firstError = error;
        m_set.warnings.push_back({"map-broken", file.filename().string() + ": " + error.what});
    }

    void readHeaders()
    {
        for (const NamedFile& file : m_plan.files) {
            const Expected<ImageInfo> info = readImageInfo(file.file);
            if (!info) {
                broken(file.file, info.error());
                continue;
            }
            m_candidates.push_back(candidateOf(file, *info));
        }
    }

    Candidate candidateOf(const NamedFile& file, const ImageInfo& info)
    {
        Candidate candidate{file.file, file.guess, rolesByChannels(file.guess, info.channels), info, file.file == m_source};
        candidate.likeChosen = !file.guess.resolution.empty() && file.guess.resolution == m_resolution;
        preferHeightLayer(candidate);
        if (candidate.roles.empty() && !file.guess.roles.empty())
            ignore(candidate, "has too few channels (" + std::to_string(info.channels) + ") for the maps that its name promises");
        return candidate;
    }

    // Renderings and bakes keep the height or the distance in a layer of its own.
    void preferHeightLayer(Candidate& candidate)
    {
        if (candidate.roles != std::vector{MapRole{MapKind::Height}})
            return;
        const std::optional<std::string> layer = heightLayer(candidate.info.layers);
        const fs::path file = layer ? fs::path(layerName(candidate.file, *layer)) : fs::path();
        const Expected<ImageInfo> info = layer ? readImageInfo(file) : failure("", "");
        if (!info)
            return;
        m_set.warnings.push_back({"parts",
            candidate.file.filename().string() + ": of its layers " + shortList(candidate.info.layers) + " the height is read from "
                + *layer});
        candidate.file = file;
        candidate.info = *info;
        candidate.guess.convention = isDepthLayer(*layer) ? Convention::Depth : Convention::Height;
    }

    // Takes the file's roles away.
    void ignore(Candidate& candidate, const std::string& why)
    {
        candidate.roles.clear();
        m_set.warnings.push_back({"ignored-file", candidate.file.filename().string() + " " + why + ": not used"});
    }

    // The files of the choices in turn, as many at once as there are helpers; heights, which stand first, are there first.
    void decode(const std::vector<Choice>& choices)
    {
        namespace tbb = oneapi::tbb;
        std::vector<fs::path> files;
        for (const Choice& choice : choices)
            if (!m_set.images.contains(choice.candidate->file) && std::ranges::find(files, choice.candidate->file) == files.end())
                files.push_back(choice.candidate->file);
        std::vector<Expected<ImageRead>> reads(files.size());
        std::size_t next = 0, ready = 0;
        const auto take = [&](tbb::flow_control& control) { return next < files.size() ? next++ : (control.stop(), next); };
        const auto read = [&](std::size_t i) { return reads[i] = readImage(files[i], Progress{{}, m_progress.stop}), i; };
        const auto keep = [&](std::size_t i) {
            if (reads[i])
                m_set.images[files[i]] = std::make_shared<const ImageRead>(std::move(*reads[i]));
            else
                std::ranges::find(m_candidates, files[i], &Candidate::file)->roles.clear();
            m_progress.at(float(++ready) / float(files.size() + 1));
            if (reads[i] && ready < files.size()) // what waits for its pieces must not begin with another file
                tbb::this_task_arena::isolate([this] { tellEarly(); });
        };
        tbb::parallel_pipeline(files.size() + 1,
            tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take)
                & tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, read)
                & tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_out_of_order, keep));
        for (std::size_t i = 0; i < files.size(); ++i)
            tell(files[i], reads[i]);
    }

    // The set as it would be if it ended here, once it has the heights that it promises.
    void tellEarly() const
    {
        if (!m_early || m_progress.cancelled())
            return;
        Opener ended = *this;
        ended.lookAtPixels();
        std::vector<Choice> choices = chooseMaps(ended.m_candidates);
        const auto isComing = [&](const Choice& choice) { return !ended.m_set.images.contains(choice.candidate->file); };
        for (const Choice& choice : choices)
            if (isComing(choice))
                ended.m_set.coming.insert(choice.role.kind);
        std::erase_if(choices, isComing);
        if (choices.empty() || ended.m_set.coming.contains(MapKind::Height))
            return;
        ended.fill(choices);
        measureMaps(ended.m_set, ended.named(choices));
        m_early(ended.m_set);
    }

    void tell(const fs::path& file, const Expected<ImageRead>& read)
    {
        if (read) {
            const Warnings& warnings = m_set.images.at(file)->warnings;
            m_set.warnings.insert(m_set.warnings.end(), warnings.begin(), warnings.end());
            return;
        }
        broken(file, read.error());
        m_lost = true;
    }

    // Whether any decoded file gives other maps than its name promised.
    bool lookAtPixels()
    {
        bool changed = m_lost;
        for (Candidate& candidate : m_candidates)
            if (const auto found = m_set.images.find(candidate.file); found != m_set.images.end()) {
                const std::vector<MapRole> before = candidate.roles;
                judge(candidate, found->second->image);
                changed = changed || candidate.roles != before;
            }
        m_lost = false;
        return changed;
    }

    void judge(Candidate& candidate, const Image& image)
    {
        if (candidate.roles.empty())
            return;
        const MapRole first = candidate.roles.front();
        if (candidate.guess.packing == Packing::ColorAndAlpha && candidate.roles.size() == 2)
            judgePair(candidate, image);
        else if (candidate.guess.packing == Packing::Channels)
            std::erase_if(
                candidate.roles, [&](const MapRole& role) { return role.channel == Channel::A && rangeOf(image, Channel::A).first == 1; });
        else if (candidate.guess.packing == Packing::Relief)
            judgeRelief(candidate, image);
        else if (first.kind == MapKind::Emission && candidate.guess.vague && !isMostlyBlack(image))
            ignore(candidate, "is too bright for the emission map that its letter a may mean");
        else if (first == MapRole{MapKind::Opacity} && !looksGrey(image))
            ignore(candidate, "is named an opacity mask, but its red, green and blue differ");
        else if (first == MapRole{MapKind::Height} && holdsNormals(image)) {
            candidate.roles = {{MapKind::Normal, Channel::Rgb}};
            m_set.warnings.push_back(
                {"normal-named-height", candidate.file.filename().string() + " holds normals, not heights: used as the normal map"});
        }
    }

    static bool holdsNormals(const Image& image)
    {
        return image.channels >= 3 && !alphaVaries(image) && !looksGrey(image) && unitShare(image) > kNormalShare;
    }

    // A colour or normal with another map in alpha; where there is no alpha to speak of, one of the two.
    static void judgePair(Candidate& candidate, const Image& image)
    {
        const bool isFirst
            = image.channels == 4 || (candidate.roles.front().kind == MapKind::Normal ? holdsNormals(image) : !looksGrey(image));
        if (!alphaVaries(image))
            candidate.roles = {isFirst ? candidate.roles.front() : candidate.roles.back()};
    }

    void judgeRelief(Candidate& candidate, const Image& image)
    {
        if (candidate.roles.size() == 1) { // no alpha
            if (candidate.roles.front().kind == MapKind::Normal && !holdsNormals(image))
                ignore(candidate, "is named a relief texture, but holds no normals");
            return;
        }
        const ReliefForm form = reliefForm(image, true);
        if (form == ReliefForm::None)
            candidate.roles.clear();
        tellRelief(candidate.file, form);
        candidate.guess.packing = Packing::None; // judged
    }

    void tellRelief(const fs::path& file, ReliefForm form)
    {
        const std::string name = file.filename().string();
        m_relief = m_relief || form != ReliefForm::None;
        if (form == ReliefForm::NormalAndDepth)
            m_set.warnings.push_back(
                {"relief-texture", name + " is a relief texture: normal in red, green, blue and height or depth in alpha"});
        else if (form == ReliefForm::Dual)
            m_set.warnings.push_back({"relief-texture-dual",
                name
                    + " is a dual relief texture: normal x and y in red and green (z is rebuilt), front depth in alpha; its back depth "
                      "(blue) is not used"});
        else
            m_set.warnings.push_back(
                {"ignored-file", name + " is named a relief texture, but its channels hold no normals and depth: not used"});
    }

    // Old engines keep the height in the normal map's alpha without saying so; the slopes give it away.
    void findAlphaHeight(std::vector<Choice>& choices)
    {
        if (std::ranges::any_of(choices, [](const Choice& c) { return c.role.kind == MapKind::Height && c.role.channel == Channel::A; }))
            return;
        const bool lone = choices.size() == 1 && choices[0].role.kind == MapKind::Height;
        const auto found = std::ranges::find_if(choices, [&](const Choice& c) { return lone || c.role.kind == MapKind::Normal; });
        const bool hasHeight = std::ranges::any_of(choices, [](const Choice& c) { return c.role.kind == MapKind::Height; });
        if (found == choices.end() || (hasHeight && !lone))
            return;
        const Candidate* candidate = found->candidate;
        const ReliefForm form = reliefForm(m_set.images.at(candidate->file)->image, false);
        if (form == ReliefForm::None)
            return;
        tellRelief(candidate->file, form);
        std::erase_if(choices, [](const Choice& c) { return c.role.kind == MapKind::Height || c.role.kind == MapKind::Normal; });
        choices.push_back({{MapKind::Normal, Channel::Rgb}, candidate});
        choices.push_back({{MapKind::Height, Channel::A}, candidate});
        std::ranges::sort(choices, {}, [](const Choice& c) { return c.role.kind; });
    }

    void fill(const std::vector<Choice>& choices)
    {
        for (const Choice& choice : choices)
            m_set.maps.push_back(
                {choice.role.kind, choice.candidate->file, choice.role.channel, choice.candidate->info, Convention::Linear, 0, 0});
        std::erase_if(m_set.images, [&](const auto& entry) {
            return std::ranges::none_of(choices, [&](const Choice& c) { return c.candidate->file == entry.first; });
        });
    }

    NamedConventions named(const std::vector<Choice>& choices) const
    {
        NamedConventions names;
        names.heightOtherwise = m_relief ? Convention::Depth : Convention::Height; // as the papers have it
        for (const Choice& choice : choices) {
            const Convention said = choice.candidate->guess.convention;
            if (choice.role.kind == MapKind::Height && (said == Convention::Height || said == Convention::Depth))
                names.height = said;
            if (choice.role.kind == MapKind::Normal && (said == Convention::GL || said == Convention::DX))
                names.normal = said;
        }
        return names;
    }

    void tellUnused(const std::vector<Choice>& choices)
    {
        std::vector<std::string> names;
        for (const Candidate& candidate : m_candidates)
            if (!candidate.roles.empty() && std::ranges::none_of(choices, [&](const Choice& c) { return c.candidate == &candidate; }))
                names.push_back(candidate.file.filename().string());
        if (!names.empty())
            m_set.warnings.push_back({"ignored-file", "not used, other files give the same maps better: " + shortList(names)});
    }

    SetPlan m_plan;
    fs::path m_source;
    const Progress& m_progress;
    const EarlySet& m_early;
    TextureSet m_set;
    std::vector<Candidate> m_candidates; // not resized after readHeaders: choices point into it
    std::string m_resolution; // the tag in the name of SOURCE
    std::optional<Error> m_firstError;
    bool m_relief = false; // the height comes from a relief texture
    bool m_lost = false; // a chosen file could not be decoded
};
} // namespace

MapSlots TextureSet::slots() const
{
    MapSlots slots;
    for (const FoundMap& map : maps)
        slots[std::size_t(map.kind)] = {map.file.string(), map.channel,
            map.convention == Convention::Depth || (map.kind == MapKind::Normal && map.convention == Convention::DX)};
    return slots;
}

Expected<TextureSet> openTextureSet(const fs::path& source, const Progress& progress, const EarlySet& early)
{
    if (source.empty())
        return failure(ErrorCode::NotFound, "SOURCE", "there is no such file or folder", "Check the path");
    const fs::path given = absolutePath(source), path = thatLooksLike(given).value_or(given);
    Expected<SetPlan> plan = planSource(path);
    if (!plan)
        return tl::unexpected(plan.error());
    return Opener(std::move(*plan), path, progress, early).run();
}

} // namespace relievo
