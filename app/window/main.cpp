// The editor: `relievo-editor [SOURCE] [--state-json FILE]`. Users start it as `relievo`, which passes the state in a file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/handed_over.h"
#include "app/window/document/files.h"
#include "app/window/document/load_jobs.h"
#include "app/window/document/recovery.h"
#include "app/window/document/starting_scene.h"
#include "app/window/main_window.h"
#include "app/window/widgets/theme.h"
#include "core/image/files/image_file.h"
#include "core/state/state_json.h"
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <cstdio>

namespace {
using namespace relievo;

// `relievo` leaves the state in a file of a folder of its own, which are done with when it has been read.
void removeIfOurs(const QString& file)
{
    const QFileInfo info(file), folder(info.absolutePath());
    const QString start = QString(kHandedOverFolder).remove('X');
    if (info.fileName() != kHandedOverFile || !folder.fileName().startsWith(start) || folder.dir() != QDir::temp())
        return;
    QFile::remove(file);
    QDir::temp().rmdir(folder.fileName());
}

// Without any OpenGL the picture could not even be set up. That it is too old is said in the window.
bool hasOpenGL()
{
    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.create();
    if (context.create() && context.makeCurrent(&surface))
        return true;
    std::fputs(
        "relievo: error: no OpenGL was found on this display, and version 4.1 is needed. Install or update the graphics driver.\n", stderr);
    return false;
}

// Without a SOURCE the maps of the state are shown, and without those a built-in material. What is no whole document, and comes with no
// state, is shown on the starting scene.
void open(MainWindow& window, const QString& source, const std::optional<StateRead>& given)
{
    const bool hasMaps = given && given->state.slots != MapSlots{};
    if (source.isEmpty() && hasMaps)
        return window.assets().openState(given->state, given->warnings);
    const QString opened = source.isEmpty() ? kStartingSource : source;
    const State base = given ? given->state : isWholeDocument(opened) ? State{} : startingScene();
    const auto start = [&window, base](const QString& chosen) { window.assets().openDocument(chosen, base); };
    window.files().chooseSet(opened, start);
    if (!window.assets().background().busy()) // a set is being chosen
        start(kStartingSource);
}
} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setOrganizationName("relievo");
    QCoreApplication::setApplicationName("Relievo");
    QCoreApplication::setApplicationVersion(RELIEVO_VERSION);
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);

    QCommandLineParser parser;
    parser.setApplicationDescription("Relievo, an editor for relief materials.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("SOURCE", "A project, a folder with a texture set, an image, or sample:KEY.", "[SOURCE]");
    parser.addOption({"state-json", "The state to begin with; it counts as new and untitled.", "FILE"});
    parser.process(application);
    const QStringList sources = parser.positionalArguments();
    std::optional<StateRead> given;
    if (parser.isSet("state-json")) {
        auto read = readState(State{}, parser.value("state-json").toStdString());
        if (!read) {
            std::fprintf(stderr, "relievo: error: %s\n", message(read.error()).c_str());
            return 1;
        }
        given = std::move(*read);
        removeIfOurs(parser.value("state-json"));
    }
    if (sources.size() > 1) {
        std::fprintf(stderr, "relievo: error: %s: only one SOURCE can be opened. Drop the others.\n", sources[1].toUtf8().constData());
        return 2;
    }

    startImageHelpers(); // ready when the window is
    if (!hasOpenGL())
        return 1;
    applyLook(application, savedLook());
    MainWindow window;
    window.show();
    open(window, sources.value(0), given);
    const Recovery recovery(window.document());
    offerLeftBehind(window);
    return QApplication::exec();
}
