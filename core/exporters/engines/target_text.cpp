// Reading targets: the program's own and users'.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/target_text.h"
#include "core/exporters/engines/embedded_targets.h"
#include "core/ground/file.h"
#include "core/ground/text.h"
#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

namespace relievo {
namespace fs = std::filesystem;

namespace {
using Json = nlohmann::json;
constexpr std::size_t kLongest = std::size_t(1) << 20; // bytes of a target's file
constexpr std::string_view kSection = "=== ", kEach = " each texture";

std::string listed(const std::vector<std::string>& words)
{
    std::string list;
    for (const std::string& word : words)
        list += word + ' ';
    return list;
}

class Reader {
public:
    Reader(const std::string& where, TargetText& target) : m_where(where), m_target(target) { }

    Expected<void> readTextures(const Json& head)
    {
        if (!head.contains("textures") || !head["textures"].is_array())
            return wrong("textures", "must be a list of textures");
        for (std::size_t i = 0; i < head["textures"].size(); ++i)
            if (auto read = readTexture(head["textures"][i], "textures[" + std::to_string(i) + ']'); !read)
                return read;
        return {};
    }

    // A user's row. Its words are kept in the target.
    Expected<void> readRow(const Json& head, const std::string& key)
    {
        auto words = std::make_unique<std::vector<std::string>>();
        words->reserve(8); // views into them stay good
        const auto keep = [&words](std::string word) -> std::string_view { return words->emplace_back(std::move(word)); };
        auto row = std::make_unique<ExportRow>();
        row->key = keep(key);
        row->group = ExportGroup::Own;
        row->icon = "own-target";
        row->label = keep(head.value("label", key));
        row->help = keep(head.value("help", "A target of your own: " + m_where));
        EngineFacts& engine = row->engine;
        engine.limits = keep(head.value("limits", ""));
        engine.technique = keep(head.value("technique", ""));
        if (!engine.technique.empty() && !findTechnique(engine.technique))
            return wrong("technique", "is no technique (relievo describe techniques lists them)");
        if (auto read = readHeight(head.value("height", Json::object()), engine); !read)
            return read;
        const Json depth = head.value("depth", Json::object());
        engine.property = keep(depth.value("property", ""));
        if (auto read = readDepth(depth, engine); !read)
            return read;
        m_target.words = std::move(words);
        m_target.own = std::move(row);
        return {};
    }

    // Every member's name is one that there is, in all of the JSON.
    Expected<void> checkNames(const Json& object, const std::string& at, std::initializer_list<std::string_view> names) const
    {
        if (!object.is_object())
            return wrong(at, "must be an object");
        for (const auto& [name, value] : object.items())
            if (std::ranges::find(names, name) == names.end())
                return wrong(at.empty() ? name : at + '.' + name, "is not known");
        return {};
    }

private:
    tl::unexpected<Error> wrong(const std::string& member, const std::string& what) const
    {
        return failure(m_where + ": " + member, what, "The chapter \"Targets of your own\" of the manual has an example");
    }

    Expected<void> readTexture(const Json& json, const std::string& at)
    {
        if (auto named = checkNames(json, at, {"key", "file", "channels", "bits", "srgb", "when"}); !named)
            return named;
        PackedTexture texture;
        texture.key = json.value("key", "");
        if (texture.key.empty() || texture.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
            return wrong(at + ".key", "must be a word of small letters, digits and _");
        if (std::ranges::count(m_target.textures, texture.key, &PackedTexture::key))
            return wrong(at + ".key", "stands there twice");
        texture.file = json.value("file", "");
        if (std::ranges::find(kTextureSuffixes, lowerSuffix(texture.file)) == std::end(kTextureSuffixes))
            return wrong(at + ".file", "must end in .png, .tif, .tga, .jpg or .exr");
        for (const Json& word : json.value("channels", Json::array())) {
            const std::optional<PackedChannel> channel = word.is_string() ? channelOf(word.get<std::string>()) : std::nullopt;
            if (!channel)
                return wrong(
                    at + ".channels", word.dump() + " is no channel; there are " + listed(channelWords()) + "and numbers from 0.0 to 1.0");
            texture.channels.push_back(*channel);
        }
        if (texture.channels.empty() || texture.channels.size() > 4)
            return wrong(at + ".channels", "must be 1 to 4 words");
        texture.bits = json.value("bits", lowerSuffix(texture.file) == ".exr" ? 32 : 8);
        if (std::ranges::find(kTextureBits, texture.bits) == std::end(kTextureBits))
            return wrong(at + ".bits", "must be 8, 16 or 32");
        texture.srgb = json.value("srgb", false);
        const auto when = choiceOf<PackedTexture::When>(json.value("when", std::string(wordOf(texture.when))));
        if (!when)
            return wrong(at + ".when", "can only be \"8 bits show\", \"exact search\", \"filtered search\", \"codes\" or \"no codes\"");
        texture.when = *when;
        m_target.textures.push_back(std::move(texture));
        return {};
    }

    Expected<void> readHeight(const Json& height, EngineFacts& engine) const
    {
        if (auto known = checkNames(height, "height", {"channel", "sense", "zero", "zeroIsFree", "bits", "green"}); !known)
            return known;
        const std::optional<Channel> channel = choiceOf<Channel>(height.value("channel", "r"));
        if (!channel || *channel == Channel::Rgb)
            return wrong("height.channel", "must be r, g, b or a");
        engine.channel = *channel;
        const std::string sense = height.value("sense", "height");
        if (sense != "height" && sense != "depth")
            return wrong("height.sense", "must be \"height\" (white is high) or \"depth\" (white is deep)");
        engine.isDepth = sense == "depth";
        engine.zero = height.value("zero", 1.f);
        if (!(engine.zero >= 0.f && engine.zero <= 1.f))
            return wrong("height.zero", "must lie in 0 to 1");
        engine.zeroIsFree = height.value("zeroIsFree", false);
        engine.bits = height.value("bits", 16);
        return {};
    }

    Expected<void> readDepth(const Json& depth, EngineFacts& engine) const
    {
        if (auto known = checkNames(depth, "depth", {"property", "of", "factor", "min", "max"}); !known)
            return known;
        const std::optional<DepthOf> of = choiceOf<DepthOf>(depth.value("of", "m"));
        if (!of)
            return wrong("depth.of", "must be \"tile\" or \"m\"");
        engine.of = *of;
        engine.factor = depth.value("factor", 1.f);
        engine.min = depth.value("min", 0.f);
        engine.max = depth.value("max", engine.max);
        if (!(engine.factor > 0.f) || !(engine.min >= 0.f) || !(engine.max > engine.min))
            return wrong("depth", "factor must be positive, and min less than max");
        return {};
    }

    const std::string& m_where;
    TargetText& m_target;
};

// The sections after the JSON.
Expected<void> readSections(const std::string& text, std::size_t at, TargetText& target)
{
    int line = 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
    while (at < text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view row(text.data() + at, end - at);
        at = std::min(end + 1, text.size());
        if (row.starts_with(kSection)) {
            std::string_view name = row.substr(kSection.size());
            const bool each = name.ends_with(kEach);
            if (each)
                name.remove_suffix(kEach.size());
            if (name.empty())
                return failure(target.where + ':' + std::to_string(line), "the file has no name", "Write === NAME");
            target.files.push_back({std::string(name), {}, each, line + 1});
        } else {
            target.files.back().text.append(row).push_back('\n');
        }
        ++line;
    }
    return {};
}
} // namespace

Expected<TargetText> parseTarget(const std::string& text, const std::string& where, bool isOwn)
{
    std::size_t sections = text.starts_with(kSection) ? 0 : text.find("\n" + std::string(kSection));
    sections = sections == std::string::npos ? text.size() : sections + (sections > 0 ? 1 : 0);
    TargetText target;
    target.where = where;
    try {
        const Json head = Json::parse(text.begin(), text.begin() + std::ptrdiff_t(sections), nullptr, true, true);
        Reader reader(where, target);
        if (auto known = reader.checkNames(head, "", {"label", "help", "limits", "technique", "height", "depth", "textures"}); !known)
            return tl::unexpected(known.error());
        if (auto read = reader.readTextures(head); !read)
            return tl::unexpected(read.error());
        if (auto read = isOwn ? reader.readRow(head, fs::path(where).stem().string()) : Expected<void>(); !read)
            return tl::unexpected(read.error());
    } catch (const Json::exception& e) { // a member of another type, or no JSON
        return failure(ErrorCode::Unreadable, where, std::string("its JSON cannot be used: ") + e.what(), "Correct it there");
    }
    if (auto read = readSections(text, sections, target); !read)
        return tl::unexpected(read.error());
    return target;
}

Expected<TargetText> readPacking(const std::filesystem::path& file)
{
    const auto text = readText(file);
    return text ? parseTarget(*text, file.string(), false) : tl::unexpected(text.error());
}

std::string packingText(const std::vector<PackedTexture>& textures)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PackedTexture& texture : textures) {
        nlohmann::ordered_json one
            = {{"key", texture.key}, {"file", texture.file}, {"channels", nlohmann::ordered_json::array()}, {"bits", texture.bits}};
        for (const PackedChannel& channel : texture.channels)
            one["channels"].push_back(channel.word);
        if (texture.srgb)
            one["srgb"] = true;
        if (texture.when != PackedTexture::When::Always)
            one["when"] = wordOf(texture.when);
        list.push_back(std::move(one));
    }
    return nlohmann::ordered_json{{"textures", list}}.dump(4, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

const TargetText& textOf(const ExportRow& row)
{
    if (row.text)
        return *row.text;
    static std::mutex mutex;
    static std::map<std::string, TargetText, std::less<>> read;
    const std::scoped_lock lock(mutex);
    const auto found = read.find(row.key);
    if (found != read.end())
        return found->second;
    const std::string where = std::string(row.key) + ".tpl";
    const auto embedded = std::ranges::find(embeddedTargets(), where, &EmbeddedTarget::name);
    Expected<TargetText> target = parseTarget(std::string(embedded->text), where, false); // tested for each row
    return read.emplace(row.key, std::move(*target)).first->second;
}

Expected<const ExportRow*> ownTarget(const fs::path& file)
{
    const Expected<std::string> text = readText(file, kLongest);
    if (!text)
        return tl::unexpected(text.error());
    Expected<TargetText> target = parseTarget(*text, file.string(), true);
    if (!target)
        return tl::unexpected(target.error());
    static std::mutex mutex;
    static std::vector<std::unique_ptr<const TargetText>> kept; // rows of them may still be shown
    const std::scoped_lock lock(mutex);
    auto& own = kept.emplace_back(std::make_unique<const TargetText>(std::move(*target)));
    own->own->text = own.get();
    return own->own.get();
}

} // namespace relievo
