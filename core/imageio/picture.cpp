// Opening image files and deciding how they are read.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/picture.h"
#include "core/image/files/image_file.h"
#include "core/imageio/dds.h"
#include "core/imageio/layers.h"
#include "core/imageio/read.h"
#include "core/imageio/tiff_tags.h"
#include <algorithm>
#include <bit>
#include <fstream>

namespace relievo::imageio {
namespace {
constexpr double kMostBorder = 16., kMostEmpty = double(1 << 22); // pixels shown for one stored, and that are always shown
constexpr std::string_view kDamaged = "The file is damaged: export it again from the program that made it";

std::vector<std::byte> firstBytes(const std::string& file)
{
    std::vector<std::byte> bytes(32);
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    bytes.resize(std::size_t(std::max<std::streamsize>(in.gcount(), 0)));
    return bytes;
}

Refusal notAnImage(std::span<const std::byte> start, const std::string& suffix)
{
    if (start.empty())
        return {"the file is empty", "Export it again from the program that made it"};
    if (const FormatRow* named = formatOfSuffix(suffix))
        return {"the file does not hold the " + std::string(named->label) + " image that its name promises", std::string(kDamaged)};
    return {"this is not an image format that can be read", "Convert it to PNG, TIFF, JPEG, EXR, HDR, TGA, BMP or DDS"};
}

// PNG widens 1, 2 and 4 bits to 8; what the file holds stands in its first chunk (byte 24: bit depth, 25: colour type, 3 = palette).
int storedBits(const Picture& picture, std::span<const std::byte> start)
{
    const int held = int(picture.spec.format.basesize()) * 8;
    if (picture.format->name == "png" && start.size() > 25)
        return start[25] == std::byte(3) ? 8 : std::to_integer<int>(start[24]);
    if (picture.format->name != "tiff")
        return held;
    const int told = picture.spec.get_int_attribute("oiio:BitsPerSample", held);
    return told >= 1 && told <= held ? told : held;
}

PixelType pixelType(const OIIO::ImageSpec& spec)
{
    if (!spec.channelformats.empty())
        return PixelType::F32;
    return spec.format == OIIO::TypeDesc::UINT8 ? PixelType::U8 : spec.format == OIIO::TypeDesc::UINT16 ? PixelType::U16 : PixelType::F32;
}

bool isFloat(const OIIO::ImageSpec& spec)
{
    return spec.format.is_floating_point();
}

bool isCmyk(const OIIO::ImageSpec& spec)
{
    return spec.get_string_attribute("jpeg:ColorSpace") == "CMYK" || spec.get_string_attribute("tiff:ColorSpace") == "CMYK"
        || spec.get_int_attribute("tiff:PhotometricInterpretation") == 5 || spec.get_string_attribute("oiio:ColorSpace") == "CMYK";
}

std::string sizeText(int width, int height)
{
    return std::to_string(width) + " x " + std::to_string(height);
}

// Sides and count small enough to keep: one factor for both, so that texels stay square, but no side vanishes.
void chooseReduction(Picture& picture)
{
    const int width = picture.shown.width, height = picture.shown.height;
    const auto reduced = [](int side, int factor) { return (side + factor - 1) / factor; };
    int factor = 1;
    while (reduced(width, factor) > kMaxSide || reduced(height, factor) > kMaxSide
        || std::size_t(reduced(width, factor)) * std::size_t(reduced(height, factor)) > kMaxTexels)
        ++factor;
    picture.factorX = std::min(factor, width);
    picture.factorY = std::min(factor, height);
    picture.header.width = std::uint64_t(reduced(width, picture.factorX));
    picture.header.height = std::uint64_t(reduced(height, picture.factorY));
    if (factor > 1)
        picture.warnings.emplace_back("reduced",
            "the image of " + sizeText(width, height) + " texels was reduced to "
                + sizeText(int(picture.header.width), int(picture.header.height)));
}

// EXR may store less, more or another part than what is to be shown; where nothing of it would be shown, all that is stored is.
void chooseWindows(Picture& picture)
{
    const OIIO::ImageSpec& spec = picture.spec;
    picture.data = {spec.x, spec.y, spec.width, spec.height};
    picture.shown = picture.data;
    const Window display{spec.full_x, spec.full_y, spec.full_width, spec.full_height};
    if (picture.format->name != "openexr" || display.width < 1 || display.height < 1 || display == picture.data)
        return;
    const auto overlaps = [](long a, long aSize, long b, long bSize) { return a < b + bSize && b < a + aSize; };
    const bool seen = overlaps(spec.x, spec.width, display.x, display.width) && overlaps(spec.y, spec.height, display.y, display.height);
    const bool isFarLarger = double(display.width) * display.height > std::max(kMostBorder * double(spec.width) * spec.height, kMostEmpty);
    if (seen && !isFarLarger)
        picture.shown = display;
    picture.warnings.emplace_back("data-window",
        "the stored pixels (" + sizeText(spec.width, spec.height) + ") differ from the display window ("
            + sizeText(display.width, display.height)
            + (!seen              ? ") and lie outside it: the stored pixels are used"
                    : isFarLarger ? "), which is far larger: the stored pixels are used"
                                  : "): what lies outside was cut, what is missing is 0"));
}

tl::expected<void, Refusal> checkSize(const Picture& picture)
{
    const Window& w = picture.shown;
    const OIIO::ImageSpec& spec = picture.spec;
    if (spec.deep)
        return tl::unexpected(Refusal{"deep images hold no single height or colour a pixel", "Flatten it and export it again"});
    if (spec.depth > 1 || spec.tile_depth > 1)
        return tl::unexpected(Refusal{"this is a volume of several slices", "Export one slice as an image"});
    if (w.width < 1 || w.height < 1 || spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
        return tl::unexpected(Refusal{"the image has no pixels", std::string(kDamaged)});
    const int side = std::max({w.width, w.height, spec.width, spec.height});
    if (side > kMaxFileSide || double(w.width) * w.height > kMaxFileTexels || double(spec.width) * spec.height > kMaxFileTexels)
        return tl::unexpected(Refusal{"the image claims " + sizeText(spec.width, spec.height) + " texels, which is too large",
            "Reduce it to at most " + std::to_string(kMaxSide) + " texels a side"});
    return {};
}

// The number that becomes 1 where whole numbers are sent as floats.
std::uint64_t storedMaximum(const Picture& picture)
{
    if (picture.threeBytes)
        return 0xffffff;
    if (picture.type != PixelType::F32 || !picture.spec.channelformats.empty())
        return 0;
    switch (picture.spec.format.basetype) {
    case OIIO::TypeDesc::INT8:
        return 127;
    case OIIO::TypeDesc::INT16:
        return 32767;
    case OIIO::TypeDesc::INT32:
        return 2147483647;
    case OIIO::TypeDesc::UINT32:
        return 4294967295;
    default:
        return 0;
    }
}

// The library misreads rare sizes of samples.
tl::expected<void, Refusal> checkSamples(const TiffTags& tags)
{
    constexpr int kSigned = 2, kFloat = 3;
    const auto isOneOf = [&](std::initializer_list<int> sizes) { return std::ranges::count(sizes, int(tags.bits)) > 0; };
    const bool faithful = tags.format == kFloat ? isOneOf({16, 32, 64})
        : tags.format == kSigned                ? isOneOf({8, 16, 32})
                                                : tags.format < kSigned && isOneOf({1, 2, 4, 6, 8, 10, 12, 14, 16, 24, 32});
    constexpr int kLab = 8, kLastLab = 10; // CIE, ICC and ITU
    if (tags.photometric >= kLab && tags.photometric <= kLastLab)
        return tl::unexpected(Refusal{"its colors are stored as L*a*b*, which is not read", "Convert it to RGB"});
    if (faithful)
        return {};
    const char* const kind = tags.format == kFloat ? "floats" : tags.format > kFloat ? "values of a rare kind" : "numbers";
    return tl::unexpected(Refusal{"its samples are stored as " + std::to_string(tags.bits) + "-bit " + kind + ", which are not read",
        "Export it with 8 or 16 bits, or as 32-bit float"});
}

// White as the smallest number is turned by the library only in up to 8 bits.
void takeTags(Picture& picture, const TiffTags& tags)
{
    picture.threeBytes = tags.bits == 24;
    picture.inverted = tags.photometric == 0 && !(tags.bits <= 8 && tags.format == 1);
    if (!tags.survey)
        return;
    HeaderReply& header = picture.header;
    header.hasSurvey = 1;
    header.hasNoData = tags.survey->noData.has_value();
    header.texelWidth = std::bit_cast<std::uint64_t>(tags.survey->texelWidth);
    header.metres = std::bit_cast<std::uint64_t>(tags.survey->metres);
    header.noData = std::bit_cast<std::uint64_t>(tags.survey->noData.value_or(0));
}

void fillHeader(Picture& picture, std::span<const std::byte> start)
{
    HeaderReply& header = picture.header;
    header.storedMaximum = storedMaximum(picture);
    header.fileWidth = std::uint64_t(picture.shown.width);
    header.fileHeight = std::uint64_t(picture.shown.height);
    if (picture.layers.empty())
        header.fileChannels = std::uint64_t(picture.spec.nchannels);
    header.channels = std::uint64_t(picture.channels);
    header.type = std::uint64_t(picture.type);
    header.storedBits = std::uint64_t(storedBits(picture, start));
    header.storedFloat = isFloat(picture.spec);
}

// Grey with 16 bits and palettes that do not begin at 0 are not read faithfully.
bool isOddTga(const Picture& picture, std::span<const std::byte> start)
{
    if (picture.format->name != "targa" || start.size() < 18)
        return false;
    const int kind = std::to_integer<int>(start[2]) & 7, bits = std::to_integer<int>(start[16]);
    const bool shiftedPalette = start[1] == std::byte(1) && (start[3] != std::byte(0) || start[4] != std::byte(0));
    return shiftedPalette || (kind == 3 && bits != 8);
}

void tellPeculiarities(Picture& picture, std::span<const std::byte> start)
{
    if (isOddTga(picture, start))
        picture.warnings.emplace_back("unusual-tga", "the TGA header is unusual, the picture may be wrong: convert it to PNG if so");
    const int count = int(picture.header.fileChannels);
    if (count > 4)
        picture.warnings.emplace_back("channels", "only the first 4 of its " + std::to_string(count) + " channels are used");
    if (isCmyk(picture.spec))
        picture.warnings.emplace_back("cmyk", "the image is stored as CMYK and was converted to RGB without a colour profile");
    if (picture.spec.get_int_attribute("Orientation", 1) > 1)
        picture.warnings.emplace_back("orientation", "the image is stored turned (by its orientation tag): shown as stored");
    const int parts = picture.spec.get_int_attribute("oiio:subimages", 1);
    if (parts > 1 && picture.format->name != "openexr")
        picture.warnings.emplace_back("parts", "only the first of its " + std::to_string(parts) + " parts is used");
}
std::string listOf(const std::vector<std::string>& names)
{
    constexpr std::size_t kShown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i)
        text += (i > 0 ? ", " : "") + names[i].substr(0, 60);
    return names.size() > kShown ? text + " and " + std::to_string(names.size() - kShown) + " more" : text;
}

tl::expected<void, Refusal> openInput(Picture& picture, const std::string& file)
{
    DdsPlan dds;
    if (picture.format->name == "dds") {
        auto plan = planDds(file);
        if (!plan)
            return tl::unexpected(plan.error());
        dds = std::move(*plan);
    }
    picture.rewritten = dds.rewritten;
    if (dds.premultiplied)
        picture.warnings.emplace_back("premultiplied", "its colors are stored multiplied by its alpha, and are shown so");
    picture.input = dds.input ? std::move(dds.input) : OIIO::ImageInput::create(picture.format->name);
    if (!picture.input)
        return tl::unexpected(
            Refusal{"this build reads no " + std::string(picture.format->label) + " images", "Convert it to PNG or TIFF"});
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // alpha often holds height: colours must never be multiplied by it
    const std::string name = picture.rewritten ? picture.rewritten->path() : file;
    if (picture.input->open(name, picture.spec, config))
        return {};
    const std::string text = picture.input->geterror();
    const bool unknown = picture.format->name == "dds" && text.find("nsupported") != text.npos;
    return tl::unexpected(unknown ? unknownDds(dds.kind) : refusalFrom(*picture.format, text, name));
}

// Which layer of an EXR file is read. Without a wish it is the first one, and the others are told.
tl::expected<void, Refusal> chooseLayer(Picture& picture, const std::string& file, const std::string& wanted)
{
    if (picture.format->name != "openexr")
        return wanted.empty() ? tl::expected<void, Refusal>()
                              : tl::unexpected(Refusal{"only EXR files have layers", "Leave out what follows the #"});
    const std::vector<Layer> layers = layersOf(*picture.input);
    if (layers.empty())
        return {};
    std::vector<std::string> names = namesOf(layers);
    const auto named = std::ranges::find(names, wanted);
    if (!wanted.empty() && named == names.end())
        return tl::unexpected(Refusal{"it has no layer \"" + wanted + '"', "It holds " + listOf(names)});
    const std::size_t chosen = wanted.empty() ? 0 : std::size_t(named - names.begin());
    const Layer& layer = layers[chosen];
    if (!picture.input->seek_subimage(layer.part, 0))
        return tl::unexpected(refusalFrom(*picture.format, picture.input->geterror(), file));
    picture.spec = picture.input->spec();
    picture.part = layer.part;
    picture.firstChannel = layer.firstChannel;
    picture.channels = std::min(layer.channels, 4);
    picture.header.fileChannels = std::uint64_t(layer.channels);
    picture.layers = names;
    if (wanted.empty() && layers.size() > 1) {
        names.erase(names.begin());
        const std::string name = file.substr(file.rfind('/') + 1);
        picture.warnings.emplace_back("parts",
            "only its layer \"" + namesOf({layer})[0] + "\" is used; it also holds " + listOf(names) + ": choose one as " + name + '#'
                + names[0]);
    }
    return {};
}
} // namespace

Refusal tooMuchMemory()
{
    return {"the image needs more memory than one of its size may take", "It is damaged or too large: reduce or export it again"};
}

Refusal refusalFrom(const FormatRow& format, std::string text, const std::string& file)
{
    for (std::size_t at = text.find(file); !file.empty() && at != std::string::npos; at = text.find(file, at))
        text.replace(at, file.size(), "the file");
    text.resize(std::min(text.find('\n'), text.size()));
    if (text.find("bad_alloc") != text.npos || text.find("memory") != text.npos)
        return tooMuchMemory();
    std::erase_if(text, [](char c) { return c < ' ' || c > '~'; }); // bytes of the file may stand in it
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    text.resize(std::min<std::size_t>(text.size(), 200));
    const std::string what = "the " + std::string(format.label) + " data cannot be decoded" + (text.empty() ? "" : " (" + text + ")");
    return {what, std::string(kDamaged)};
}

tl::expected<Picture, Refusal> openPicture(const std::string& file, const std::string& suffix, const std::string& layer)
{
    const std::vector<std::byte> start = firstBytes(file);
    Picture picture;
    picture.format = recognise(start, suffix);
    if (!picture.format)
        return tl::unexpected(notAnImage(start, suffix));
    picture.budget = std::make_unique<Budget>(*picture.format, file);
    const std::optional<TiffTags> tags = picture.format->name == "tiff" ? tiffTags(file) : std::nullopt;
    if (const auto faithful = tags ? checkSamples(*tags) : tl::expected<void, Refusal>(); !faithful)
        return tl::unexpected(faithful.error());
    if (const auto opened = openInput(picture, file); !opened)
        return tl::unexpected(opened.error());
    picture.channels = std::min(picture.spec.nchannels, 4);
    if (const auto chosen = chooseLayer(picture, file, layer); !chosen)
        return tl::unexpected(chosen.error());
    picture.type = pixelType(picture.spec);
    if (tags)
        takeTags(picture, *tags);
    chooseWindows(picture);
    if (const auto size = checkSize(picture); !size)
        return tl::unexpected(size.error());
    picture.budget->allow(picture.spec);
    chooseReduction(picture);
    fillHeader(picture, start);
    tellPeculiarities(picture, start);
    return picture;
}

} // namespace relievo::imageio
