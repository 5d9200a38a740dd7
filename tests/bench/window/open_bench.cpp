// How soon a texture set is seen in a real window: ms from opening it to the first picture of it, to the whole one and to the full
// resolution. Usage: open_bench SET [WIDTHxHEIGHT]
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/starting_scene.h"
#include "app/window/main_window.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/theme.h"
#include "core/image/files/image_file.h"
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

struct Times {
    double first = 0, whole = 0, full = 0; // ms; 0 while not seen
};

Times open(MainWindow& window, const QString& source)
{
    Times times;
    QElapsedTimer clock;
    const auto note = [&](double& time) {
        if (time == 0)
            time = double(clock.nsecsElapsed()) * 1e-6;
    };
    const std::string before = window.document().state().name;
    const auto seen = QObject::connect(&window.viewport(), &QOpenGLWidget::frameSwapped, [&] {
        const bool isWhole = window.document().state().name != before;
        if (isWhole || window.assets().drawsEarly())
            note(times.first);
        if (isWhole)
            note(times.whole);
        if (isWhole && window.viewport().isFull())
            note(times.full);
    });
    clock.start();
    window.assets().openDocument(source);
    workUntil([&] { return times.full > 0; });
    QObject::disconnect(seen);
    return times;
}
} // namespace

int main(int argc, char** argv)
{
    prepareWindows();
    QApplication application(argc, argv);
    const QStringList arguments = application.arguments(), size = arguments.value(2, "1600x1000").split('x');
    applyLook(application, Look::Dark);
    startImageHelpers();
    MainWindow window;
    window.resize(size.value(0).toInt(), size.value(1).toInt());
    window.show();
    std::vector<double> first, whole, full;
    for (int run = 0; run < 5; ++run) {
        window.assets().openDocument("sample:bricks@16", startingScene());
        const auto shown = [&] { return window.assets().ready() && !window.assets().background().busy() && window.viewport().isFull(); };
        workUntil(shown, 60000);
        if (!shown()) {
            std::fprintf(stderr, "the window shows no picture\n");
            return 1;
        }
        const Times times = open(window, arguments.value(1));
        std::printf("first picture %.0f ms, all maps %.0f ms, full resolution %.0f ms\n", times.first, times.whole, times.full);
        std::fflush(stdout);
        first.push_back(times.first), whole.push_back(times.whole), full.push_back(times.full);
    }
    std::printf("median: first picture %.0f ms, all maps %.0f ms, full resolution %.0f ms\n", median(first), median(whole), median(full));
    return 0;
}
