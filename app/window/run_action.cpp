// From actions to the parts of the window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/run_action.h"
#include "app/window/clipboard.h"
#include "app/window/compare/compare_bar.h"
#include "app/window/compare/loupe.h"
#include "app/window/decide/measuring_run.h"
#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/manual.h"
#include "app/window/docks.h"
#include "app/window/document/files.h"
#include "app/window/inspector/ray_inspector.h"
#include "app/window/lights/turning.h"
#include "app/window/main_window.h"
#include "app/window/objects/impostor_dialog.h"
#include "app/window/palette/command_palette.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QAction>
#include <QUndoStack>

namespace relievo {
namespace {
std::size_t activePane(MainWindow& window)
{
    return std::size_t(window.viewport().activePane());
}

// Of the active pane, or the one that it shares.
void moveCamera(MainWindow& window, const Camera& camera)
{
    window.document().edit({}, [&](State& state) { setCameraOf(state, activePane(window), camera); });
}

void setWireframe(Document& document, bool on)
{
    const ParameterRow& row = *findParameter("wireframe");
    document.edit(qt(row.label), [&](State& state) { assign(state, row, on, kAllPanes); });
}

void runFile(MainWindow& window, Action action)
{
    Files& files = window.files();
    switch (action) {
    case Action::New:
        return files.startNew();
    case Action::Open:
        return files.ask();
    case Action::OpenFolder:
        return files.askFolder();
    case Action::Save:
        return files.save();
    case Action::Export:
        return window.exportDialog().present();
    case Action::ExportAgain:
        return window.exportDialog().runAgain();
    case Action::ContactSheet:
    case Action::Report:
        return measuringOf(window).ask(action);
    case Action::Impostor:
        return askForImpostor(window);
    case Action::Reload:
        return window.assets().readAgain();
    default:
        return files.saveAs();
    }
}
void runEdit(MainWindow& window, Action action)
{
    if (action == Action::Undo)
        window.document().undoStack().undo();
    else if (action == Action::Redo)
        window.document().undoStack().redo();
    else if (action == Action::CopyPicture)
        copyPicture(window.viewport(), window.messages());
    else if (action == Action::CopyCamera)
        copyCamera(window.document(), activePane(window));
    else
        pasteCamera(window.document(), activePane(window), window.messages());
}

// In a pane that is not shown, and where nothing is wrong, there is nothing to inspect.
void inspectWorst(MainWindow& window)
{
    const std::size_t pane = activePane(window);
    const PaneArea area = window.viewport().places().areas()[pane];
    const auto worst = area.isEmpty() ? std::nullopt : window.viewport().worstPoint(pane);
    if (!worst)
        return window.messages().set("worst", QList<Message>{{.text = QObject::tr("No point of this picture is wrong."), .isNote = true}});
    window.messages().clear("worst");
    if (QAction* inspector = window.action("ray-inspector"); !inspector->isChecked())
        inspector->trigger();
    window.docks().inspector().pick({pane, *worst, area.aspect()});
}

} // namespace

void setFieldOfView(MainWindow& window, float fieldOfView)
{
    moveCamera(window, withFieldOfView(cameraOf(window.document().state(), activePane(window)), fieldOfView));
}

QString fieldOfViewText(float fieldOfView)
{
    return QObject::tr("%1\u00b0 (%2 mm)").arg(double(fieldOfView)).arg(focalLength(fieldOfView), 0, 'f', 0);
}

// A case for each row of kActions: one that is missing does not compile.
void runAction(MainWindow& window, Action action, bool on)
{
    switch (action) {
    case Action::New:
    case Action::Open:
    case Action::OpenFolder:
    case Action::Save:
    case Action::SaveAs:
    case Action::Export:
    case Action::ExportAgain:
    case Action::ContactSheet:
    case Action::Report:
    case Action::Impostor:
    case Action::Reload:
        return runFile(window, action);
    case Action::Quit:
        return void(window.close());
    case Action::Undo:
    case Action::Redo:
    case Action::CopyPicture:
    case Action::CopyCamera:
    case Action::PasteCamera:
        return runEdit(window, action);
    case Action::Wireframe:
        return setWireframe(window.document(), on);
    case Action::TwoPanes:
        return window.comparing().showPanes(on);
    case Action::Wipe:
    case Action::Blink:
    case Action::Difference:
    case Action::Flip:
        return window.comparing().compare(inPlaceModeOf(action), on);
    case Action::SwapPanes:
        return window.comparing().swap();
    case Action::Loupe:
        return window.loupe().setOn(on);
    case Action::Frame:
    case Action::ResetCamera:
        return moveCamera(window, framed(action == Action::Frame ? cameraOf(window.document().state(), activePane(window)) : Camera{}));
    case Action::TurnLights:
    case Action::Turntable:
        return action == Action::TurnLights ? window.turning().turnLights(on) : window.turning().turnCamera(on);
    case Action::Smoother:
        return window.viewport().wantSamples(on ? SamplesAtRest::kMost : SamplesAtRest::kUsual);
    case Action::LightTheme:
        return chooseLook(on ? Look::Light : Look::Dark);
    case Action::Panels:
        return window.showPanels(on);
    case Action::RayInspector:
    case Action::SpeedAndError:
        return window.docks().show(action, on);
    case Action::WorstPoint:
        return inspectWorst(window);
    case Action::Palette:
        return showPalette(window);
    case Action::Manual:
        return showManual(&window);
    case Action::Shortcuts:
        return showShortcuts(&window);
    case Action::About:
        return showAbout(&window);
    }
}

} // namespace relievo
