// The table of words, and looking words up in it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/name_words.h"
#include "core/ground/name_forms.h"
#include <array>
#include <unordered_map>

namespace relievo {
namespace {
// Words for kinds beside the suffixes of kMapKinds. refl is Poliigon's reflection map, of its specular workflow; c, dp and ro are
// Archicad's.
struct ExtraWords {
    MapKind kind;
    std::string_view words;
};
constexpr auto kExtraWords = std::to_array<ExtraWords>({
    {MapKind::Height, "elevation heights parallax displ hm dp"},
    {MapKind::Color, "basecolour albedocolor diffusecolor diffusecolour colors coll clr bc basemap maintex b c"},
    {MapKind::Normal, "norms nrml nml ddn nm"},
    {MapKind::Roughness, "ro"},
    {MapKind::AmbientOcclusion, "mixedao ambient"},
    {MapKind::Emission, "emissivecolor selfillumination a"},
    {MapKind::Opacity, "opac transparency"},
    {MapKind::Gloss, "glossy"},
    {MapKind::Specular, "specularlevel refl"},
});
// The same in German, French, Spanish, Italian, Japanese, Chinese and Russian, with and without their marks, as folded() has them.
constexpr auto kForeignWords = std::to_array<ExtraWords>({
    {MapKind::Height,
        "höhe hoehe hohe höhenkarte hoehenkarte verschiebung hauteur hauteurs déplacement deplacement altura alturas desplazamiento "
        "altezza "
        "高さ 高さマップ ハイト ハイトマップ ディスプレイスメント 変位 高度 高度图 置换 высота высоты смещение"},
    {MapKind::Height, "tiefe tiefenkarte profondeur profundidad 深度 深さ デプス глубина"},
    {MapKind::Color,
        "farbe farben grundfarbe couleur couleurs colores colore 色 カラー ベースカラー アルベド アルベドマップ ディフューズ 拡散 颜色 "
        "цвет"},
    {MapKind::Normal, "normale normalen normales normali 法線 法線マップ ノーマル ノーマルマップ 法线 法线贴图 нормаль нормали"},
    {MapKind::Roughness, "rauheit rauigkeit rauhigkeit rugosité rugosite rugosidad rugosità rugosita 粗さ ラフネス 粗糙度 шероховатость"},
    {MapKind::Gloss, "glanz brillance brillo 光沢 グロス 光泽度 глянец"},
    {MapKind::Metallic, "metall metallisch métal métallique metallique metálico metalico metallo 金属 金属度 メタリック メタルネス металл"},
    {MapKind::AmbientOcclusion,
        "umgebungsverdeckung verdeckung oclusión oclusion occlusione 遮蔽 環境遮蔽 アンビエントオクルージョン オクルージョン 环境光遮蔽"},
    {MapKind::Specular, "spiegelung glanzlicht spéculaire speculaire especular スペキュラー 鏡面 高光"},
    {MapKind::Emission, "leuchten émission emisión emision emissione 発光 エミッション エミッシブ 自发光 свечение"},
    {MapKind::Opacity, "deckkraft transparenz opacité opacite opacidad transparencia opacità opacita 不透明度 アルファ прозрачность"},
});
constexpr std::string_view kDepthWords = "tiefe tiefenkarte profondeur profundidad 深度 深さ デプス глубина";
constexpr std::string_view kGlWords = "gl ogl opengl";
constexpr std::string_view kDxWords = "dx d3d directx";

// Maps packed in the channels of one file: the kind in r, g, b and a, in this order; None where there is none to use.
constexpr int kNone = -1;
constexpr int kH = int(MapKind::Height), kR = int(MapKind::Roughness), kG = int(MapKind::Gloss), kM = int(MapKind::Metallic),
              kO = int(MapKind::AmbientOcclusion);
struct PackedWords {
    std::string_view words;
    std::array<int, 4> kinds;
};
constexpr auto kPackedWords = std::to_array<PackedWords>({
    {"arm orm aorm occlusionroughnessmetallic occlusionroughnessmetalness aoroughnessmetallic ormap", {kO, kR, kM, kNone}},
    {"ormh", {kO, kR, kM, kH}},
    {"rma", {kR, kM, kO, kNone}},
    {"rmah", {kR, kM, kO, kH}},
    {"mra mrao", {kM, kR, kO, kNone}},
    {"ordp", {kO, kR, kH, kNone}}, // Megascans in Unreal
    {"dpra", {kH, kR, kO, kNone}},
    {"maskmap maods", {kM, kO, kNone, kG}}, // Unity HDRP: blue masks details
    {"metallicsmoothness metallicgloss metallicglossiness", {kM, kNone, kNone, kG}}, // Unity
    {"metallicroughness roughnessmetallic metalroughness metalrough roughmetal metalnessroughness", {kNone, kR, kM, kNone}},
});
constexpr std::string_view kSpecularGlossWords = "specularsmoothness specularglossiness specularglossmap"; // RGB and alpha
constexpr std::string_view kReliefWords
    = "relief reliefmap relieftex relieftexture rm nd nh dual dualdepth dualrelief normaldepth normdepth";

// Words that say nothing about the kind, at the end of a name.
constexpr std::string_view kNoise = "map maps tex texture textures image img lod rgb rgba bl final tiled tileable seamless";
constexpr std::string_view kTags = "png jpg jpeg exr tif tiff tga bmp dds hdr srgb linear raw half float 16bit 8bit 32bit";

using Dictionary = std::unordered_map<std::string, Meaning>;

Convention conventionOfWord(MapKind kind, std::string_view word)
{
    if (kind == MapKind::Height)
        return word.starts_with("depth") || listed(kDepthWords, word) ? Convention::Depth : Convention::Height;
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
    for (const ExtraWords& foreign : kForeignWords)
        forEachWord(foreign.words, [&](std::string_view word, int) { addWords(dictionary, foreign.kind, folded(word), 20); });
    for (std::string_view base : {"normal", "normals", "norm", "nor", "nrm", "nml", "n"})
        for (std::string_view list : {kGlWords, kDxWords})
            forEachWord(
                list, [&](std::string_view end, int) { addWords(dictionary, MapKind::Normal, std::string(base) + std::string(end), 0); });
    for (const PackedWords& packed : kPackedWords) {
        Meaning meaning{{}, Packing::Channels, 30, Convention::Unsure};
        for (std::size_t i = 0; i < packed.kinds.size(); ++i)
            if (packed.kinds[i] != kNone)
                meaning.roles.push_back({MapKind(packed.kinds[i]), Channel(i)});
        forEachWord(packed.words, [&](std::string_view word, int) { dictionary[std::string(word)] = meaning; });
    }
    const Meaning shiny{{{MapKind::Specular, Channel::Rgb}, {MapKind::Gloss, Channel::A}}, Packing::ColorAndAlpha, 30, Convention::Unsure};
    forEachWord(kSpecularGlossWords, [&](std::string_view word, int) { dictionary[std::string(word)] = shiny; });
    const Meaning relief{{{MapKind::Normal, Channel::Rgb}, {MapKind::Height, Channel::A}}, Packing::Relief, 30, Convention::Unsure};
    forEachWord(kReliefWords, [&](std::string_view word, int) { dictionary[std::string(word)] = relief; });
    dictionary["nh"].convention = Convention::Height;
    dictionary["nd"].convention = Convention::Depth;
    return dictionary;
}

} // namespace

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

bool listed(std::string_view list, std::string_view word)
{
    return anyWord(list, [&](std::string_view one) { return one == word; });
}

bool allDigits(std::string_view text)
{
    return !text.empty() && std::ranges::all_of(text, isDigit);
}

bool isResolution(std::string_view word)
{
    const std::size_t digits = std::size_t(std::ranges::find_if_not(word, isDigit) - word.begin());
    const std::string_view number = word.substr(0, digits), rest = word.substr(digits);
    if (digits == 0)
        return false;
    if (rest == "k" || rest == "px")
        return digits <= 5;
    if (rest.empty())
        return listed("256 512 1024 2048 4096 8192 16384", number);
    return rest[0] == 'x' && allDigits(rest.substr(1));
}

bool isTag(std::string_view word)
{
    if (listed(kTags, word) || isResolution(word) || (word.starts_with("lod") && allDigits(word.substr(3))))
        return true;
    const std::size_t digits = std::size_t(std::ranges::find_if_not(word, isDigit) - word.begin());
    const std::string_view number = word.substr(0, digits), rest = word.substr(digits);
    if (digits == 0)
        return word.size() > 1 && (word[0] == 'u' || word[0] == 'f') && listed("8 16 32", word.substr(1));
    if (listed("bit bits bpc", rest))
        return digits <= 5;
    return listed("b f", rest) && listed("8 16 32", number);
}

bool isVersion(std::string_view word)
{
    return anyWord("v ver var", [&](std::string_view start) { return word.starts_with(start) && allDigits(word.substr(start.size())); });
}

bool isNoise(std::string_view word)
{
    return listed(kNoise, word);
}

} // namespace relievo
