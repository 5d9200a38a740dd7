// Pictures of the sides, several encoded at once, and the JSON last.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/object_files.h"
#include "core/exporters/map_images.h"
#include "core/exporters/new_files.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/object/bake/side_pictures.h"
#include "core/object/object_file.h"
#include "core/object/object_sides.h"
#include "core/scene/inputs.h"
#include "core/state/shapes.h"
#include "core/state/state_json.h"
#include <mutex>
#include <nlohmann/json.hpp>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
struct Picture {
    Image image;
    std::string name; // of the file
    Json told;
    bool isSrgb = false;
};

class Writer {
public:
    explicit Writer(const ObjectJob& job) : m_job(job), m_stem(fileStem(job.surface->mesh().name))
    {
        if (!isShape())
            m_read.push_back(job.source);
        for (const MeshMaterial& material : job.surface->mesh().materials)
            for (const fs::path& file : filesOf(material.maps))
                m_read.push_back(file);
    }

    Expected<Exported> write()
    {
        if (const auto folder = m_made.makeFolder(m_job.folder); !folder)
            return tl::unexpected(folder.error());
        auto depths = bakeDepths(*m_job.surface, m_job.options, m_job.progress.part(0.f, 0.25f));
        if (!depths)
            return tl::unexpected(depths.error());
        const auto axes = axesOf(m_job.options.sides);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float first = axes[0] ? 0.25f * float(axis + 1) : 0.25f, last = axes[0] ? first + 0.25f : 1.f;
            if (!axes[axis])
                continue;
            if (const auto written = writeAxis(*depths, axis, m_job.progress.part(first, last)); !written)
                return tl::unexpected(written.error());
        }
        const fs::path object = absolutePath(m_job.folder / (m_stem + std::string(kObjectSuffix)));
        if (const auto written = writeProject(object); !written)
            return tl::unexpected(written.error());
        if (const auto written = writeJson(depths->object, object); !written)
            return tl::unexpected(written.error());
        m_made.keep();
        m_exported.warnings = std::move(depths->warnings);
        m_job.progress.at(1.f);
        return std::move(m_exported);
    }

private:
    bool isShape() const { return std::ranges::count(kShapes, m_job.source) > 0; }

    // As the object's file names it: relative where that is possible.
    std::string toldSource() const
    {
        if (isShape() || m_job.source.empty())
            return m_job.source;
        const fs::path file = absolutePath(m_job.source), relative = file.lexically_relative(absolutePath(m_job.folder));
        return (relative.empty() ? file : relative).generic_string();
    }

    Expected<void> writeAxis(const BakedDepths& depths, std::size_t axis, const Progress& progress)
    {
        auto looks = bakePictures(*m_job.surface, depths.box, axis, m_job.options, progress.part(0.f, 0.4f));
        if (!looks)
            return tl::unexpected(looks.error());
        std::vector<Picture> pictures;
        const AxisMap& map = depths.object.axes[axis];
        for (const SideRow& side : kObjectSides) {
            if (side.axis != axis || (side.isBack && m_job.options.sides == ObjectSides::One))
                continue;
            const auto add = [&](Image image, const char* kind, const std::string& word, const char* convention, bool isSrgb) {
                const std::string name = m_stem + '_' + std::string(side.fileName) + '_' + word + ".png";
                pictures.push_back({std::move(image), name,
                    {{"side", side.key}, {"kind", kind}, {"file", name}, {"convention", convention}, {"bits", 16}}, isSrgb});
            };
            SidePictures& look = side.isBack ? looks->back : looks->front;
            for (int layer = 0; layer < map.layers; ++layer) {
                add(depthPicture(map, layer, side.isBack), "depth", "Depth" + (map.layers > 1 ? std::to_string(layer + 1) : std::string()),
                    "depth", false);
                pictures.back().told["layer"] = layer + 1;
            }
            add(std::move(look.color), "color", "Color", "srgb", true);
            add(std::move(look.normal), "normal", "Normal", "gl", false);
            add(std::move(look.roughness), "roughness", "Roughness", "linear", false);
        }
        return writePictures(std::move(pictures), progress.part(0.4f, 1.f));
    }

    Expected<void> writePictures(std::vector<Picture> pictures, const Progress& progress)
    {
        for (const Picture& picture : pictures) {
            const fs::path path = m_job.folder / picture.name;
            if (const auto free = refuseToReplace(m_read, path); !free)
                return free;
            m_made.willMake(path);
        }
        std::mutex mutex;
        std::size_t done = 0;
        Expected<void> result;
        oneapi::tbb::parallel_for(std::size_t(0), pictures.size(), [&](std::size_t i) {
            if (progress.cancelled())
                return;
            const auto written = writeImage(m_job.folder / pictures[i].name, pictures[i].image, pictures[i].isSrgb);
            pictures[i].image = {};
            const std::scoped_lock lock(mutex);
            if (!written && result)
                result = written;
            progress.at(float(++done) / float(pictures.size()));
        });
        if (progress.cancelled())
            return cancelled(m_job.folder.string());
        for (Picture& picture : pictures) {
            m_exported.files.push_back(m_job.folder / picture.name);
            m_maps.push_back(std::move(picture.told));
        }
        return result;
    }

    Expected<void> willWrite(const fs::path& path)
    {
        if (const auto free = refuseToReplace(m_read, path); !free)
            return free;
        m_made.willMake(path);
        m_exported.files.push_back(m_job.folder / path.filename());
        return {};
    }

    // Shows the object where the mesh is, as large as it.
    Expected<void> writeProject(const fs::path& object)
    {
        State state;
        state.name = m_job.surface->mesh().name;
        state.mesh = object.string();
        state.parameters.ground = true;
        fitTechniques(state);
        const fs::path path = object.parent_path() / (m_stem + ".relievo");
        const auto free = willWrite(path);
        return free ? writeState(state, path) : free;
    }

    Expected<void> writeJson(const ReliefObject& object, const fs::path& path)
    {
        const auto numbers = [](glm::dvec3 v) { return Json{v.x, v.y, v.z}; };
        const Json document{{"relievoObject", 1}, {"name", m_job.surface->mesh().name}, {"unit", "m"}, {"mesh", toldSource()},
            {"box",
                {{"center", numbers(object.center)},
                    {"halfAxes", {numbers(object.half[0]), numbers(object.half[1]), numbers(object.half[2])}}}},
            {"sides", int(m_job.options.sides)}, {"layers", m_job.options.layers}, {"size", m_job.options.size},
            {"solid", "where all axes that have maps agree: between the depth of a layer on an axis' + side and that on its - side"},
            {"meaning",
                {{"depth", "value / 65535 of the box's length, below the side's face; 65535 on all sides of the axis: nothing"},
                    {"color", "r g b sRGB; a: share of the texel that is covered; not premultiplied"},
                    {"normal", "n / 2 + 1 / 2: red along u, green against v, blue out of the side"}, {"roughness", "0 smooth, 1 rough"}}},
            {"texels",
                {{"x", "u along -z, v along -y"}, {"y", "u along +x, v along +z"}, {"z", "u along +x, v along -y"},
                    {"both", "the pictures of both sides of an axis lie on the same texels"}}},
            {"maps", m_maps}};
        if (const auto free = willWrite(path); !free)
            return free;
        return writeAtomically(path, document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
    }

    const ObjectJob& m_job;
    const std::string m_stem;
    std::vector<fs::path> m_read;
    NewFiles m_made;
    Exported m_exported;
    Json m_maps = Json::array();
};
} // namespace

Expected<Exported> writeObject(const ObjectJob& job)
{
    return Writer(job).write();
}

} // namespace relievo
