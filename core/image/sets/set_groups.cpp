// Grouping by stem.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/set_groups.h"
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace relievo {
namespace fs = std::filesystem;
namespace {
using Groups = std::map<std::string, FileGroup>;

std::set<MapKind> kindsOf(const FileGroup& group)
{
    std::set<MapKind> kinds;
    for (const NamedFile& file : group.files)
        for (const MapRole& role : file.guess.roles)
            kinds.insert(role.kind);
    return kinds;
}

bool shareKinds(const FileGroup& a, const FileGroup& b)
{
    const std::set<MapKind> ours = kindsOf(a);
    return std::ranges::any_of(kindsOf(b), [&](MapKind kind) { return ours.contains(kind); });
}

// "floor01" and "floor01a": one or two letters more, straight after.
bool nearlySame(const std::string& shorter, const std::string& longer)
{
    const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
    return !shorter.empty() && longer.size() > shorter.size() && longer.size() <= shorter.size() + 2 && longer.starts_with(shorter)
        && std::all_of(longer.begin() + std::ptrdiff_t(shorter.size()), longer.end(), isLetter);
}

void absorb(FileGroup& into, FileGroup& from)
{
    into.files.insert(into.files.end(), from.files.begin(), from.files.end());
    from.files.clear();
}

// Artists change a letter when they save a variant of one map.
void mergeNearStems(Groups& groups)
{
    for (auto& [stem, group] : groups)
        for (auto& [other, others] : groups)
            if (nearlySame(stem, other) && !group.files.empty() && !others.files.empty() && !shareKinds(group, others))
                group.kinds() >= others.kinds() ? absorb(group, others) : absorb(others, group);
    std::erase_if(groups, [](const auto& entry) { return entry.second.files.empty(); });
}

// Moves the files that `doubted` picks out of the group; they name no kind any more.
template <class Doubted> void takeOut(FileGroup& group, std::vector<NamedFile>& doubtful, Doubted doubted)
{
    for (NamedFile& file : group.files)
        if (doubted(file)) {
            file.guess.roles.clear();
            file.guess.packing = Packing::None;
            file.guess.convention = Convention::Unsure;
            file.guess.stem = file.guess.title = file.guess.whole;
            doubtful.push_back(file);
        }
    std::erase_if(group.files, [](const NamedFile& file) { return file.guess.roles.empty(); });
}

// The letter a means emission only beside colours, and where nothing else does; b means colour only beside Megascans' packed maps, c beside
// relief, and where there is no b.
bool vagueMayStay(const FileGroup& group, const NamedFile& vague)
{
    FileGroup clear = group;
    std::erase_if(clear.files, [](const NamedFile& file) { return file.guess.vague != '\0'; });
    if (vague.guess.vague == 'c')
        return !clear.holds(MapKind::Color) && (clear.holds(MapKind::Normal) || clear.holds(MapKind::Height))
            && std::ranges::none_of(group.files, [](const NamedFile& file) { return file.guess.vague == 'b'; });
    if (vague.guess.roles.front().kind == MapKind::Color)
        return !clear.holds(MapKind::Color) && std::ranges::any_of(clear.files, [](const NamedFile& file) {
            return file.guess.packing == Packing::Channels
                && std::ranges::any_of(file.guess.roles, [](const MapRole& role) { return role.kind == MapKind::Height; });
        });
    const bool weakOnly = std::ranges::all_of(clear.files, [](const NamedFile& file) { return file.guess.weak; });
    return clear.holds(MapKind::Color) && !clear.holds(MapKind::Emission) && (!weakOnly || clear.kinds() >= 2);
}

// One-letter suffixes need a second opinion: another file of the group that names another kind.
// "wall.png" beside "wall_n.png" is such an opinion: it is the colour. plain: stems of the files that name no kind.
std::vector<NamedFile> takeDoubtful(Groups& groups, const std::set<std::string>& plain)
{
    std::vector<NamedFile> doubtful;
    for (auto& [stem, group] : groups) {
        const FileGroup before = group;
        takeOut(group, doubtful, [&](const NamedFile& file) { return file.guess.vague != '\0' && !vagueMayStay(before, file); });
        const bool weakOnly = std::ranges::all_of(group.files, [](const NamedFile& file) { return file.guess.weak; });
        const bool besideColor = !stem.empty() && plain.contains(stem) && !group.holds(MapKind::Color);
        if (weakOnly && group.kinds() < (besideColor ? 1 : 2))
            takeOut(group, doubtful, [](const NamedFile&) { return true; });
    }
    std::erase_if(groups, [](const auto& entry) { return entry.second.files.empty(); });
    return doubtful;
}

std::vector<NamedFile> readNames(std::span<const fs::path> files)
{
    std::vector<NamedFile> named;
    for (const fs::path& file : files)
        named.push_back({file, guessFromName(file.stem().string())});
    return named;
}

// Files whose names all end in one workflow are read without it; what the siblings do not share is part of the name.
void dropWorkflows(std::vector<NamedFile>& files)
{
    struct WouldBe {
        std::set<MapKind> kinds, workflows;
        std::vector<std::pair<NamedFile*, NameGuess>> members;
    };
    std::map<std::string, WouldBe> groups;
    for (NamedFile& file : files)
        if (std::optional<NameGuess> reading = withoutWorkflow(file.file.stem().string())) {
            WouldBe& group = groups[reading->stem];
            group.kinds.insert(reading->roles.front().kind);
            group.workflows.insert(file.guess.roles.front().kind);
            group.members.emplace_back(&file, std::move(*reading));
        }
    for (const NamedFile& file : files) // one that has no workflow shows that the others have none
        if (const auto found = groups.find(file.guess.stem); found != groups.end() && !file.guess.roles.empty())
            groups.erase(found);
    for (auto& [stem, group] : groups)
        if (group.workflows.size() == 1 && group.kinds.size() > 1)
            for (auto& [file, reading] : group.members)
                file->guess = std::move(reading);
}

// How many of the files share a stem under some reading; `sure` leaves out readings by one letter.
struct StemCounts {
    std::map<std::string, int> all, sure;
    explicit StemCounts(const std::vector<NamedFile>& files)
    {
        for (const NamedFile& file : files) {
            std::set<std::string> ours, oursSure;
            std::vector<NameGuess> readings = otherReadings(file.file.stem().string());
            readings.push_back(file.guess);
            for (const NameGuess& reading : readings)
                if (!reading.roles.empty()) {
                    ours.insert(reading.stem);
                    if (!reading.weak)
                        oursSure.insert(reading.stem);
                }
            for (const std::string& stem : ours)
                ++all[stem];
            for (const std::string& stem : oursSure)
                ++sure[stem];
        }
    }
};

// A material's own name may end in a kind word ("HammeredMetal"): the reading that shares its stem with most others wins.
void rereadBySiblings(std::vector<NamedFile>& files)
{
    StemCounts counts(files);
    for (NamedFile& file : files) {
        int most = counts.all[file.guess.stem] - 1;
        for (NameGuess& other : otherReadings(file.file.stem().string())) {
            const int others = counts.sure[other.stem] - (!other.roles.empty() && !other.weak);
            if (others > most) {
                most = others;
                file.guess = std::move(other);
            }
        }
    }
}
} // namespace

int FileGroup::kinds() const
{
    return int(kindsOf(*this).size());
}

bool FileGroup::holds(MapKind kind) const
{
    return kindsOf(*this).contains(kind);
}

bool FileGroup::contains(const fs::path& file) const
{
    const auto same = [&](const NamedFile& one) { return one.file == file; };
    return std::ranges::any_of(files, same) || std::ranges::any_of(plain, same);
}

std::vector<FileGroup> groupFiles(std::span<const fs::path> files)
{
    Groups groups;
    std::vector<NamedFile> without;
    std::vector<NamedFile> all = readNames(files);
    dropWorkflows(all);
    rereadBySiblings(all);
    for (NamedFile& named : all) {
        if (named.guess.roles.empty()) {
            without.push_back(std::move(named));
            continue;
        }
        FileGroup& group = groups[named.guess.stem];
        group.stem = named.guess.stem;
        group.title = named.guess.title;
        group.files.push_back(std::move(named));
    }
    mergeNearStems(groups);
    std::set<std::string> plain;
    for (const NamedFile& file : without)
        plain.insert(file.guess.stem);
    for (NamedFile& file : takeDoubtful(groups, plain))
        without.push_back(std::move(file));
    for (NamedFile& file : without) {
        FileGroup& group = groups[file.guess.stem];
        if (group.files.empty() && group.plain.empty()) {
            group.stem = file.guess.stem;
            group.title = file.guess.title;
        }
        group.plain.push_back(std::move(file));
    }
    std::vector<FileGroup> sorted;
    for (auto& [stem, group] : groups)
        sorted.push_back(std::move(group));
    std::ranges::stable_sort(sorted, [](const FileGroup& a, const FileGroup& b) {
        return std::tuple(-a.kinds(), !a.holds(MapKind::Height)) < std::tuple(-b.kinds(), !b.holds(MapKind::Height));
    });
    return sorted;
}

} // namespace relievo
