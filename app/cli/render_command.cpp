// relievo render: one picture, or layers of an EXR.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"
#include "core/scene/exact_distances.h"
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
    int width = 0, height = 0;
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

Result<void> write(const RenderOptions& options, std::vector<ImageLayer> layers)
{
    const bool png = lowerSuffix(options.out) == ".png";
    if (layers.size() > 1) // the first also without a name, for programs that show that one only
        layers.insert(layers.begin(), layers.front());
    const auto written = png || layers.size() == 1 ? writeImage(options.out, layers.front().image, png) : writeLayers(options.out, layers);
    if (!written)
        return problem(written.error());
    return {};
}

Result<Warnings> render(RenderOptions& options)
{
    if (const auto good = check(options); !good)
        return tl::unexpected(good.error());
    const Progress progress = shownProgress(options.common);
    auto scene = openScene(options.state, progress.part(0.f, 0.5f));
    if (!scene)
        return tl::unexpected(scene.error());
    auto context = WindowlessContext::create();
    if (!context)
        return problem(context.error());
    Renderer renderer;
    std::vector<ImageLayer> layers;
    const bool linear = lowerSuffix(options.out) == ".exr";
    for (const std::string& view : options.views) {
        const ViewRow& row = *findView(view);
        const Progress drawing = progress.part(0.5f + 0.5f * float(layers.size()) / float(options.views.size()),
            0.5f + 0.5f * float(layers.size() + 1) / float(options.views.size()));
        std::shared_ptr<const ExactDistances> exact;
        if (!row.fileOnMesh.empty() && hasMeshReference(scene->state, scene->resources)) {
            auto made = sureDistances(scene->state, 0, scene->resources, options.width, options.height, scene->warnings, drawing);
            if (!made)
                return problem(made.error());
            exact = std::move(*made);
        }
        const int samples = options.samples > 0 ? options.samples : row.isHeat || linear ? 1 : 4;
        auto image = drawPicture(renderer, scene->state, 0, scene->resources, view, options.width, options.height, samples, linear, exact);
        if (!image)
            return problem(image.error());
        if (row.isHeat && !linear)
            drawLegend(*image, heatRange(effectiveParameters(scene->state, 0), row), row.unit);
        layers.push_back({view, std::move(*image)});
        drawing.at(1.f);
    }
    if (const auto written = write(options, std::move(layers)); !written)
        return tl::unexpected(written.error());
    return scene->warnings;
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
    command->add_option("--size", options->size, "Size in pixels, 1024x768 when not given")->type_name("WxH");
    CLI::Option* one = command->add_option("--view", options->view, "What to show, see relievo describe views; shaded when not given");
    one->type_name("KEY");
    command->add_option("--views", options->views, "Several views as named layers of one .exr, the first also without a name")
        ->type_name("KEY,KEY...")
        ->delimiter(',')
        ->excludes(one);
    command
        ->add_option(
            "--samples", options->samples, "Pictures averaged for smooth edges, 1 to 64; 4 when not given, 1 for heat maps and .exr")
        ->check(CLI::Range(1, 64))
        ->type_name("N");
    command->callback([options, &exitCode] {
        const auto warnings = render(*options);
        if (!warnings) {
            exitCode = tell(warnings.error());
            return;
        }
        tell(*warnings, options->common);
        if (options->common.json)
            print(nlohmann::ordered_json{{"file", options->out}, {"width", options->width}, {"height", options->height},
                {"views", options->views}, {"warnings", warningsJson(*warnings)}});
    });
}

} // namespace relievo::cli
