// relievo compare: a contact sheet of techniques under the same camera.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measuring.h"
#include "app/cli/text_painter.h"
#include "core/analysis/report.h"
#include "core/ground/file.h"
#include "core/ground/shown_text.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"
#include "core/state/views.h"
#include "core/trace/shader_on_cpu.h"
#include "render/measure/frame_time.h"
#include "render/measure/picture_errors.h"
#include "render/measure/picture_judge.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {

namespace {

constexpr int kWidth = 480, kHeight = 360; // of each picture
constexpr int kGap = 20, kCaption = 108, kHead = 76, kRounds = 5;
constexpr glm::vec3 kPaper(0.118f), kSoft(0.62f), kInk(0.93f);

struct CompareOptions {
    Common common;
    StateOptions state;
    std::string out, csv;
    std::vector<std::string> techniques;
};

struct Cell {
    SearchSetting setting;
    Image picture, error;
    PictureErrors errors;
    double milliseconds, ratio, psnr, flip;
};

struct Sheet {
    Subject subject;
    std::vector<Cell> cells;
    std::string exactLabel;
    float errorRange;
};

Expected<Cell> measuredCell(Renderer& renderer, PictureJudge& judge, Subject& subject, const SearchSetting& setting)
{
    const State state = withSetting(subject.state, setting);
    auto picture = drawPicture(renderer, state, 0, subject.resources, knownView("shaded").key, kWidth, kHeight, 4, false);
    if (!picture)
        return tl::unexpected(picture.error());
    auto error = drawPicture(renderer, state, 0, subject.resources, knownView("error").key, kWidth, kHeight, 1, false);
    if (!error)
        return tl::unexpected(error.error());
    const auto errors = pictureErrors(renderer, state, subject.resources, kWidth, kHeight);
    if (!errors)
        return tl::unexpected(errors.error());
    const auto verdict = judge.judge(setting);
    if (!verdict)
        return tl::unexpected(verdict.error());
    return Cell{setting, std::move(*picture), std::move(*error), *errors, 0., 0., verdict->psnr, verdict->flip};
}

Expected<void> timeCells(Renderer& renderer, Sheet& sheet, const Progress& progress)
{
    std::vector<TimedFrame> frames = {plainQuad(sheet.subject.state)};
    for (const Cell& cell : sheet.cells)
        frames.push_back({withSetting(sheet.subject.state, cell.setting), knownView("shaded").key});
    const auto times = frameTimes(renderer, sheet.subject.resources, frames, kWidth, kHeight, {kRounds}, progress);
    if (!times)
        return tl::unexpected(times.error());
    for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
        sheet.cells[i].milliseconds = (*times)[i + 1];
        sheet.cells[i].ratio = (*times)[i + 1] / std::max((*times)[0], 1e-6);
    }
    return {};
}

Result<Sheet> measure(const CompareOptions& options)
{
    const auto techniques = techniquesOf(options.techniques);
    if (!techniques)
        return tl::unexpected(techniques.error());
    const Progress progress = shownProgress(options.common);
    auto subject = openSubject(options.state, true, progress.part(0.f, 0.2f));
    if (!subject)
        return tl::unexpected(subject.error());
    State& state = subject->state;
    state = ofFirstPane(state); // nothing overrides what follows
    state.parameters.heightMips = state.parameters.wireframe = false; // the search itself, at full resolution
    const auto context = WindowlessContext::create();
    if (!context)
        return problem(context.error());
    Renderer renderer;
    const std::string exactLabel = mostExactSetting(state.parameters).label;
    const float errorRange = state.parameters.errorRange;
    Sheet sheet{std::move(*subject), {}, exactLabel, errorRange};
    auto judge = PictureJudge::create(renderer, sheet.subject.state, sheet.subject.resources, kWidth, kHeight);
    if (!judge)
        return problem(judge.error());
    for (const TechniqueRow* technique : *techniques) {
        auto cell = measuredCell(renderer, *judge, sheet.subject, plainSetting(*technique, sheet.subject.state.parameters));
        if (!cell)
            return problem(cell.error());
        sheet.cells.push_back(std::move(*cell));
        progress.at(0.2f + 0.5f * float(sheet.cells.size()) / float(techniques->size()));
    }
    if (const auto timed = timeCells(renderer, sheet, progress.part(0.7f, 1.f)); !timed)
        return problem(timed.error());
    progress.at(1.f);
    return sheet;
}

void fill(Image& to, int x, int y, int width, int height, auto color)
{
    for (int j = std::max(y, 0); j < std::min(y + height, to.height); ++j)
        for (int i = std::max(x, 0); i < std::min(x + width, to.width); ++i) {
            const glm::vec3 c = color(i - x);
            const std::size_t at = (std::size_t(j) * std::size_t(to.width) + std::size_t(i)) * 4;
            for (int k = 0; k < 3; ++k)
                to.data[at + std::size_t(k)] = std::byte(std::lround(255.f * c[k]));
            to.data[at + 3] = std::byte(255);
        }
}

void paste(Image& to, const Image& from, int x, int y)
{
    for (int j = 0; j < from.height; ++j)
        for (int i = 0; i < from.width; ++i) {
            const std::size_t a = (std::size_t(j) * std::size_t(from.width) + std::size_t(i)) * 4;
            const std::size_t b = (std::size_t(y + j) * std::size_t(to.width) + std::size_t(x + i)) * 4;
            const float alpha = float(std::to_integer<int>(from.data[a + 3])) / 255.f; // transparent backgrounds show the paper
            for (std::size_t c = 0; c < 3; ++c)
                to.data[b + c] = std::byte(std::lround(
                    alpha * float(std::to_integer<int>(from.data[a + c])) + (1.f - alpha) * float(std::to_integer<int>(to.data[b + c]))));
        }
}

struct Number {
    const char* label;
    std::string value;
};

void drawCell(Image& sheet, const TextPainter& text, const Cell& cell, int x, int y)
{
    paste(sheet, cell.picture, x, y);
    paste(sheet, cell.error, x, y + kHeight + 4);
    const int top = y + 2 * kHeight + 4;
    text.draw(sheet, x, top + 24, {17, true, kInk}, cell.setting.label);
    const Number numbers[] = {{"Fetches a pixel", figure(cell.errors.meanFetches)}, {"Time", figure(cell.ratio) + " \u00d7 plain quad"},
        {"FLIP", figure(cell.flip)}, {"Depth error (RMSE)", figure(cell.errors.rmse)}, {"Missed", figure(100. * cell.errors.missed) + " %"},
        {"Most fetches", std::to_string(int(cell.errors.maxFetches))}};
    for (int i = 0; i < 6; ++i) {
        const int column = x + (i / 3) * (kWidth / 2 + 8), baseline = top + 48 + (i % 3) * 20;
        text.draw(sheet, column, baseline, {14, false, kSoft}, numbers[i].label);
        text.draw(sheet, column + (i < 3 ? 112 : 136), baseline, {14, false, kInk}, numbers[i].value);
    }
}

void drawHead(Image& picture, const TextPainter& text, const Sheet& sheet)
{
    text.draw(picture, kGap, 36, {22, true, kInk}, shownName(sheet.subject.state.name));
    text.draw(picture, kGap, 60, {14, false, kSoft}, "FLIP against " + sheet.exactLabel);
    const TextPainter::Style small{13, false, kSoft};
    const char* shown = "Depth error along the ray, share of depth";
    const int width = text.width(small, shown), left = picture.width - kGap - width;
    fill(picture, left, 34, width, 10, [&](int i) { return heatColor((float(i) + 0.5f) / float(width)); });
    text.draw(picture, left, 24, small, shown);
    text.draw(picture, left, 60, small, "0");
    char most[48];
    std::snprintf(most, sizeof most, "%g and more", double(sheet.errorRange));
    text.draw(picture, left + width - text.width(small, most), 60, small, most);
}

int columnsFor(int cells)
{
    return cells <= 4 ? cells : cells <= 6 ? 3 : cells <= 12 ? 4 : 5;
}

Image drawSheet(const Sheet& sheet, const TextPainter& text)
{
    const int count = int(sheet.cells.size()), columns = columnsFor(count), rows = (count + columns - 1) / columns;
    const int cellHeight = 2 * kHeight + 4 + kCaption;
    Image picture{kGap + columns * (kWidth + kGap), kHead + rows * cellHeight + kGap / 2, 4, PixelType::U8, 8, false, {}};
    picture.data.resize(picture.texelCount() * 4);
    fill(picture, 0, 0, picture.width, picture.height, [](int) { return kPaper; });
    drawHead(picture, text, sheet);
    for (int i = 0; i < count; ++i)
        drawCell(picture, text, sheet.cells[std::size_t(i)], kGap + (i % columns) * (kWidth + kGap), kHead + (i / columns) * cellHeight);
    return picture;
}

// The figures of a cell, once, for CSV and JSON.
struct Column {
    const char* key;
    double (*of)(const Cell& cell);
};
constexpr Column kColumns[] = {{"fetchesPerPixel", [](const Cell& c) { return c.errors.meanFetches; }},
    {"maxFetches", [](const Cell& c) { return c.errors.maxFetches; }}, {"milliseconds", [](const Cell& c) { return c.milliseconds; }},
    {"msRatio", [](const Cell& c) { return c.ratio; }}, {"depthRmse", [](const Cell& c) { return c.errors.rmse; }},
    {"maxDepthError", [](const Cell& c) { return c.errors.largest; }},
    {"missedPercent", [](const Cell& c) { return 100. * c.errors.missed; }}, {"psnr", [](const Cell& c) { return c.psnr; }},
    {"flip", [](const Cell& c) { return c.flip; }}};

std::string csvOf(const Sheet& sheet)
{
    std::string text = "technique,setting";
    for (const Column& column : kColumns)
        text += std::string(",") + column.key;
    text += '\n';
    for (const Cell& cell : sheet.cells) {
        text += std::string(cell.setting.technique->key) + ",\"" + cell.setting.label + '"';
        for (const Column& column : kColumns) {
            char buffer[40];
            text += ',' + std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, column.of(cell)).ptr);
        }
        text += '\n';
    }
    return text;
}

nlohmann::ordered_json sheetJson(const CompareOptions& options, const Sheet& sheet)
{
    nlohmann::ordered_json json{{"file", options.out}, {"comparedWith", sheet.exactLabel}};
    json["techniques"] = nlohmann::ordered_json::array();
    for (const Cell& cell : sheet.cells) {
        nlohmann::ordered_json line{{"technique", cell.setting.technique->key}, {"setting", cell.setting.label}};
        for (const Column& column : kColumns)
            line[column.key] = column.of(cell);
        json["techniques"].push_back(std::move(line));
    }
    json["warnings"] = warningsJson(sheet.subject.warnings);
    return json;
}

Result<Sheet> compare(const CompareOptions& options)
{
    if (lowerSuffix(options.out) != ".png")
        return problem({"a contact sheet is written as .png", "-o " + options.out, "Give it that suffix"}, WrongUsage);
    const auto text = TextPainter::create();
    if (!text)
        return problem(text.error());
    auto sheet = measure(options);
    if (!sheet)
        return sheet;
    if (const auto written = writeImage(options.out, drawSheet(*sheet, *text), true); !written)
        return problem(written.error());
    if (!options.csv.empty())
        if (const auto written = writeAtomically(options.csv, csvOf(*sheet)); !written)
            return problem(written.error());
    return sheet;
}

} // namespace

void addCompare(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand("compare", "A contact sheet of techniques: pictures, error maps, figures");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_option("--techniques", options->techniques, "Techniques to show, in this order; when not given all but engines")
        ->type_name("KEY,KEY...")
        ->delimiter(',');
    options->state.addOutput(*command, "-o", options->out, "Contact sheet to write, .png")->required()->type_name("SHEET.png");
    options->state.addOutput(*command, "--csv", options->csv, "The figures as CSV: fetches, milliseconds, share of the depth, percent, dB")
        ->type_name("FILE");
    command->callback([options, &exitCode] {
        const auto sheet = compare(*options);
        if (!sheet) {
            exitCode = tell(sheet.error());
            return;
        }
        tell(sheet->subject.warnings, options->common);
        if (options->common.json)
            print(sheetJson(*options, *sheet));
    });
}

} // namespace relievo::cli
