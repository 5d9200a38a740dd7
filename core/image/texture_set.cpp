// Opening a texture set: names first, then channels, then pixels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/texture_set.h"
#include "core/image/convention.h"
#include "core/image/pixels.h"
#include "core/image/set_candidates.h"
#include "core/image/set_measure.h"
#include <algorithm>
#include <array>
#include <oneapi/tbb/parallel_for.h>

namespace relievo
{
namespace fs = std::filesystem;
namespace
{
constexpr std::string_view kImageSuffixes = "png jpg jpeg tif tiff exr hdr rgbe tga bmp dds webp psd ppm pgm pnm";
struct Container {
    std::string_view suffix, label;
};
constexpr auto kUnsupported = std::to_array<Container>({
    {"ktx", "KTX textures"},
    {"ktx2", "KTX2 textures"},
    {"basis", "Basis textures"},
    {"astc", "ASTC textures"},
    {"sdb", "raw float height fields"},
    {"raw", "raw height fields"},
    {"r16", "raw height fields"},
    {"r32", "raw float height fields"},
    {"svg", "vector images"},
    {"gif", "GIF images"},
});

std::string suffixOf(const fs::path& file)
{
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    return suffix.empty() ? suffix : suffix.substr(1);
}

bool isImage(const fs::path& file)
{
    const std::string suffix = suffixOf(file);
    return !suffix.empty() && (" " + std::string(kImageSuffixes) + " ").find(" " + suffix + " ") != std::string::npos;
}

const Container* unsupported(const fs::path& file)
{
    const auto found = std::ranges::find(kUnsupported, suffixOf(file), &Container::suffix);
    return found == kUnsupported.end() ? nullptr : &*found;
}

tl::unexpected<Error> refuse(const fs::path& file, const Container& container)
{
    return failure(file.string(), std::string(container.label) + " cannot be read", "Convert it to PNG, TIFF, EXR or DDS");
}

struct Listing {
    std::vector<fs::path> images, folders, others; // sorted
};

Expected<Listing> listFolder(const fs::path& folder)
{
    Listing listing;
    std::error_code code;
    for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
        std::error_code ignored;
        const fs::path& path = it->path();
        if (path.filename().string().starts_with('.'))
            continue;
        (it->is_directory(ignored) ? listing.folders : isImage(path) ? listing.images : listing.others).push_back(path);
    }
    if (code)
        return failure(folder.string(), "the folder cannot be read (" + code.message() + ")", "Check its permissions");
    for (auto* list : {&listing.images, &listing.folders, &listing.others})
        std::ranges::sort(*list);
    return listing;
}

// Downloads often keep their images one folder down ("textures").
Expected<Listing> listImages(const fs::path& folder)
{
    Expected<Listing> listing = listFolder(folder);
    if (!listing || !listing->images.empty())
        return listing;
    std::vector<Listing> below;
    for (const fs::path& sub : listing->folders)
        if (Expected<Listing> inner = listFolder(sub); inner && !inner->images.empty())
            below.push_back(std::move(*inner));
    if (below.size() == 1)
        return std::move(below[0]);
    for (const fs::path& other : listing->others)
        if (const Container* container = unsupported(other))
            return refuse(other, *container);
    return failure(folder.string(),
        below.empty() ? "there is no readable image in this folder" : "the images lie in several folders below this one",
        below.empty() ? "Choose a folder with PNG, JPEG, TIFF, EXR, TGA, BMP, HDR or DDS files" : "Choose one of them");
}

// What the names alone decide.
struct Plan {
    std::string name;
    fs::path folder;
    std::vector<NamedFile> files;
    Warnings warnings;
};

std::string listed(const std::vector<std::string>& names)
{
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i)
        text += (i > 0 ? ", " : "") + names[i];
    return names.size() > kShown ? text + " and " + std::to_string(names.size() - kShown) + " more" : text;
}

void tellOthers(const std::vector<FileGroup>& groups, Plan& plan)
{
    std::vector<std::string> sets, strays;
    for (std::size_t i = 1; i < groups.size(); ++i) {
        if (groups[i].kinds() > 0)
            sets.push_back(groups[i].title.empty() ? groups[i].files[0].file.filename().string() : groups[i].title);
        for (const NamedFile& file : groups[i].plain)
            strays.push_back(file.file.filename().string());
    }
    if (!sets.empty())
        plan.warnings.push_back({"several-sets", "the folder holds other sets too: " + listed(sets) + "; name an image of one to open it"});
    if (!strays.empty())
        plan.warnings.push_back({"ignored-file", "not used, their names tell no kind of map: " + listed(strays)});
}

// A set's own name on an image without a kind means its colour.
void addGroup(const FileGroup& group, Plan& plan)
{
    plan.files = group.files;
    for (NamedFile file : group.plain) {
        if (!group.files.empty()) {
            file.guess.roles = {{MapKind::Color, Channel::Rgb}};
            file.guess.rank = 99;
        }
        plan.files.push_back(std::move(file));
    }
    plan.name = group.title;
}

NamedFile asHeight(const fs::path& file)
{
    NamedFile named{file, guessFromName(file.stem().string())};
    named.guess.roles = {{MapKind::Height, Channel::Rgb}};
    named.guess.packing = Packing::None;
    named.guess.convention = endsInDepth(file.stem().string()) ? Convention::Depth : Convention::Height;
    return named;
}

Expected<Plan> planFolder(const fs::path& folder)
{
    const Expected<Listing> listing = listImages(folder);
    if (!listing)
        return tl::unexpected(listing.error());
    Plan plan;
    plan.folder = folder;
    const std::vector<FileGroup> groups = groupFiles(listing->images);
    if (groups[0].kinds() > 0) {
        addGroup(groups[0], plan);
        tellOthers(groups, plan);
    } else if (listing->images.size() == 1) {
        plan.files = {asHeight(listing->images[0])};
        plan.name = listing->images[0].stem().string();
    } else {
        return failure(folder.string(), "no image here has a name that tells which map it is",
            "Name them like rock_color.png and rock_height.png, or set maps by hand (--height FILE)");
    }
    if (plan.name.empty())
        plan.name = fs::absolute(folder / "x").parent_path().filename().string();
    return plan;
}

// cli.md: an image without siblings is a height map. A normal map or a packed file would make no sense as one.
Expected<Plan> planImage(const fs::path& file)
{
    if (const Container* container = unsupported(file))
        return refuse(file, *container);
    Plan plan;
    plan.folder = file.parent_path();
    plan.name = file.stem().string();
    Expected<Listing> listing = listFolder(plan.folder);
    if (!listing || std::ranges::find(listing->images, file) == listing->images.end()) {
        plan.files = {asHeight(file)};
        return plan;
    }
    const std::vector<FileGroup> groups = groupFiles(listing->images);
    const FileGroup& group = *std::ranges::find_if(groups, [&](const FileGroup& one) { return one.contains(file); });
    const bool alone = group.files.size() + group.plain.size() == 1;
    if (alone || group.files.empty()) {
        const NamedFile named{file, guessFromName(file.stem().string())};
        const bool speaks = !group.files.empty() && (named.guess.packing != Packing::None || named.guess.roles[0].kind == MapKind::Normal);
        plan.files = {speaks ? named : asHeight(file)};
        return plan;
    }
    addGroup(group, plan);
    if (plan.name.empty())
        plan.name = plan.folder.filename().string();
    return plan;
}

Expected<Plan> planSource(const fs::path& source)
{
    std::error_code code;
    const fs::file_status status = fs::status(source, code);
    if (!fs::exists(status))
        return failure(source.string(), "there is no such file or folder", "Check the path");
    return fs::is_directory(status) ? planFolder(source) : planImage(source);
}

class Opener
{
public:
    Opener(Plan plan, const fs::path& source, const Progress& progress) : m_plan(std::move(plan)), m_source(source), m_progress(progress)
    {
        m_set.name = m_plan.name;
        m_set.folder = m_plan.folder;
        m_set.warnings = m_plan.warnings;
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
            return failure(m_source.string(), "cancelled");
        if (choices.empty())
            return tl::unexpected(
                m_firstError.value_or(Error{"none of the images can be used", m_source.string(), "See the warnings of each"}));
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
            m_candidates.push_back({file.file, file.guess, rolesByChannels(file.guess, info->channels), *info, file.file == m_source});
        }
    }

    void decode(const std::vector<Choice>& choices)
    {
        std::vector<fs::path> files;
        for (const Choice& choice : choices)
            if (!m_set.images.contains(choice.candidate->file) && std::ranges::find(files, choice.candidate->file) == files.end())
                files.push_back(choice.candidate->file);
        std::vector<Expected<ImageRead>> reads(files.size());
        oneapi::tbb::parallel_for(std::size_t(0), files.size(), [&](std::size_t i) {
            const Progress quiet{{}, m_progress.stop};
            reads[i] = readImage(files[i], quiet);
            m_progress.at(float(i + 1) / float(files.size() + 1));
        });
        for (std::size_t i = 0; i < files.size(); ++i)
            take(files[i], std::move(reads[i]));
    }

    void take(const fs::path& file, Expected<ImageRead> read)
    {
        Candidate& candidate = *std::ranges::find(m_candidates, file, &Candidate::file);
        if (!read) {
            broken(file, read.error());
            candidate.roles.clear();
            m_lost = true;
            return;
        }
        m_set.warnings.insert(m_set.warnings.end(), read->warnings.begin(), read->warnings.end());
        m_set.images[file] = std::make_shared<const ImageRead>(std::move(*read));
    }

    // Whether any decoded file gives less than its name promised.
    bool lookAtPixels()
    {
        const std::size_t before = roleCount();
        for (Candidate& candidate : m_candidates)
            if (const auto found = m_set.images.find(candidate.file); found != m_set.images.end())
                judge(candidate, found->second->image);
        const bool changed = roleCount() != before || m_lost;
        m_lost = false;
        return changed;
    }

    std::size_t roleCount() const
    {
        std::size_t count = 0;
        for (const Candidate& candidate : m_candidates)
            count += candidate.roles.size();
        return count;
    }

    void judge(Candidate& candidate, const Image& image)
    {
        if (candidate.guess.packing == Packing::ColorAndAlpha && candidate.roles.size() == 2 && !alphaVaries(image))
            candidate.roles.pop_back();
        if (candidate.guess.packing != Packing::Relief || candidate.roles.size() != 2)
            return;
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
            m_set.warnings.push_back({"ignored-file", "not used, other files give the same maps better: " + listed(names)});
    }

    Plan m_plan;
    fs::path m_source;
    const Progress& m_progress;
    TextureSet m_set;
    std::vector<Candidate> m_candidates; // not resized after readHeaders: choices point into it
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

Expected<TextureSet> openTextureSet(const fs::path& source, const Progress& progress)
{
    std::error_code code;
    fs::path path = fs::absolute(source, code).lexically_normal();
    if (!path.has_filename())
        path = path.parent_path();
    Expected<Plan> plan = planSource(path);
    if (!plan)
        return tl::unexpected(plan.error());
    return Opener(std::move(*plan), path, progress).run();
}

} // namespace relievo
