// Reading texture names as ambientCG, Poly Haven, Substance, Quixel, FreePBR, 3D Textures, cgbookcase and game tools write them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/file_names.h"
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include "core/image/sets/name_words.h"
#include <algorithm>
#include <cstdlib>
#include <optional>

namespace relievo {
namespace {
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
    return folded(text);
}

constexpr std::string_view kTakes = "copy new old";

struct Word {
    std::size_t begin, end; // in the name
    std::string text; // lower case
    bool separated; // by a separator from the word before
    bool tag;
    bool number() const { return allDigits(text); }
    bool version() const { return isVersion(text) || listed(kTakes, text); } // of a file: says nothing about its map
    bool silent() const { return tag || number() || version() || isNoise(text); } // may follow the kind words
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
    const std::string whole = folded(name.substr(begin, end - begin));
    if (isTag(whole) || isVersion(whole)) {
        words.push_back({begin, end, whole, true, isTag(whole)});
        return;
    }
    for (std::size_t from = begin; from < end;) {
        std::size_t to = from + 1;
        while (to < end && !wordEndsBetween(name, to))
            ++to;
        words.push_back({from, to, folded(name.substr(from, to - from)), from == begin, false});
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
        if (!words[last - 1].silent())
            break;
    }
    return matchAtStart(words);
}

// What is left of a name without tags and without the words that `dropped` names by their index.
template <class Dropped> std::string rest(std::string_view name, const std::vector<Word>& words, Dropped dropped)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].tag || dropped(i))
            continue;
        if (!text.empty() && words[i].separated)
            text += words[i].begin > 0 ? name[words[i].begin - 1] : '_';
        text += name.substr(words[i].begin, words[i].end - words[i].begin);
    }
    return text;
}

// DISP16: a bit depth. coll2: one of several takes.
bool isKindsNumber(const Word& word)
{
    return word.number() && !word.separated && (word.text.size() == 1 || listed("16 32", word.text));
}

// What all files of a set share, as the user wrote it.
std::string titleOf(std::string_view name, const std::vector<Word>& words, const Match& match)
{
    std::size_t tail = words.size(); // from here on no word says anything
    while (tail > match.last && words[tail - 1].silent())
        --tail;
    const auto kindOrTake = [&](std::size_t i) { return (i >= match.first && i < match.last) || (i >= tail && words[i].version()); };
    const bool numbered = match.last < words.size() && isKindsNumber(words[match.last]);
    const std::string title = rest(name, words, [&](std::size_t i) { return kindOrTake(i) || (numbered && i == match.last); });
    return title.empty() ? rest(name, words, kindOrTake) : title; // height1 and height2 are no takes of one map
}

// Of several takes the latest version is wanted, and no copy.
int takeRank(const std::vector<Word>& words)
{
    int rank = 0;
    for (const Word& word : words)
        if (listed("copy old", word.text))
            rank += 30;
        else if (isVersion(word.text) && !word.text.starts_with("var"))
            rank -= std::min(std::atoi(word.text.c_str() + word.text.find_first_of("0123456789")), 20);
    return rank;
}

NameGuess guessOf(std::string_view name, const std::vector<Word>& words, const std::optional<Match>& match)
{
    NameGuess guess;
    guess.title = rest(name, words, [](std::size_t) { return false; });
    guess.whole = normalised(guess.title);
    for (const Word& word : words)
        if (word.tag && isResolution(word.text))
            guess.resolution = word.text;
    if (match)
        guess.title = titleOf(name, words, *match);
    guess.stem = normalised(guess.title);
    if (!match)
        return guess;
    guess.roles = match->meaning.roles;
    guess.packing = match->meaning.packing;
    guess.rank = match->meaning.rank + takeRank(words);
    guess.convention = match->meaning.convention;
    guess.plain = {guess.roles.back().kind, Channel::Rgb};
    const std::string text = joined(words, match->first, match->last);
    guess.weak = text.size() == 1 || listed("dx rm bc nm hm dp ro", text);
    guess.vague = text == "a" || text == "b" || text == "c" ? text.front() : '\0';
    return guess;
}

// Blender's glTF exporter joins the names of the two maps it packs: "metallic-Rock_roughness".
std::optional<NameGuess> joinedByBlender(std::string_view name)
{
    const std::size_t at = name.find('-');
    if (at == name.npos || !lowered(name.substr(0, at)).ends_with("metallic"))
        return std::nullopt;
    const auto guess = [](std::string_view part) {
        const std::vector<Word> words = wordsOf(part);
        return guessOf(part, words, matchOf(words));
    };
    const NameGuess metal = guess(name.substr(0, at));
    NameGuess both = guess(name.substr(at + 1));
    if (both.roles != std::vector{MapRole{MapKind::Roughness}} || !(metal.stem.empty() || metal.stem == both.stem))
        return std::nullopt;
    both.roles = {{MapKind::Roughness, Channel::G}, {MapKind::Metallic, Channel::B}};
    both.packing = Packing::Channels;
    return both;
}
} // namespace

NameGuess guessFromName(std::string_view given)
{
    const std::string name = composed(given);
    if (std::optional<NameGuess> both = joinedByBlender(name))
        return *both;
    const std::vector<Word> words = wordsOf(name);
    return guessOf(name, words, matchOf(words));
}

std::optional<NameGuess> withoutWorkflow(std::string_view given)
{
    const std::string name = composed(given);
    std::vector<Word> words = wordsOf(name);
    const std::optional<Match> last = matchOf(words);
    if (!last || last->first == 0 || last->last < words.size() || !(words[last->first - 1].tag || words[last->first - 1].number()))
        return std::nullopt;
    words.resize(last->first);
    const std::optional<Match> earlier = matchOf(words);
    return earlier ? std::optional(guessOf(name, words, earlier)) : std::nullopt;
}

std::vector<NameGuess> otherReadings(std::string_view given)
{
    const std::string name = composed(given);
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

namespace {
std::string lastPart(std::string_view layer)
{
    return lowered(layer.substr(layer.rfind('.') + 1));
}
} // namespace

std::optional<std::string> heightLayer(const std::vector<std::string>& layers)
{
    for (std::string_view wanted : {"height", "displacement", "disp", "depth", "z"})
        for (const std::string& layer : layers)
            if (lastPart(layer) == wanted)
                return layer;
    return std::nullopt;
}

bool isDepthLayer(std::string_view layer)
{
    return listed("depth z", lastPart(layer));
}

bool endsInDepth(std::string_view name)
{
    return folded(name).ends_with("depth") || guessFromName(name).convention == Convention::Depth;
}

std::optional<UdimTile> udimTile(std::string_view stem)
{
    constexpr std::size_t kDigits = 4;
    const auto ends = [&](std::size_t at) { return at >= stem.size() || isSeparator(stem[at]); };
    for (std::size_t at = stem.size(); at-- > 2;) {
        const std::string_view number = stem.substr(at, kDigits);
        if (!isSeparator(stem[at - 1]) || number.size() < kDigits || !ends(at + kDigits) || !allDigits(number))
            continue;
        if (const int tile = std::atoi(std::string(number).c_str()); tile > 1000 && tile < 2000)
            return UdimTile{std::string(stem.substr(0, at)) + std::string(stem.substr(at + kDigits)), tile};
    }
    return std::nullopt;
}

} // namespace relievo
