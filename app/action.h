// One action of the editor: what a row of the table of actions says.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace relievo {

// What a row is about, in the order of the table: runAction has a case for each, which the compiler checks.
enum class Action {
    New,
    Open,
    OpenFolder,
    Save,
    SaveAs,
    Reload,
    Export,
    ExportAgain,
    ContactSheet,
    Report,
    Impostor,
    Quit,
    Undo,
    Redo,
    CopyPicture,
    CopyCamera,
    PasteCamera,
    Wireframe,
    TwoPanes,
    Wipe,
    Blink,
    Difference,
    Flip,
    SwapPanes,
    Loupe,
    Frame,
    ResetCamera,
    TurnLights,
    Turntable,
    Smoother,
    LightTheme,
    Panels,
    RayInspector,
    WorstPoint,
    SpeedAndError,
    Palette,
    Manual,
    Shortcuts,
    About,
};

struct ActionRow {
    Action action;
    std::string_view key; // in tests and `describe actions`
    std::string_view menu; // title of the menu that it stands in
    std::string_view label; // as the menu shows it; "..." when more is asked
    std::string_view shortcut = {}; // portable text of a key sequence, "" for none
    std::string_view icon = {}; // file under resources/icons without suffix, "" for none
    bool toggles = false; // keeps an on/off state
    bool startsGroup = false; // a line is drawn above it
    std::string_view help; // one sentence: the tooltip
};

} // namespace relievo
