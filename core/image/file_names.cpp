// Reading texture names as ambientCG, Poly Haven, Substance, Quixel, FreePBR, 3D Textures, cgbookcase and game tools write them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/file_names.h"
#include "core/text.h"
#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

namespace relievo {
namespace {
bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}
bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
}
bool isLower(char c)
{
    return c >= 'a' && c <= 'z';
}
bool isSeparator(char c)
{
    return std::string_view("_-. ()[]{}+,").find(c) != std::string_view::npos;
}
std::string normalised(std::string text)
{
    std::ranges::replace_if(text, isSeparator, '_');
    return lowered(text);
}

// Calls visit(word, index) for each word of a list separated by spaces.
template <class Visit> void forEachWord(std::string_view list, Visit visit)
{
    int index = 0;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(' ', at), list.size());
        visit(list.substr(at, end - at), index++);
        at = end + 1;
    }
}
template <class Test> bool anyWord(std::string_view list, Test test)
{
    bool found = false;
    forEachWord(list, [&](std::string_view word, int) { found = found || test(word); });
    return found;
}
bool listed(std::string_view list, std::string_view word)
{
    return anyWord(list, [&](std::string_view one) { return one == word; });
}

// Words for kinds beside the suffixes of kMapKinds.
struct ExtraWords {
    MapKind kind;
    std::string_view words;
};
constexpr auto kExtraWords = std::to_array<ExtraWords>({
    {MapKind::Height, "elevation heights parallax"},
    {MapKind::Color, "basecolour albedocolor diffusecolor diffusecolour colors coll clr"},
    {MapKind::Normal, "norms nrml nml"},
    {MapKind::AmbientOcclusion, "mixedao ambient"},
    {MapKind::Emission, "emissivecolor selfillumination a"},
    {MapKind::Opacity, "opac transparency"},
});
constexpr std::string_view kGlWords = "gl ogl opengl";
constexpr std::string_view kDxWords = "dx d3d directx";

// Scalar maps packed in the channels of one file, in the order r g b.
struct PackedWords {
    std::string_view words;
    std::array<std::optional<MapKind>, 3> kinds;
};
const auto kPackedWords = std::to_array<PackedWords>({
    {"arm orm aorm occlusionroughnessmetallic occlusionroughnessmetalness aoroughnessmetallic aorm ormap",
        {MapKind::AmbientOcclusion, MapKind::Roughness, MapKind::Metallic}},
    {"rma", {MapKind::Roughness, MapKind::Metallic, MapKind::AmbientOcclusion}},
    {"mra", {MapKind::Metallic, MapKind::Roughness, MapKind::AmbientOcclusion}},
    {"metallicroughness roughnessmetallic metalroughness metalrough roughmetal metalnessroughness",
        {std::nullopt, MapKind::Roughness, MapKind::Metallic}},
});
constexpr std::string_view kReliefWords
    = "relief reliefmap relieftex relieftexture rm nd nh dual dualdepth dualrelief normaldepth normdepth";

// Words that say nothing about the kind, at the end of a name.
constexpr std::string_view kNoise = "map maps tex texture textures image img lod rgb rgba bl final tiled tileable seamless";
constexpr std::string_view kTags = "png jpg jpeg exr tif tiff tga bmp dds hdr srgb linear raw half float 16bit 8bit 32bit";

bool allDigits(std::string_view text)
{
    return !text.empty() && std::ranges::all_of(text, isDigit);
}

// 1k, 4096, 1024x1024, 512px, 16bit, u16, 32f: how the image is stored, not what it shows.
bool isTag(std::string_view word)
{
    if (listed(kTags, word))
        return true;
    const std::size_t digits = std::size_t(std::ranges::find_if_not(word, isDigit) - word.begin());
    const std::string_view number = word.substr(0, digits), rest = word.substr(digits);
    if (word.starts_with("lod") && allDigits(word.substr(3)))
        return true;
    if (digits == 0)
        return word.size() > 1 && (word[0] == 'u' || word[0] == 'f') && listed("8 16 32", word.substr(1));
    if (rest == "k" || rest == "px" || rest == "bit" || rest == "bits" || rest == "bpc")
        return digits <= 5;
    if (listed("b f", rest))
        return listed("8 16 32", number);
    if (rest.empty())
        return listed("256 512 1024 2048 4096 8192 16384", number);
    return rest[0] == 'x' && allDigits(rest.substr(1));
}

struct Word {
    std::size_t begin, end; // in the name
    std::string text; // lower case
    bool separated; // by a separator from the word before
    bool tag;
    bool number() const { return allDigits(text); }
};

// Ends of camelCase words, and of runs of digits.
bool wordEndsBetween(std::string_view name, std::size_t at)
{
    const char before = name[at - 1], after = name[at];
    if (isDigit(before) != isDigit(after))
        return true;
    if (isLower(before) && isUpper(after))
        return true;
    return isUpper(before) && isUpper(after) && at + 1 < name.size() && isLower(name[at + 1]);
}

void splitToken(std::string_view name, std::size_t begin, std::size_t end, std::vector<Word>& words)
{
    const std::string whole = lowered(name.substr(begin, end - begin));
    if (isTag(whole)) {
        words.push_back({begin, end, whole, true, true});
        return;
    }
    for (std::size_t from = begin; from < end;) {
        std::size_t to = from + 1;
        while (to < end && !wordEndsBetween(name, to))
            ++to;
        words.push_back({from, to, lowered(name.substr(from, to - from)), from == begin, false});
        from = to;
    }
}

std::vector<Word> wordsOf(std::string_view name)
{
    std::vector<Word> words;
    for (std::size_t at = 0; at < name.size();) {
        std::size_t end = at;
        while (end < name.size() && !isSeparator(name[end]))
            ++end;
        if (end > at)
            splitToken(name, at, end, words);
        at = end + 1;
    }
    return words;
}

struct Meaning {
    std::vector<MapRole> roles;
    Packing packing = Packing::None;
    int rank = 0;
    Convention convention = Convention::Unsure;
};
using Dictionary = std::unordered_map<std::string, Meaning>;

Convention conventionOfWord(MapKind kind, std::string_view word)
{
    if (kind == MapKind::Height)
        return word.starts_with("depth") ? Convention::Depth : Convention::Height;
    const auto ends = [&](std::string_view list) { return anyWord(list, [&](std::string_view end) { return word.ends_with(end); }); };
    return kind != MapKind::Normal ? Convention::Unsure
        : ends(kDxWords)           ? Convention::DX
        : ends(kGlWords)           ? Convention::GL
                                   : Convention::Unsure;
}

void addWords(Dictionary& dictionary, MapKind kind, std::string_view list, int firstRank)
{
    forEachWord(list, [&](std::string_view word, int index) {
        std::string plain(word);
        std::erase(plain, '_');
        dictionary.try_emplace(plain, Meaning{{{kind, Channel::Rgb}}, Packing::None, firstRank + index, conventionOfWord(kind, plain)});
    });
}

Dictionary makeDictionary()
{
    Dictionary dictionary;
    for (const MapKindRow& row : kMapKinds)
        addWords(dictionary, row.kind, row.suffixes, 0);
    for (const ExtraWords& extra : kExtraWords)
        addWords(dictionary, extra.kind, extra.words, 20);
    for (std::string_view base : {"normal", "normals", "norm", "nor", "nrm", "nml", "n"})
        for (std::string_view list : {kGlWords, kDxWords})
            forEachWord(
                list, [&](std::string_view end, int) { addWords(dictionary, MapKind::Normal, std::string(base) + std::string(end), 0); });
    for (const PackedWords& packed : kPackedWords) {
        Meaning meaning{{}, Packing::Channels, 30, Convention::Unsure};
        for (std::size_t i = 0; i < 3; ++i)
            if (packed.kinds[i])
                meaning.roles.push_back({*packed.kinds[i], Channel(i)});
        forEachWord(packed.words, [&](std::string_view word, int) { dictionary[std::string(word)] = meaning; });
    }
    const Meaning relief{{{MapKind::Normal, Channel::Rgb}, {MapKind::Height, Channel::A}}, Packing::Relief, 30, Convention::Unsure};
    forEachWord(kReliefWords, [&](std::string_view word, int) { dictionary[std::string(word)] = relief; });
    dictionary["nh"].convention = Convention::Height;
    dictionary["nd"].convention = Convention::Depth;
    return dictionary;
}

const Meaning* lookUp(const std::string& word)
{
    static const Dictionary dictionary = makeDictionary();
    if (const auto found = dictionary.find(word); found != dictionary.end())
        return &found->second;
    for (std::string_view ending : {"map", "texture", "tex"})
        if (word.size() > ending.size() + 1 && word.ends_with(ending))
            if (const auto found = dictionary.find(word.substr(0, word.size() - ending.size())); found != dictionary.end())
                return &found->second;
    return nullptr;
}

// "normheight", "alb" + "ht": a colour or normal, then a scalar map in its alpha.
std::optional<Meaning> pairOf(const std::string& first, const std::string& second)
{
    const Meaning *a = lookUp(first), *b = lookUp(second);
    if (first.size() < 2 || second.size() < 2 || !a || !b || a->packing != Packing::None || b->packing != Packing::None)
        return std::nullopt;
    const MapKind base = a->roles[0].kind, extra = b->roles[0].kind;
    if ((base != MapKind::Color && base != MapKind::Normal) || extra == MapKind::Color || extra == MapKind::Normal
        || extra == MapKind::Emission)
        return std::nullopt;
    const Convention convention = extra == MapKind::Height ? b->convention : a->convention;
    return Meaning{{{base, Channel::Rgb}, {extra, Channel::A}}, Packing::ColorAndAlpha, 30, convention};
}

std::optional<Meaning> pairInWord(const std::string& word)
{
    for (std::size_t at = word.size() - std::min<std::size_t>(word.size(), 2); at >= 2; --at)
        if (std::optional<Meaning> pair = pairOf(word.substr(0, at), word.substr(at)))
            return pair;
    return std::nullopt;
}

// The kind words of a name: words [first, last).
struct Match {
    std::size_t first, last;
    Meaning meaning;
};

std::string joined(const std::vector<Word>& words, std::size_t first, std::size_t last)
{
    std::string text;
    for (std::size_t i = first; i < last; ++i)
        text += words[i].text;
    return text;
}

bool plainWords(const std::vector<Word>& words, std::size_t first, std::size_t last)
{
    return std::none_of(
        words.begin() + std::ptrdiff_t(first), words.begin() + std::ptrdiff_t(last), [](const Word& w) { return w.tag || w.number(); });
}

// Two groups of words before `last` that together say what RGB and alpha hold.
std::optional<Match> pairBefore(const std::vector<Word>& words, std::size_t last)
{
    for (std::size_t b = 2; b >= 1; --b)
        for (std::size_t a = 3; a >= 1; --a) {
            if (a + b > last || !plainWords(words, last - a - b, last))
                continue;
            if (auto pair = pairOf(joined(words, last - a - b, last - b), joined(words, last - b, last)))
                return Match{last - a - b, last, *pair};
        }
    return std::nullopt;
}

// Words [last - count, last) as one kind.
std::optional<Match> matchRun(const std::vector<Word>& words, std::size_t count, std::size_t last)
{
    const std::string text = joined(words, last - count, last);
    if (!plainWords(words, last - count, last) || (text.size() == 1 && !words[last - 1].separated))
        return std::nullopt;
    const Meaning* meaning = lookUp(text);
    return meaning ? std::optional(Match{last - count, last, *meaning}) : std::nullopt;
}

// Kind words that end at `last`: the longest run that the dictionary knows.
std::optional<Match> matchBefore(const std::vector<Word>& words, std::size_t last)
{
    if (auto pair = pairBefore(words, last))
        return pair;
    for (std::size_t count = std::min<std::size_t>(last, 4); count >= 1; --count)
        if (auto match = matchRun(words, count, last))
            return match;
    if (auto pair = pairInWord(words[last - 1].text))
        return Match{last - 1, last, *pair};
    return std::nullopt;
}

// A name may begin with its kind ("normal_bricks"); only words that mean nothing else count there.
std::optional<Match> matchAtStart(const std::vector<Word>& words)
{
    constexpr std::string_view kClear
        = "height heightmap heightfield displacement basecolor albedo diffuse normal normalmap normalgl normaldx roughness "
          "glossiness metallic metalness ambientocclusion occlusion emission emissive opacity depthmap";
    for (std::size_t count = std::min<std::size_t>(words.size(), 2); count >= 1; --count) {
        const std::string text = joined(words, 0, count);
        if (plainWords(words, 0, count) && listed(kClear, text))
            if (const Meaning* meaning = lookUp(text))
                return Match{0, count, *meaning};
    }
    return std::nullopt;
}

std::optional<Match> matchOf(const std::vector<Word>& words)
{
    std::size_t last = words.size();
    while (last > 0 && (words[last - 1].tag || words[last - 1].number()))
        --last;
    for (; last > 0; --last) {
        if (!words[last - 1].tag && !words[last - 1].number())
            if (auto match = matchBefore(words, last))
                return match;
        if (!words[last - 1].tag && !words[last - 1].number() && !listed(kNoise, words[last - 1].text))
            break;
    }
    return matchAtStart(words);
}

// What is left of a name without tags and without words [first, last).
std::string rest(std::string_view name, const std::vector<Word>& words, std::size_t first, std::size_t last)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].tag || (i >= first && i < last))
            continue;
        if (!text.empty() && words[i].separated)
            text += words[i].begin > 0 ? name[words[i].begin - 1] : '_';
        text += name.substr(words[i].begin, words[i].end - words[i].begin);
    }
    return text;
}

NameGuess guessOf(std::string_view name, const std::vector<Word>& words, const std::optional<Match>& match)
{
    NameGuess guess;
    guess.whole = normalised(rest(name, words, 0, 0));
    guess.title = match ? rest(name, words, match->first, match->last) : rest(name, words, 0, 0);
    guess.stem = normalised(guess.title);
    if (!match)
        return guess;
    guess.roles = match->meaning.roles;
    guess.packing = match->meaning.packing;
    guess.rank = match->meaning.rank;
    guess.convention = match->meaning.convention;
    guess.plain = {guess.roles.back().kind, Channel::Rgb};
    const std::string text = joined(words, match->first, match->last);
    guess.weak = text.size() == 1 || text == "dx" || text == "rm";
    guess.vague = text == "a";
    return guess;
}
} // namespace

NameGuess guessFromName(std::string_view name)
{
    const std::vector<Word> words = wordsOf(name);
    return guessOf(name, words, matchOf(words));
}

std::vector<NameGuess> otherReadings(std::string_view name)
{
    const std::vector<Word> words = wordsOf(name);
    const std::optional<Match> match = matchOf(words);
    if (!match)
        return {};
    std::vector<NameGuess> readings;
    for (std::size_t count = match->last - match->first; --count >= 1;)
        if (const auto shorter = matchRun(words, count, match->last))
            readings.push_back(guessOf(name, words, shorter));
    readings.push_back(guessOf(name, words, std::nullopt));
    return readings;
}

bool endsInDepth(std::string_view name)
{
    return lowered(name).ends_with("depth");
}

} // namespace relievo
