// relievo render: one picture, or layers of an EXR.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/render/turntable.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"
#include "core/scene/exact_distances.h"
#include "core/scene/inputs.h"
#include "core/state/presets.h"
#include "core/state/views.h"
#include "render/legend.h"
#include "render/windowless.h"
#include <charconv>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {
namespace fs = std::filesystem;

namespace {

struct RenderOptions {
    Common common;
    StateOptions state;
    std::string out, size = "1024x768", view = "shaded";
    std::vector<std::string> views;
    int samples = 0;
    int bits = 8; // of a .png
    int width = 0, height = 0;
    int frames = 0; // of a sequence; 0: one picture
    bool turntable = false, lightTurn = false;
    bool allScenes = false; // `out` is a folder
};

bool parseSize(RenderOptions& options)
{
    const char* const begin = options.size.data();
    const char* const end = begin + options.size.size();
    const auto [x, first] = std::from_chars(begin, end, options.width);
    if (first != std::errc() || x == end || *x != 'x')
        return false;
    const auto [rest, second] = std::from_chars(x + 1, end, options.height);
    return second == std::errc() && rest == end && options.width > 0 && options.height > 0;
}

Result<void> check(RenderOptions& options)
{
    if (!parseSize(options))
        return problem({"\"" + options.size + "\" is not a size", "--size", "Write WIDTHxHEIGHT in pixels, such as 1024x768"}, WrongUsage);
    const std::string suffix = lowerSuffix(options.out);
    if (suffix != ".png" && suffix != ".exr")
        return problem({"a picture is written as .png or .exr", "-o " + options.out, "Choose one of these suffixes"}, WrongUsage);
    if (options.frames > 0 && numbered(options.out, 1).empty())
        return problem(
            {"there is no place for the number in this name", "-o " + options.out, "Write it as ####, as in turn.####.png"}, WrongUsage);
    if (options.frames == 0 && (options.turntable || options.lightTurn))
        return problem({"a turn takes several pictures", options.turntable ? "--turntable" : "--light-turn", "Add --frames N"}, WrongUsage);
    if (options.bits == 16 && suffix != ".png")
        return problem({"an .exr holds floats", "--bits 16", "Leave it out, or write -o FILE.png"}, WrongUsage);
    if (!options.views.empty() && suffix != ".exr")
        return problem({"several views fit into an .exr only", "--views", "Write -o FILE.exr"}, WrongUsage);
    if (options.views.empty())
        options.views = {options.view};
    for (const std::string& view : options.views) {
        if (!findView(view))
            return problem({"there is no such view", "--view " + view, "relievo describe views lists them"}, WrongUsage);
        if (std::ranges::count(options.views, view) > 1)
            return problem({"this view is named twice", "--views " + view, "Name each view once"}, WrongUsage);
    }
    return {};
}

Result<void> write(const fs::path& out, std::vector<ImageLayer> layers)
{
    const bool png = lowerSuffix(out) == ".png";
    if (layers.size() > 1) // the first also without a name, for programs that show that one only
        layers.insert(layers.begin(), layers.front());
    const auto written = png || layers.size() == 1 ? writeImage(out, layers.front().image, png) : writeLayers(out, layers);
    if (!written)
        return problem(written.error());
    return {};
}

// A depth of field needs many to be smooth.
int samplesOf(const RenderOptions& options, const Parameters& parameters, const ViewRow& view)
{
    if (options.samples > 0)
        return options.samples;
    if (parameters.fStop > 0.f && view.isColor)
        return 64;
    return view.isHeat || lowerSuffix(options.out) == ".exr" ? 1 : 4;
}

// The views of one picture.
Result<std::vector<ImageLayer>> drawn(
    const RenderOptions& options, Renderer& renderer, const State& state, Scene& scene, const Progress& progress)
{
    std::vector<ImageLayer> layers;
    const bool linear = lowerSuffix(options.out) == ".exr";
    for (const std::string& view : options.views) {
        const ViewRow& row = *findView(view);
        const Progress drawing
            = progress.part(float(layers.size()) / float(options.views.size()), float(layers.size() + 1) / float(options.views.size()));
        std::shared_ptr<const ExactDistances> exact;
        if (!row.fileOnMesh.empty() && hasMeshReference(state, scene.resources)) {
            auto made = sureDistances(state, 0, scene.resources, options.width, options.height, scene.warnings, drawing);
            if (!made)
                return problem(made.error());
            exact = std::move(*made);
        }
        const Still still{.view = view,
            .width = options.width,
            .height = options.height,
            .samples = samplesOf(options, effectiveParameters(state, 0), row),
            .type = linear           ? PixelType::F32
                : options.bits == 16 ? PixelType::U16
                                     : PixelType::U8,
            .exact = exact};
        auto image = drawStill(renderer, state, 0, scene.resources, still, drawing);
        if (!image)
            return problem(image.error());
        if (row.isHeat && !linear)
            drawLegend(*image, heatRange(effectiveParameters(state, 0), row), row.unit);
        layers.push_back({view, std::move(*image)});
        drawing.at(1.f);
    }
    return layers;
}

struct Rendered {
    std::vector<fs::path> files;
    Warnings warnings;
};

Result<void> keepWhatWasRead(const RenderOptions& options, const State& state, const fs::path& out)
{
    std::vector<fs::path> read = options.state.filesRead(), named = filesOf(state);
    read.insert(read.end(), named.begin(), named.end());
    if (const auto kept = refuseToReplace(read, out); !kept)
        return problem(kept.error());
    return {};
}

// A picture of the sequence, or the one that there is.
Result<void> drawFrame(
    const RenderOptions& options, Renderer& renderer, const State& state, Scene& scene, int frame, Rendered& done, const Progress& progress)
{
    const Turn turn = options.lightTurn ? Turn::Light : Turn::Camera;
    const fs::path out = options.frames > 0 ? numbered(options.out, frame + 1) : fs::path(options.out);
    if (auto kept = keepWhatWasRead(options, state, out); !kept)
        return kept;
    auto layers
        = drawn(options, renderer, options.frames > 0 ? turned(state, turn, float(frame) / float(options.frames)) : state, scene, progress);
    if (!layers)
        return tl::unexpected(layers.error());
    if (auto written = write(out, std::move(*layers)); !written)
        return written;
    done.files.push_back(out);
    return {};
}

Result<Rendered> render(RenderOptions& options, const Progress& progress)
{
    if (const auto good = check(options); !good)
        return tl::unexpected(good.error());
    auto scene = openScene(options.state, progress.part(0.f, 0.5f));
    if (!scene)
        return tl::unexpected(scene.error());
    auto context = WindowlessContext::create();
    if (!context)
        return problem(context.error());
    Renderer renderer;
    const int frames = std::max(options.frames, 1);
    const bool circles = options.frames > 0 && !options.lightTurn;
    const State state = circles ? withRoomToTurn(scene->state, *scene->resources.mesh, frames, float(options.width) / float(options.height))
                                : scene->state;
    Rendered done;
    for (int i = 0; i < frames; ++i) {
        const Progress drawing = progress.part(0.5f + 0.5f * float(i) / float(frames), 0.5f + 0.5f * float(i + 1) / float(frames));
        if (auto drawn = drawFrame(options, renderer, state, *scene, i, done, drawing); !drawn)
            return tl::unexpected(drawn.error());
    }
    done.warnings = scene->warnings;
    return done;
}

// All panes of a scene in one picture, two in a row.
Result<Image> drawnPanes(const RenderOptions& options, Renderer& renderer, Scene& scene, const Progress& progress)
{
    const int count = int(scene.state.panes.size()), columns = std::min(count, 2), rows = (count + columns - 1) / columns;
    Still still{.view = options.view, .width = options.width / columns, .height = options.height / rows};
    Image sheet{still.width * columns, still.height * rows, 4, PixelType::U8, 8, false, {}};
    sheet.data.resize(sheet.texelCount() * 4);
    for (int i = 0; i < count; ++i) {
        still.samples = samplesOf(options, effectiveParameters(scene.state, std::size_t(i)), *findView(options.view));
        const auto pane = drawStill(renderer, scene.state, std::size_t(i), scene.resources, still,
            progress.part(float(i) / float(count), float(i + 1) / float(count)));
        if (!pane)
            return problem(pane.error());
        const std::size_t row = std::size_t(still.width) * 4;
        for (int y = 0; y < still.height; ++y)
            std::copy_n(pane->data.begin() + std::ptrdiff_t(row) * y, row,
                sheet.data.begin() + (std::ptrdiff_t(i / columns * still.height + y) * columns + i % columns) * std::ptrdiff_t(row));
    }
    return sheet;
}

// A scene of the gallery.
Result<Warnings> renderScene(RenderOptions options, Renderer& renderer, const PresetRow& row, const fs::path& out, const Progress& progress)
{
    options.state.source = "scene:" + std::string(row.key);
    options.out = out.string();
    if (const auto good = check(options); !good)
        return tl::unexpected(good.error());
    auto scene = openScene(options.state, progress.part(0.f, 0.5f));
    if (!scene)
        return tl::unexpected(scene.error());
    if (const auto kept = keepWhatWasRead(options, scene->state, out); !kept)
        return tl::unexpected(kept.error());
    auto picture = drawnPanes(options, renderer, *scene, progress.part(0.5f, 1.f));
    if (!picture)
        return tl::unexpected(picture.error());
    if (auto written = writeImage(out, *picture, true); !written)
        return problem(written.error());
    return std::move(scene->warnings);
}

// Every scene as a picture of the folder.
Result<Rendered> renderGallery(const RenderOptions& options, const Progress& progress)
{
    if (!options.state.source.empty())
        return problem({"the scenes bring their own materials", "SOURCE " + options.state.source, "Leave it out"}, WrongUsage);
    std::error_code code;
    fs::create_directories(options.out, code);
    if (!fs::is_directory(options.out, code))
        return problem({"the folder cannot be made", options.out, "Choose a folder that you may write to", ErrorCode::NotWritable});
    auto context = WindowlessContext::create();
    if (!context)
        return problem(context.error());
    Renderer renderer;
    Rendered all;
    for (std::size_t i = 0; i < kPresets.size(); ++i) {
        if (kPresets[i].sample.empty())
            continue;
        const fs::path out = fs::path(options.out) / (std::string(kPresets[i].key) + ".png");
        const auto told = renderScene(
            options, renderer, kPresets[i], out, progress.part(float(i) / float(kPresets.size()), float(i + 1) / float(kPresets.size())));
        if (!told)
            return tl::unexpected(told.error());
        all.files.push_back(out);
        all.warnings.insert(all.warnings.end(), told->begin(), told->end());
    }
    return all;
}

} // namespace

void addRender(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "One picture of a material");
    options->state.addTo(*command);
    options->common.addTo(*command);
    options->state.addOutput(*command, "-o", options->out, "Picture to write: .png (display values) or .exr (linear float values)")
        ->required()
        ->type_name("FILE");
    command->add_option("--size", options->size, "Size in pixels, 1024x768 when not given; up to 16384 a side")->type_name("WxH");
    CLI::Option* one = command->add_option("--view", options->view, "What to show, see relievo describe views; shaded when not given");
    one->type_name("KEY");
    command->add_option("--views", options->views, "Several views as named layers of one .exr, the first also without a name")
        ->type_name("KEY,KEY...")
        ->delimiter(',')
        ->excludes(one);
    command
        ->add_option("--samples", options->samples,
            "Pictures averaged for smooth edges, 1 to 256; 4 when not given, 1 for heat maps and .exr, 64 with a depth of field")
        ->check(CLI::Range(1, kMaxSamples))
        ->type_name("N");
    command->add_option("--bits", options->bits, "Bits a channel of a .png: 8, as when not given, or 16")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("8|16");
    CLI::Option* count
        = command->add_option("--frames", options->frames, "A sequence of so many pictures that loops; #### in FILE is the number, from 1")
              ->check(CLI::Range(1, 100000))
              ->type_name("N");
    CLI::Option* table = command->add_flag("--turntable", options->turntable, "The camera goes around, as it does when nothing is said");
    command->add_flag("--light-turn", options->lightTurn, "The light goes around instead")->excludes(table);
    command->add_flag("--all-scenes", options->allScenes, "Each built-in scene as a picture in the folder FILE")->excludes(count);
    command->callback([options, &exitCode] {
        const Progress progress = shownProgress(options->common);
        const auto done = options->allScenes ? renderGallery(*options, progress) : render(*options, progress);
        if (!done) {
            exitCode = tell(done.error());
            return;
        }
        tell(done->warnings, options->common);
        if (!options->common.json)
            return;
        nlohmann::ordered_json told{{"file", done->files.front()}, {"width", options->width}, {"height", options->height},
            {"views", options->views}, {"warnings", warningsJson(done->warnings)}};
        if (options->frames > 0 || options->allScenes)
            told["files"] = done->files;
        print(told);
    });
}

} // namespace relievo::cli
