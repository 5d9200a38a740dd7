// How soon the plot of speed against error is filled, coarse and in full, cold and from kept maps, and whether dragging stays fluid beside
// it. Usage: decide_bench [SOURCE] [WIDTHxHEIGHT]; RELIEVO_CACHE names an empty folder for the cold run.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/decide_dock.h"
#include "app/window/decide/speed_page.h"
#include "app/window/docks.h"
#include "app/window/main_window.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/theme.h"
#include "core/maps/map_cache.h"
#include "tests/bench/window/bench_window.h"
#include <QAction>
#include <algorithm>
#include <cstdio>
#include <vector>

namespace {
using namespace relievo;

void fill(MainWindow& window, const char* name)
{
    const LiveSweep& sweep = window.docks().decide().speed().sweep();
    QElapsedTimer clock;
    clock.start();
    window.action("speed-error")->trigger();
    double coarse = 0.;
    const double longest = workUntil([&] {
        if (coarse == 0. && sweep.points().size() > 80)
            coarse = double(clock.nsecsElapsed()) * 1e-9;
        return !sweep.busy() && !sweep.points().empty();
    });
    std::printf("%s: %zu settings, all coarse after %.1f s, all sharp after %.1f s; longest turn of the event loop %.0f ms\n", name,
        sweep.points().size(), coarse, double(clock.nsecsElapsed()) * 1e-9, longest);
    window.action("speed-error")->trigger();
}

// Frames a second while the view is turned for two seconds.
double drag(MainWindow& window)
{
    Viewport& viewport = window.viewport();
    int shown = 0;
    const auto count = QObject::connect(&viewport, &QOpenGLWidget::frameSwapped, [&] { ++shown; });
    QPointF at(200, 100);
    mouse(viewport, QEvent::MouseButtonPress, at);
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 2000) {
        const int before = shown;
        at += QPointF(clock.elapsed() < 1000 ? 3 : -3, 0);
        mouse(viewport, QEvent::MouseMove, at);
        workUntil([&] { return shown > before; }, 2000);
    }
    const double rate = shown / (double(clock.nsecsElapsed()) * 1e-9);
    mouse(viewport, QEvent::MouseButtonRelease, at);
    QObject::disconnect(count);
    return rate;
}
} // namespace

int main(int argc, char** argv)
{
    prepareWindows();
    QApplication application(argc, argv);
    const QStringList arguments = application.arguments();
    const QStringList size = arguments.value(2, "1280x800").split('x');
    applyLook(application, Look::Dark);
    MainWindow window;
    window.resize(size.value(0).toInt(), size.value(1).toInt());
    window.show();
    window.assets().openDocument(arguments.value(1, "sample:bricks@1024"), State{});
    workUntil([&] { return window.assets().ready() && window.viewport().isSettled(); });
    fill(window, "cold");
    fill(window, "figures kept");
    window.document().edit({}, [](State& state) { state.camera.yaw += 10.f; });
    fill(window, "another view, maps kept in memory");
    forgetMapsInMemory();
    window.document().edit({}, [](State& state) { state.camera.yaw += 10.f; });
    fill(window, "another view, maps from the disk");
    const double alone = drag(window);
    workUntil([&] { return window.viewport().isSettled(); });
    window.document().edit({}, [](State& state) { state.camera.yaw += 10.f; });
    window.action("speed-error")->trigger();
    workUntil([&] { return !window.docks().decide().speed().sweep().points().empty(); });
    std::printf("drag: %.1f frames/s alone, %.1f while the plot fills\n", alone, drag(window));
    return 0;
}
