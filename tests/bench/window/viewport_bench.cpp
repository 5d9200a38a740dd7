// How fluid the picture is in a real window: frames a second while orbiting, and the time from rest to the full picture.
// the longest turn of the event loop at rest and while a cone map of 2048 texels is baked.
// Usage: viewport_bench [WIDTHxHEIGHT] [SHAPE] [TECHNIQUE] [PANES]
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/editing.h"
#include "app/window/document/files.h"
#include "app/window/main_window.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/theme.h"
#include "tests/bench/window/bench_window.h"
#include <algorithm>
#include <cstdio>
#include <vector>

namespace {
using namespace relievo;

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct Drag {
    double framesPerSecond, slowest, scale, toFull;
};

// A drag of `frames` shown pictures, then the wait for the full one.
Drag drag(MainWindow& window, int frames)
{
    Viewport& viewport = window.viewport();
    int shown = 0;
    const auto count = QObject::connect(&viewport, &QOpenGLWidget::frameSwapped, [&] { ++shown; });
    QPointF at(200, 300);
    mouse(viewport, QEvent::MouseButtonPress, at);
    std::vector<double> times;
    QElapsedTimer clock;
    for (int i = 0; i < frames; ++i) {
        clock.start();
        const int before = shown;
        at += QPointF(i < frames / 2 ? 3 : -3, i % 2);
        mouse(viewport, QEvent::MouseMove, at);
        workUntil([&] { return shown > before; });
        times.push_back(double(clock.nsecsElapsed()) * 1e-6);
    }
    const double scale = viewport.shownScale();
    clock.start();
    double full = 0;
    const auto rest = QObject::connect(&viewport, &QOpenGLWidget::frameSwapped, [&] {
        if (viewport.isFull() && full == 0)
            full = double(clock.nsecsElapsed()) * 1e-6;
    });
    workUntil([&] { return full > 0; });
    QObject::disconnect(rest);
    mouse(viewport, QEvent::MouseButtonRelease, at);
    QObject::disconnect(count);
    times.erase(times.begin(), times.begin() + 5); // the pacer finds its scale
    return {1000. / median(times), *std::max_element(times.begin(), times.end()), scale, full};
}
} // namespace

int main(int argc, char** argv)
{
    prepareWindows();
    QApplication application(argc, argv);
    const QStringList arguments = application.arguments();
    const QStringList size = arguments.value(1, "1280x800").split('x');
    applyLook(application, Look::Dark);
    MainWindow window;
    window.resize(size.value(0).toInt(), size.value(1).toInt());
    window.show();
    State state;
    state.mesh = arguments.value(2, "sphere").toStdString();
    state.panes[0].technique = arguments.value(3, "relief").toStdString();
    setPaneCount(state, std::size_t(std::max(1, arguments.value(4, "1").toInt())));
    window.assets().openDocument("sample:bricks", state);
    const auto settled = [&] { return window.assets().ready() && window.viewport().isSettled(); };
    workUntil(settled, 20000);
    if (!settled()) {
        std::fprintf(stderr, "the window shows no picture\n");
        return 1;
    }
    std::printf("window %dx%d, picture %dx%d, %s on %s\n", window.width(), window.height(), window.viewport().width(),
        window.viewport().height(), state.panes[0].technique.c_str(), state.mesh.c_str());
    for (int run = 0; run < 5; ++run) {
        const Drag result = drag(window, 60);
        std::printf("drag: %.1f frames/s (median), slowest frame %.1f ms, at %.2f of the resolution each way; full picture %.0f ms after "
                    "the last move\n",
            result.framesPerSecond, result.slowest, result.scale, result.toFull);
        workUntil([&] { return window.viewport().isSettled(); });
    }
    window.document().edit("Light", [](State& s) { s.parameters.lightYaw += 20.f; });
    std::printf("at rest: longest turn of the event loop %.0f ms\n", workUntil([&] { return window.viewport().isSettled(); }));
    window.assets().openDocument("sample:bricks@2048", state);
    workUntil([&] { return window.assets().ready() && window.viewport().isSettled(); });
    window.setTechnique("cone-relaxed");
    std::printf("while a cone map of 2048 x 2048 is baked: longest turn %.0f ms\n",
        workUntil([&] { return !window.assets().background().busy() && window.viewport().isSettled(); }));
    return 0;
}
