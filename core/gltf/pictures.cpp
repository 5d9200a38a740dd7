// Pictures of mesh files: beside them, under the paths of the machine that wrote them, or inside them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/pictures.h"
#include "core/gltf/gltf_document.h"
#include "core/ground/file.h"
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include "core/ground/text_cursor.h"
#include <algorithm>

namespace relievo {
namespace fs = std::filesystem;

namespace {
bool isFile(const fs::path& file)
{
    std::error_code code;
    return fs::is_regular_file(file, code);
}

std::optional<fs::path> inAnyCase(const fs::path& folder, const std::string& name)
{
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
        if (looksAlike(entry->path().filename().string(), name) && isFile(entry->path()))
            return entry->path();
    return std::nullopt;
}

struct Embedded {
    fs::path file;
    int picture;
};

std::optional<Embedded> embeddedOf(const fs::path& name)
{
    const std::string text = name.string();
    const std::size_t mark = text.rfind('#');
    if (mark == text.npos || text.size() - mark > 7 || isFile(name))
        return std::nullopt;
    const std::optional<long long> picture = integerOf(std::string_view(text).substr(mark + 1));
    const fs::path file = text.substr(0, mark);
    const std::string suffix = lowerSuffix(file);
    if (!picture || *picture < 0 || (suffix != ".glb" && suffix != ".gltf"))
        return std::nullopt;
    return Embedded{file, int(*picture)};
}
} // namespace

std::optional<fs::path> findPicture(const std::vector<fs::path>& folders, std::string name)
{
    std::ranges::replace(name, '\\', '/');
    const std::string last = name.substr(name.rfind('/') + 1);
    if (last.empty() || last.find('\0') != last.npos)
        return std::nullopt;
    for (const fs::path& folder : folders)
        if (isFile(folder / name)) // an absolute name stands for itself
            return absolutePath(folder / name);
    for (const fs::path& folder : folders)
        if (const std::optional<fs::path> found = inAnyCase(folder / fs::path(name).relative_path().parent_path(), last))
            return absolutePath(*found);
    for (const fs::path& folder : folders)
        if (const std::optional<fs::path> found = inAnyCase(folder, last))
            return absolutePath(*found);
    return std::nullopt;
}

std::string embeddedPictureName(const fs::path& gltf, int picture)
{
    return absolutePath(gltf).string() + '#' + std::to_string(picture);
}

bool namesEmbeddedPicture(const fs::path& name)
{
    return embeddedOf(name).has_value();
}

fs::path fileOfPicture(const fs::path& name)
{
    const std::optional<Embedded> embedded = embeddedOf(name);
    const std::optional<NamedLayer> layer = layerOf(name);
    const fs::path file = embedded ? embedded->file : layer ? layer->file : name;
    return thatLooksLike(file).value_or(file);
}

bool pictureMayExist(const fs::path& name)
{
    return isFile(fileOfPicture(name));
}

std::optional<NamedLayer> layerOf(const fs::path& name)
{
    const std::string text = name.string();
    const std::size_t mark = lowered(text).rfind(".exr#");
    if (mark == text.npos || mark + 5 == text.size() || isFile(name))
        return std::nullopt;
    return NamedLayer{text.substr(0, mark + 4), text.substr(mark + 5)};
}

std::string layerName(const fs::path& exr, const std::string& layer)
{
    return exr.string() + '#' + layer;
}

Expected<std::vector<std::byte>> readEmbeddedPicture(const fs::path& name)
{
    const std::optional<Embedded> embedded = embeddedOf(name);
    if (!embedded)
        return failure(ErrorCode::Unreadable, name.string(), "this does not name a picture inside a glTF file");
    return loadGltfPicture(embedded->file, embedded->picture);
}

} // namespace relievo
