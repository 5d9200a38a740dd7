// The table of foreign kinds.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/foreign_file.h"
#include "core/ground/text.h"
#include <array>
#include <fstream>
#include <string_view>

namespace relievo {
namespace {
using namespace std::string_view_literals;

// What an artist does about it.
enum class Cure { Mesh, Picture, Maps, Unpack, Terrain, Raw, Layers, Lfs, Page, Rename, Video, Points };
constexpr std::string_view textOf(Cure cure)
{
    switch (cure) {
    case Cure::Mesh:
        return "Export it as glTF, OBJ, PLY or STL";
    case Cure::Picture:
        return "Convert it to PNG, TIFF, EXR or DDS";
    case Cure::Maps:
        return "Export its maps as PNG, TIFF or EXR, and a mesh as glTF, OBJ, PLY or STL";
    case Cure::Unpack:
        return "Unpack it and open the folder or file in it; export a mesh in it as glTF, OBJ, PLY or STL";
    case Cure::Terrain:
        return "Convert it to GeoTIFF or a 32-bit float TIFF, for instance by gdal_translate";
    case Cure::Raw:
        return "Its size is told nowhere: convert it to a 16-bit PNG or a TIFF in the program that made it";
    case Cure::Layers:
        return "Export its layers as PNG, TIFF or EXR";
    case Cure::Lfs:
        return "Run git lfs pull in its folder";
    case Cure::Page:
        return "Download the file itself, not the page about it";
    case Cure::Rename:
        return "It is a glTF file: give it the suffix .glb";
    case Cure::Video:
        return "Export one picture of it as PNG";
    case Cure::Points:
        return "Make a mesh of it and export that as glTF, OBJ, PLY or STL";
    }
    return {};
}

struct ForeignRow {
    std::string_view suffixes; // lower case, separated by spaces; with a magic only such files are meant
    std::string_view magic; // first bytes; "" when the suffix alone tells
    std::string_view label; // "FBX scenes" cannot be read
    Cure cure;
};
// The first row that fits. Without suffixes the bytes alone tell, and those rows come last: many kinds are archives by their bytes.
constexpr auto kForeign = std::to_array<ForeignRow>({
    {"", "version https://git-lfs"sv, "a Git LFS pointer, which stands for a file that was not fetched", Cure::Lfs},
    {"hdr", "ENVI"sv, "ENVI headers (of raw elevation data beside them)", Cure::Terrain},
    {"hdr", "BYTEORDER"sv, "headers of raw elevation data (terrain)", Cure::Terrain},
    {"hdr", "byteorder"sv, "headers of raw elevation data (terrain)", Cure::Terrain},
    {"hdr", "NROWS"sv, "headers of raw elevation data (terrain)", Cure::Terrain},
    {"hdr", "nrows"sv, "headers of raw elevation data (terrain)", Cure::Terrain},
    {"hdr", "ncols"sv, "headers of raw elevation data (terrain)", Cure::Terrain},
    {"fbx", ""sv, "FBX scenes", Cure::Mesh},
    {"usd usda usdc usdz", ""sv, "USD scenes", Cure::Mesh},
    {"blend", ""sv, "Blender files", Cure::Mesh},
    {"3mf", ""sv, "3MF models", Cure::Mesh},
    {"dae", ""sv, "COLLADA scenes", Cure::Mesh},
    {"abc", ""sv, "Alembic scenes", Cure::Mesh},
    {"3ds max", ""sv, "3ds Max scenes", Cure::Mesh},
    {"ma mb", ""sv, "Maya scenes", Cure::Mesh},
    {"c4d", ""sv, "Cinema 4D scenes", Cure::Mesh},
    {"lwo lws", ""sv, "LightWave scenes", Cure::Mesh},
    {"hip hiplc hipnc bgeo", ""sv, "Houdini files", Cure::Mesh},
    {"ztl zpr zbp", ""sv, "ZBrush files", Cure::Mesh},
    {"skp", ""sv, "SketchUp models", Cure::Mesh},
    {"wrl x3d", ""sv, "VRML and X3D scenes", Cure::Mesh},
    {"step stp iges igs", ""sv, "CAD models (STEP, IGES)", Cure::Mesh},
    {"dxf dwg", ""sv, "AutoCAD drawings", Cure::Mesh},
    {"x md2 md3 md5mesh mdl bsp ms3d", ""sv, "models of game engines", Cure::Mesh},
    {"vdb", ""sv, "OpenVDB volumes", Cure::Mesh},
    {"las laz e57 pcd xyz", ""sv, "point clouds", Cure::Points},
    {"vrm", ""sv, "VRM avatars", Cure::Rename},
    {"ptex ptx", ""sv, "Ptex textures", Cure::Picture},
    {"mtlx", ""sv, "MaterialX documents", Cure::Maps},
    {"sbsar sbs spsm spp sbsasm", ""sv, "Substance files", Cure::Maps},
    {"mtl", ""sv, "OBJ material files by themselves", Cure::Mesh},
    {"uasset umap", ""sv, "Unreal assets", Cure::Maps},
    {"unitypackage mat prefab asset", ""sv, "Unity assets", Cure::Maps},
    {"osl oso", ""sv, "OSL shaders", Cure::Maps},
    {"ktx", ""sv, "KTX textures", Cure::Picture},
    {"ktx2", ""sv, "KTX2 textures", Cure::Picture},
    {"basis", ""sv, "Basis textures", Cure::Picture},
    {"astc", ""sv, "ASTC textures", Cure::Picture},
    {"pvr vtf crn", ""sv, "compressed textures of game engines (PVR, VTF, CRN)", Cure::Picture},
    {"svg svgz", ""sv, "vector images", Cure::Picture},
    {"gif", ""sv, "GIF images", Cure::Picture},
    {"heic heif avif", ""sv, "HEIC and AVIF pictures", Cure::Picture},
    {"jp2 j2k jpx", ""sv, "JPEG 2000 pictures", Cure::Picture},
    {"jxl", ""sv, "JPEG XL pictures", Cure::Picture},
    {"psb xcf kra clip ora afphoto ai", ""sv, "documents of painting programs", Cure::Layers},
    {"cr2 cr3 nef arw orf raf rw2 dng", ""sv, "raw photos", Cure::Picture},
    {"mp4 mov avi mkv webm", ""sv, "videos", Cure::Video},
    {"asc", ""sv, "ESRI ASCII grids (terrain)", Cure::Terrain},
    {"bil bip bsq flt adf", ""sv, "raw elevation grids (terrain)", Cure::Terrain},
    {"hgt dt0 dt1 dt2 dem", ""sv, "terrain tiles (SRTM, DTED, DEM)", Cure::Terrain},
    {"ter", ""sv, "Terragen terrains", Cure::Terrain},
    {"e00 grd nc hdf h5", ""sv, "elevation grids (terrain)", Cure::Terrain},
    {"sdb", ""sv, "raw float height fields", Cure::Raw},
    {"raw r8 r16 bin", ""sv, "raw height fields (terrain)", Cure::Raw},
    {"r32 f32", ""sv, "raw float height fields (terrain)", Cure::Raw},
    {"pdf doc docx odt", ""sv, "text documents", Cure::Page},
    {"htm html url webloc", ""sv, "web pages", Cure::Page},
    {"zip 7z rar gz tgz tar xz bz2 zst", ""sv, "archives", Cure::Unpack},
    {"", "Kaydara FBX Binary"sv, "FBX scenes", Cure::Mesh},
    {"", "BLENDER"sv, "Blender files", Cure::Mesh},
    {"", "#usda"sv, "USD scenes", Cure::Mesh},
    {"", "PXR-USDC"sv, "USD scenes", Cure::Mesh},
    {"", "Ogawa"sv, "Alembic scenes", Cure::Mesh},
    {"", "ISO-10303"sv, "CAD models (STEP)", Cure::Mesh},
    {"", "PK\3\4"sv, "archives", Cure::Unpack},
    {"", "7z\xbc\xaf\x27\x1c"sv, "archives", Cure::Unpack},
    {"", "Rar!"sv, "archives", Cure::Unpack},
    {"", "\x1f\x8b"sv, "archives", Cure::Unpack},
    {"", "\xfd\x37zXZ"sv, "archives", Cure::Unpack},
    {"", "<!DOCTYPE html"sv, "web pages", Cure::Page},
    {"", "<!doctype html"sv, "web pages", Cure::Page},
    {"", "<html"sv, "web pages", Cure::Page},
    {"", "%PDF"sv, "text documents", Cure::Page},
    {"", "GIF8"sv, "GIF images", Cure::Picture},
    {"", "\xabKTX 11"sv, "KTX textures", Cure::Picture},
    {"", "\xabKTX 20"sv, "KTX2 textures", Cure::Picture},
    {"", "\0\0\0\x0cJXL "sv, "JPEG XL pictures", Cure::Picture},
    {"", "\xff\x0a"sv, "JPEG XL pictures", Cure::Picture},
    {"", "\0\0\0\x0cjP  "sv, "JPEG 2000 pictures", Cure::Picture},
    {"", "ncols"sv, "ESRI ASCII grids (terrain)", Cure::Terrain},
});
// HEIF's name follows four bytes of length.
constexpr std::array kHeifNames = {"ftypheic"sv, "ftypheix"sv, "ftypmif1"sv, "ftypavif"sv};

bool hasWord(std::string_view list, std::string_view word)
{
    for (std::size_t at = list.find(word); at != list.npos; at = list.find(word, at + 1))
        if ((at == 0 || list[at - 1] == ' ') && (at + word.size() == list.size() || list[at + word.size()] == ' '))
            return true;
    return false;
}

std::string firstBytes(const std::filesystem::path& file)
{
    std::string bytes(64, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), std::streamsize(bytes.size()));
    bytes.resize(std::size_t(std::max<std::streamsize>(in.gcount(), 0)));
    if (bytes.starts_with("\xef\xbb\xbf"))
        bytes.erase(0, 3);
    return bytes;
}
} // namespace

std::optional<Error> foreignFile(const std::filesystem::path& file)
{
    std::error_code code;
    if (!std::filesystem::is_regular_file(file, code))
        return std::nullopt;
    const std::string bytes = firstBytes(file), dotted = lowerSuffix(file), suffix = dotted.empty() ? dotted : dotted.substr(1);
    const auto error = [&](std::string_view label, Cure cure) {
        const std::string what(label);
        const bool pointer = cure == Cure::Lfs;
        return Error{pointer ? "this is " + what : what + " cannot be read", file.string(), std::string(textOf(cure)),
            pointer ? ErrorCode::NotFound : ErrorCode::Unreadable};
    };
    for (const ForeignRow& row : kForeign)
        if ((row.suffixes.empty() || (!suffix.empty() && hasWord(row.suffixes, suffix))) && bytes.starts_with(row.magic))
            return error(row.label, row.cure);
    for (const std::string_view name : kHeifNames)
        if (bytes.size() > 12 && std::string_view(bytes).substr(4).starts_with(name))
            return error("HEIC and AVIF pictures", Cure::Picture);
    return std::nullopt;
}

} // namespace relievo
