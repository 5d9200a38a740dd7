// Speed against error as a document: what was measured, and its forms (HTML, JSON, CSV).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/engine_drawing.h"
#include "core/analysis/heat_pictures.h"
#include "core/analysis/sweep.h"
#include "core/mesh/frames/tangents.h"
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace relievo {

// One setting's picture of one field, drawn by the GPU at `angle` degrees from the normal.
struct PictureRow {
    std::size_t setting, field, angle; // indices
    double milliseconds, ratio; // of a frame; ratio to the plain textured quad of the same run
    double psnr, flip; // of the shaded picture against the most exact one; psnr may be infinite
};

struct HeatRow {
    std::string label; // the setting
    std::vector<std::byte> fetches, error; // PNG
    double meanFetches, meanError;
};

// The relief on a mesh against the displaced mesh itself, with one parameter changed; means over the views.
struct MeshRow {
    std::string label;
    double coverage; // pixels that only one of the two covers, share of those that either covers
    double depthRmse; // of the distance along the ray where both cover, in pixels' sizes there
    double invalid; // pixels that are no numbers, of all views
    double ratio; // of a shaded frame's time to that of the first row, one run; NaN when not timed
};
struct MeshSection {
    std::string name; // of the mesh; empty: none was measured
    std::size_t triangles = 0; // of the displaced mesh
    double depth = 0.; // m
    int views = 0, width = 0, height = 0;
    std::vector<MeshRow> rows;
    std::optional<TangentDifference> tangents; // of the mesh file's own tangents, when it has any
};

// What an engine draws of one field, seen at `angle` degrees from the normal.
struct EngineRow {
    const TechniqueRow* technique; // never null
    std::size_t field; // index
    double angle;
    EngineDrawing drawing;
};
inline constexpr std::array<double, 3> kEngineAngles = {30., 60., 80.};

// Far views, lit: how a setting of the filters differs from the same view of many more pixels, averaged. At one distance, from one side.
struct FarErrors {
    double stops; // of the mean brightness; positive: brighter
    double rmse; // of the pixels' light, share of its mean
};
struct FarView {
    double angle, texelsAPixel; // degrees from the normal; along the picture's width
};
struct FarRow {
    std::string label; // the setting
    std::vector<FarErrors> errors; // by view
};
struct FarSection {
    std::string field, technique; // labels
    int width = 0, height = 0, finer = 0; // pixels, and how many more of them the reference has along each side
    std::vector<FarView> views;
    std::vector<FarRow> rows; // none: nothing was measured
};

struct Report {
    std::string title; // the source's name
    SweepPlan plan;
    std::vector<SweepRow> rows;

    // From the GPU; `angles` is empty where there is none.
    std::vector<double> angles; // degrees
    std::vector<PictureRow> pictures;
    std::string renderer; // what drew them
    std::string exactLabel; // setting of the picture that PSNR and FLIP compare with
    int pictureWidth = 0, pictureHeight = 0;

    MeshSection mesh;
    FarSection far;
    std::vector<EngineRow> engines; // every technique and field at each of kEngineAngles

    std::string heatField;
    HeatView heatView;
    std::vector<HeatRow> heats;
    Warnings warnings;
};

// One self-contained file: no script, nothing fetched.
std::string reportHtml(const Report& report);
// {"title", "conditions", "settings", "fields", "rays": [...], "totals": [...], "pictures": [...], "engines": [...], "mesh", "farViews",
// "warnings"}; percentages in percent; mesh and farViews where they were measured.
std::string reportJson(const Report& report);
// One line a setting, field and view: the rays of a band, or a picture at an angle; what does not apply is left empty. Where there are
// several fields, lines of all of them together follow those of the rays. Then engines, "engine 30" as view. Last a line a row of the mesh:
// no technique, its label as setting, the mesh as field, "mesh" as view, msRatio to the first of them; the tangents are not in it. After
// them far views: the filters as setting, "far 30 x4" (degrees, texels a pixel) as view.
std::string reportCsv(const Report& report);
// The page's table of engines, means over the fields; "" when there are none.
std::string enginesHtml(const Report& report);
// The page's table of far views; "" when there are none.
std::string farHtml(const Report& report);

// Three significant digits without an exponent: "0", "0.0312", "28.4", "1240".
std::string figure(double value);

} // namespace relievo
