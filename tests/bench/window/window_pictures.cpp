// Pictures of the editor window in its states, to be looked at: window_pictures FOLDER [NAME ...].
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/compare_bar.h"
#include "app/window/decide/decide_dock.h"
#include "app/window/decide/distance_page.h"
#include "app/window/decide/speed_page.h"
#include "app/window/decide/speed_plot.h"
#include "app/window/decide/tune_panel.h"
#include "app/window/dialogs/engine_pictures.h"
#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/packing_editor.h"
#include "app/window/docks.h"
#include "app/window/document/editing.h"
#include "app/window/document/files.h"
#include "app/window/document/starting_scene.h"
#include "app/window/inspector/ray_inspector.h"
#include "app/window/main_window.h"
#include "app/window/palette/command_palette.h"
#include "app/window/panels/map_panel.h"
#include "app/window/panels/message_line.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/section.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/theme.h"
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QMouseEvent>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QUrl>
#include <cstdio>
#include <functional>

namespace {
using namespace relievo;

// Lets the window work until `done`, at most that many milliseconds, and a little longer so that the last picture is on the screen.
void workUntil(const std::function<bool()>& done, int limit = 10000)
{
    QElapsedTimer clock;
    clock.start();
    while (!done() && clock.elapsed() < limit)
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    clock.restart();
    while (clock.elapsed() < 700)
        QApplication::processEvents(QEventLoop::AllEvents, 20);
}

struct Scene {
    const char* name;
    QSize size;
    Look look;
    std::function<void(MainWindow&)> prepare;
};

// The ray inspector, on two techniques.
void inspectRay(MainWindow& window, const char* first, const char* second)
{
    window.document().edit("Compare two techniques", [&](State& state) {
        setPaneCount(state, 2);
        state.mesh = "plane";
        state.camera = Camera{};
        state.parameters.silhouettes = Silhouettes::Off;
        state.parameters.depth = 0.2f;
        state.panes[0].technique = first;
        state.panes[1].technique = second;
    });
    workUntil([&] { return window.viewport().isSettled(); });
    window.action("ray-inspector")->trigger();
    window.docks().inspector().pick({0, {0.42f, 0.36f}, 1.f});
    workUntil([&] { return !window.docks().inspector().busy(); });
}

// The page of the dock that helps to decide, when it is filled.
void decide(MainWindow& window, QWidget& page)
{
    window.action("speed-error")->trigger();
    DecideDock& dock = window.docks().decide();
    dock.showPage(page);
    if (&page == &dock.tuning())
        dock.tuning().find();
    workUntil([&] { return !dock.speed().sweep().busy() && !dock.tuning().busy() && !dock.distance().busy(); }, 120000);
    if (auto* plot = dock.speed().plot().findChild<QWidget*>(); plot && &page == &dock.speed() && !dock.speed().plot().front().empty()) {
        const QPointF at = dock.speed().plot().placeOf(dock.speed().plot().front()[dock.speed().plot().front().size() / 2]);
        QMouseEvent move(QEvent::MouseMove, at, plot->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(plot, &move);
    }
}

void twoPanes(MainWindow& window)
{
    window.document().edit("Compare two techniques", [](State& state) {
        setPaneCount(state, 2);
        state.mesh = "sphere";
    });
}

// As a file may have them: views and techniques of their own, the last one unlinked.
void sixPanes(MainWindow& window)
{
    State state = window.document().state();
    state.mesh = "sphere";
    state.panes = {Pane{"relief"}, Pane{"cell-cone"}, Pane{"parallax"}, Pane{"relief", {}, "fetches"}, Pane{"relief", {}, "error"},
        Pane{"relief", {}, "normal"}};
    state.panes.back().camera.emplace().yaw = 120.f;
    window.assets().openState(state, {});
}

void panes(MainWindow& window, const std::vector<Pane>& shown)
{
    State state = window.document().state();
    state.mesh = "plane";
    state.camera = Camera{};
    state.parameters.silhouettes = Silhouettes::Off;
    state.parameters.depth = 0.2f;
    state.panes = shown;
    window.assets().openState(state, {});
    workUntil([&] { return window.assets().ready() && window.viewport().isSettled(); });
}

void compare(MainWindow& window, InPlaceMode mode)
{
    panes(window, {Pane{"parallax"}, Pane{"cell-cone"}});
    window.comparing().compare(mode, true);
    workUntil([&] { return window.viewport().isSettled() && !window.viewport().places().flip().busy(); });
}

void pointAt(MainWindow& window, QPointF share)
{
    Viewport& picture = window.viewport();
    const QPointF at(share.x() * picture.width(), share.y() * picture.height());
    QMouseEvent move(QEvent::MouseMove, at, picture.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&picture, &move);
    workUntil([] { return true; });
}

// A plain outline beside that of prisms, seen from near.
void outlines(MainWindow& window)
{
    window.assets().propose("Mesh", [](State& state) {
        setPaneCount(state, 2);
        state.mesh = "torus";
        state.camera.distance = 0.7f, state.camera.pitch = 12.f, state.camera.target = glm::vec3(0.f, 0.1f, 0.f);
        for (Pane& pane : state.panes)
            pane.technique = "cell-cone";
        assign(state, *findParameter("depth"), 0.12f, kAllPanes);
        assign(state, *findParameter("silhouettes"), 3, Scope(1));
    });
}

// The other panel of a narrow window.
void showScene(MainWindow& window)
{
    auto* tabs = window.findChild<Segmented*>("panel");
    const QPointF at = tabs->segment(1).center();
    QMouseEvent press(QEvent::MouseButtonPress, at, tabs->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(tabs, &press);
}

void dragOver(MainWindow& window)
{
    static QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/home/anna/rock/rock_height.png")});
    QDragEnterEvent enter({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
}

// The export dialog with all that it shows of a target; written: after an export.
ExportDialog& showExport(MainWindow& window, const char* target, bool written)
{
    window.action("export")->trigger();
    auto& dialog = *window.findChild<ExportDialog*>();
    dialog.setTarget(target);
    dialog.setOut(QDir::temp().filePath(QString("bricks_of_") + target));
    dialog.move(16, 32);
    if (written)
        dialog.run();
    workUntil([&] { return !dialog.busy() && !dialog.findChild<EnginePictures*>()->busy(); });
    return dialog;
}

// Four lights around a sphere, their handles shown, the section of the second open.
void lights(MainWindow& window)
{
    window.assets().propose("Mesh", [](State& state) {
        state.mesh = "sphere";
        state.parameters.light2Kind = state.parameters.light4Kind = LightKind::Point, state.parameters.light3Kind = LightKind::Spot;
        state.parameters.light4Yaw = -20.f, state.parameters.light4Pitch = -20.f, state.parameters.light4Distance = 1.4f;
        state.parameters.light4Color = glm::vec3(0.2f, 1.f, 0.3f), state.parameters.environmentIntensity = 0.15f;
    });
    workUntil([&] { return window.assets().ready() && window.viewport().isSettled(); });
    for (Section* section : window.parameters().findChildren<Section*>())
        section->setOpen(section->findChild<QWidget*>("light2Kind") || section->findChild<QWidget*>("lightKind"));
    QKeyEvent shift(QEvent::KeyPress, Qt::Key_Shift, Qt::ShiftModifier);
    QApplication::sendEvent(&window.viewport(), &shift);
    workUntil([&] { return window.viewport().isSettled(); });
}

// Shadows by horizons and what the relief takes from the surroundings, with the sections that say how a picture is made.
void ambient(MainWindow& window)
{
    window.assets().propose("Mesh", [](State& state) {
        state.mesh = "sphere";
        assign(state, *findParameter("shadows"), true, kAllPanes);
        assign(state, *findParameter("shadowSearch"), 1, kAllPanes);
        assign(state, *findParameter("ambientRelief"), 2, kAllPanes);
    });
    workUntil([&] { return window.assets().ready() && window.viewport().isSettled(); });
    for (Section* section : window.parameters().findChildren<Section*>())
        section->setOpen(section->findChild<QWidget*>("shadowSearch") || section->findChild<QWidget*>("textureFilter")
            || section->findChild<QWidget*>("clearcoat") || section->findChild<QWidget*>("exposure"));
    workUntil([&] { return window.viewport().isSettled(); });
}

// A relief object in two forms, and how far it is from its mesh.
void object(MainWindow& window)
{
    State state;
    state.mesh = "object:knight";
    state.parameters.ground = true, state.camera.fill = 0.85f;
    state.panes = {Pane{"object-sides", {{"crossDiscard", false}}}, Pane{"object"}, Pane{"object", {}, "error-mesh"}};
    window.assets().openState(state, {});
    workUntil([&] { return window.assets().ready() && window.assets().resources().mesh->object && window.viewport().isSettled(); });
}

const Scene kScenes[] = {
    {"object", {1280, 800}, Look::Dark, object},
    {"impostor", {1280, 800}, Look::Light, [](MainWindow& window) { window.action("impostor")->trigger(); }},
    {"lights", {1280, 800}, Look::Dark, lights},
    {"ambient", {1280, 1200}, Look::Dark, ambient},
    {"ambient-light", {1280, 1200}, Look::Light, ambient},
    {"lights-light", {1280, 800}, Look::Light, lights},
    {"four-panes", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            panes(window, {Pane{"parallax"}, Pane{"relief"}, Pane{"relief", {{"depth", 0.1f}}, "fetches"}, Pane{"cell-cone", {}, "error"}});
        }},
    {"pane-menu", {1280, 800}, Look::Light,
        [](MainWindow& window) {
            panes(window, {Pane{"parallax"}, Pane{"relief", {{"depth", 0.1f}, {"maxSteps", 12}}}});
            window.viewport().findChildren<CaptionChoice*>("more")[1]->click();
        }},
    {"wipe", {1280, 800}, Look::Dark, [](MainWindow& window) { compare(window, InPlaceMode::Wipe); }},
    {"wipe-turned", {1280, 800}, Look::Light,
        [](MainWindow& window) {
            compare(window, InPlaceMode::Wipe);
            Viewport& picture = window.viewport();
            const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButtons held) {
                QMouseEvent event(type, at, picture.mapToGlobal(at), Qt::LeftButton, held, Qt::ShiftModifier);
                QApplication::sendEvent(&picture, &event);
            };
            const QPointF middle(picture.width() / 2., picture.height() / 2.);
            send(QEvent::MouseButtonPress, middle + QPointF(0, 40), Qt::LeftButton);
            send(QEvent::MouseMove, middle + QPointF(80, 120), Qt::LeftButton);
            send(QEvent::MouseButtonRelease, middle + QPointF(80, 120), Qt::NoButton);
            workUntil([] { return true; });
        }},
    {"difference", {1280, 800}, Look::Light, [](MainWindow& window) { compare(window, InPlaceMode::Difference); }},
    {"flip", {1280, 800}, Look::Dark, [](MainWindow& window) { compare(window, InPlaceMode::Flip); }},
    {"compare-small", {640, 480}, Look::Dark, [](MainWindow& window) { compare(window, InPlaceMode::Difference); }},
    {"loupe", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            panes(window, {Pane{"parallax"}, Pane{"cell-cone"}});
            window.action("loupe")->trigger();
            pointAt(window, {0.3, 0.5});
        }},
    {"histogram", {1280, 800}, Look::Light,
        [](MainWindow& window) {
            panes(window, {Pane{"steep", {}, "error"}, Pane{"relief", {}, "error-pixels"}});
            for (HeatLegend* legend : window.viewport().findChildren<HeatLegend*>()) {
                QEnterEvent enter({}, {}, {});
                QApplication::sendEvent(legend, &enter);
            }
            window.action("worst-point")->trigger();
            workUntil([&] { return !window.docks().inspector().busy(); });
        }},
    {"manual", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            window.action("manual")->trigger();
            window.findChild<QDialog*>("manual")->move(100, 60);
        }},
    {"zoom", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            panes(window, {Pane{"parallax"}, Pane{"cell-cone"}});
            window.viewport().places().zoom().set(8, glm::vec2(0.5f), window.viewport().places().areas()[0]);
        }},
    {"first", {1280, 800}, Look::Dark, [](MainWindow&) {}},
    {"first-light", {1280, 800}, Look::Light, [](MainWindow&) {}},
    {"wide", {1600, 1000}, Look::Dark, [](MainWindow&) {}},
    {"small", {800, 600}, Look::Dark, [](MainWindow&) {}},
    {"small-scene", {800, 600}, Look::Light, showScene},
    {"smallest", {640, 360}, Look::Dark, twoPanes},
    {"plane", {1280, 800}, Look::Light,
        [](MainWindow& window) {
            window.maps().setMesh("plane");
            window.findChild<QAbstractButton*>("add-map")->click();
        }},
    {"techniques", {1280, 800}, Look::Dark, [](MainWindow& window) { window.viewport().findChild<CaptionChoice*>("technique")->click(); }},
    {"drag", {1280, 800}, Look::Dark, dragOver},
    {"file-box", {1280, 800}, Look::Dark, [](MainWindow& window) { window.action("open")->trigger(); }},
    {"unsaved", {1280, 800}, Look::Light,
        [](MainWindow& window) {
            window.document().edit("Depth", [](State& state) { state.parameters.depth = 0.2f; });
            window.close();
        }},
    {"two", {1600, 1000}, Look::Dark, twoPanes},
    {"two-light", {1280, 800}, Look::Light,
        [](MainWindow& window) {
            twoPanes(window);
            window.document().edit("Depth", [](State& state) { assign(state, *findParameter("depth"), 0.2f, Scope(1)); });
        }},
    {"heat", {1280, 800}, Look::Dark, [](MainWindow& window) { window.setView("fetches"); }},
    {"heat-two", {1600, 1000}, Look::Dark,
        [](MainWindow& window) {
            twoPanes(window);
            window.setView("error");
        }},
    {"readme", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            window.assets().openDocument("sample:cobblestones", State{});
            workUntil([&] { return !window.assets().background().busy(); });
            window.document().edit("Two techniques", [](State& state) {
                setPaneCount(state, 2);
                state.parameters.depth = 0.1f;
                state.camera.yaw = 40.f, state.camera.pitch = 22.f, state.camera.distance = 0.85f;
            });
        }},
    {"six", {1600, 1000}, Look::Dark, sixPanes},
    {"outlines", {1600, 1000}, Look::Dark, outlines},
    {"outlines-error", {1600, 1000}, Look::Dark,
        [](MainWindow& window) {
            outlines(window);
            window.setView("error-mesh");
        }},
    {"scene", {1280, 800}, Look::Dark,
        [](MainWindow& window) { window.assets().openDocument("scene:interpenetration", window.document().state()); }},
    {"warnings", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            window.messages().set("a",
                Warnings{{"normal-dx", "rock_nor_dx.png is a DirectX style normal map; its green channel was flipped."},
                    {"float-range", "rock_disp.exr leaves 0 to 1; its heights were mapped from -0.23 .. 1.7."}});
            window.document().edit("Maps", [](State& state) {
                state.slots[std::size_t(MapKind::Normal)].file = "/home/anna/rock/rock_nor_dx.png";
                state.slots[std::size_t(MapKind::AmbientOcclusion)].file = "/home/anna/rock/rock_ao.png";
            });
            window.messageLine().setOpen(true);
        }},
    {"export", {1280, 800}, Look::Dark, [](MainWindow& window) { showExport(window, "unity-urp", true); }},
    {"export-light", {1280, 800}, Look::Light, [](MainWindow& window) { showExport(window, "godot4", false); }},
    {"export-format", {1280, 800}, Look::Dark, [](MainWindow& window) { showExport(window, "gltf", false); }},
    {"export-small", {800, 600}, Look::Dark, [](MainWindow& window) { showExport(window, "bevy", false).resize(768, 536); }},
    {"packing", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            showExport(window, "packed", false).findChild<QAbstractButton*>("edit-packing")->click();
            window.findChild<PackingEditor*>()->move(100, 160);
        }},
    {"inspector", {1280, 800}, Look::Dark, [](MainWindow& window) { inspectRay(window, "relief", "cell-cone"); }},
    {"inspector-cones", {1280, 800}, Look::Light, [](MainWindow& window) { inspectRay(window, "cone", "sphere"); }},
    {"inspector-small", {800, 600}, Look::Dark, [](MainWindow& window) { inspectRay(window, "steep", "pyramid"); }},
    {"speed", {1280, 800}, Look::Dark, [](MainWindow& window) { decide(window, window.docks().decide().speed()); }},
    {"speed-light", {1280, 800}, Look::Light, [](MainWindow& window) { decide(window, window.docks().decide().speed()); }},
    {"speed-small", {640, 480}, Look::Dark, [](MainWindow& window) { decide(window, window.docks().decide().speed()); }},
    {"tune", {1280, 800}, Look::Dark, [](MainWindow& window) { decide(window, window.docks().decide().tuning()); }},
    {"tune-light", {1280, 800}, Look::Light, [](MainWindow& window) { decide(window, window.docks().decide().tuning()); }},
    {"tune-small", {640, 480}, Look::Light, [](MainWindow& window) { decide(window, window.docks().decide().tuning()); }},
    {"distance", {1280, 800}, Look::Dark, [](MainWindow& window) { decide(window, window.docks().decide().distance()); }},
    {"distance-light", {1280, 800}, Look::Light, [](MainWindow& window) { decide(window, window.docks().decide().distance()); }},
    {"distance-small", {640, 480}, Look::Dark, [](MainWindow& window) { decide(window, window.docks().decide().distance()); }},
    {"palette", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            window.action("palette")->trigger();
            window.findChild<CommandPalette*>()->findChild<QLineEdit*>()->setText("depth");
        }},
    {"menu", {1280, 800}, Look::Dark,
        [](MainWindow& window) {
            QMenuBar* bar = window.findChild<QMenuBar*>("menu");
            QMenu* file = bar->actions()[0]->menu();
            file->popup(bar->mapToGlobal(QPoint(8, 28)));
            QMenu* view = bar->actions()[2]->menu();
            view->popup(bar->mapToGlobal(QPoint(360, 28)));
        }},
    {"keys", {1280, 800}, Look::Dark, [](MainWindow& window) { window.action("shortcuts")->trigger(); }},
};

void take(const Scene& scene, const QString& folder)
{
    applyLook(*qApp, scene.look);
    QSettings().clear();
    MainWindow window;
    window.move(0, 0);
    window.resize(scene.size);
    window.show();
    window.assets().openDocument(kStartingSource, startingScene());
    workUntil([&] { return window.assets().ready() && !window.assets().background().busy(); });
    scene.prepare(window);
    workUntil([&] { return !window.assets().background().busy() && window.viewport().isSettled(); });
    const QString file = QDir(folder).filePath(QString(scene.name) + ".png");
    QApplication::primaryScreen()->grabWindow(0, 0, 0, scene.size.width(), scene.size.height()).save(file);
    std::printf("%s\n", qPrintable(file));
    window.document().start(window.document().state(), {});
}
} // namespace

int main(int argc, char** argv)
{
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QCoreApplication::setOrganizationName("relievo-pictures");
    QCoreApplication::setApplicationName("pictures");
    QApplication application(argc, argv);
    const QStringList arguments = application.arguments();
    const QString folder = arguments.value(1, ".");
    QDir().mkpath(folder);
    for (const Scene& scene : kScenes)
        if (arguments.size() < 3 || arguments.mid(2).contains(scene.name))
            take(scene, folder);
    return 0;
}
