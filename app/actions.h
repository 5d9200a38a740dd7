// The table of the editor's actions: menus, tool buttons, shortcuts and `describe actions` are made from it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace relievo {

// What a row is about, in the order of the table: MainWindow::run has a case for each, which the compiler checks.
enum class Action {
    New,
    Open,
    OpenFolder,
    Save,
    SaveAs,
    Reload,
    Export,
    ExportAgain,
    Quit,
    Undo,
    Redo,
    CopyPicture,
    CopyCamera,
    PasteCamera,
    Wireframe,
    TwoPanes,
    Frame,
    ResetCamera,
    Smoother,
    LightTheme,
    Panels,
    RayInspector,
    Palette,
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

// Menus that hold rows of other tables are filled in after the row that names them: recent files after "open-folder", samples
// after them, techniques and views at the top of "View".
inline constexpr auto kActions = std::to_array<ActionRow>({
    {.action = Action::New,
        .key = "new",
        .menu = "File",
        .label = "New",
        .shortcut = "Ctrl+N",
        .icon = "new",
        .help = "Starts afresh with a built-in material on a sphere."},
    {.action = Action::Open,
        .key = "open",
        .menu = "File",
        .label = "Open...",
        .shortcut = "Ctrl+O",
        .icon = "open",
        .help = "Opens a project, or one image of a texture set with its siblings."},
    {.action = Action::OpenFolder,
        .key = "open-folder",
        .menu = "File",
        .label = "Open folder...",
        .shortcut = "Ctrl+Shift+O",
        .icon = "folder",
        .help = "Opens the texture set that lies in a folder."},
    {.action = Action::Save,
        .key = "save",
        .menu = "File",
        .label = "Save",
        .shortcut = "Ctrl+S",
        .icon = "save",
        .startsGroup = true,
        .help = "Saves the project."},
    {.action = Action::SaveAs,
        .key = "save-as",
        .menu = "File",
        .label = "Save as...",
        .shortcut = "Ctrl+Shift+S",
        .help = "Saves the project under another name."},
    {.action = Action::Reload,
        .key = "reload",
        .menu = "File",
        .label = "Reload",
        .shortcut = "F5",
        .help = "Reads all maps, the mesh and the panorama from their files again; what was edited stays."},
    {.action = Action::Export,
        .key = "export",
        .menu = "File",
        .label = "Export...",
        .shortcut = "Ctrl+E",
        .icon = "export",
        .startsGroup = true,
        .help = "Writes the material for another program."},
    {.action = Action::ExportAgain,
        .key = "export-again",
        .menu = "File",
        .label = "Export again",
        .shortcut = "Ctrl+Shift+E",
        .help = "Writes the material as the last time, without asking."},
    {.action = Action::Quit,
        .key = "quit",
        .menu = "File",
        .label = "Quit",
        .shortcut = "Ctrl+Q",
        .startsGroup = true,
        .help = "Closes the editor; unsaved work is asked about."},

    {.action = Action::Undo,
        .key = "undo",
        .menu = "Edit",
        .label = "Undo",
        .shortcut = "Ctrl+Z",
        .icon = "undo",
        .help = "Takes the last change back. Camera moves are not changes."},
    {.action = Action::Redo,
        .key = "redo",
        .menu = "Edit",
        .label = "Redo",
        .shortcut = "Ctrl+Shift+Z",
        .icon = "redo",
        .help = "Does again what was undone."},
    {.action = Action::CopyPicture,
        .key = "copy-picture",
        .menu = "Edit",
        .label = "Copy picture",
        .shortcut = "Ctrl+C",
        .icon = "picture",
        .startsGroup = true,
        .help = "Puts the picture as it is shown on the clipboard."},
    {.action = Action::CopyCamera,
        .key = "copy-camera",
        .menu = "Edit",
        .label = "Copy camera",
        .shortcut = "Ctrl+Shift+C",
        .icon = "camera",
        .help = "Puts the camera on the clipboard as text."},
    {.action = Action::PasteCamera,
        .key = "paste-camera",
        .menu = "Edit",
        .label = "Paste camera",
        .shortcut = "Ctrl+Shift+V",
        .icon = "paste",
        .help = "Takes the camera from text on the clipboard."},

    {.action = Action::Wireframe,
        .key = "wireframe",
        .menu = "View",
        .label = "Wireframe",
        .shortcut = "Z",
        .icon = "wireframe",
        .toggles = true,
        .startsGroup = true,
        .help = "Draws the edges of the triangles over the picture."},
    {.action = Action::TwoPanes,
        .key = "two-panes",
        .menu = "View",
        .label = "Compare two techniques",
        .shortcut = "C",
        .icon = "two-panes",
        .toggles = true,
        .help = "Two linked pictures side by side, each with its own technique."},
    {.action = Action::Frame,
        .key = "frame",
        .menu = "View",
        .label = "Frame all",
        .shortcut = "F",
        .icon = "frame",
        .startsGroup = true,
        .help = "Brings the whole mesh into view from the same side."},
    {.action = Action::ResetCamera,
        .key = "reset-camera",
        .menu = "View",
        .label = "Reset camera",
        .shortcut = "Home",
        .icon = "home",
        .help = "Brings the camera back to where it began."},
    {.action = Action::Smoother,
        .key = "smoother",
        .menu = "View",
        .label = "Smoother at rest",
        .toggles = true,
        .startsGroup = true,
        .help = "Averages 256 pictures instead of 64 while the hand rests: smoother edges and penumbras, for longer work."},
    {.action = Action::LightTheme,
        .key = "light-theme",
        .menu = "View",
        .label = "Light theme",
        .icon = "theme",
        .toggles = true,
        .help = "Bright surroundings instead of dark ones."},
    {.action = Action::Panels,
        .key = "panels",
        .menu = "View",
        .label = "Panels",
        .shortcut = "F9",
        .icon = "panels",
        .toggles = true,
        .help = "Shows or hides the panels beside the picture."},
    {.action = Action::RayInspector,
        .key = "ray-inspector",
        .menu = "View",
        .label = "Ray inspector",
        .shortcut = "I",
        .icon = "ray",
        .toggles = true,
        .help = "Shows how each technique searches along the ray of the point that is clicked, and why it is right or wrong."},
    {.action = Action::Palette,
        .key = "palette",
        .menu = "Help",
        .label = "Commands...",
        .shortcut = "Ctrl+Shift+P",
        .help = "Finds actions, techniques, views, presets and values by a few letters; \"depth 0.1\" sets one."},
    {.action = Action::Shortcuts,
        .key = "shortcuts",
        .menu = "Help",
        .label = "Mouse and keys",
        .shortcut = "F1",
        .icon = "keyboard",
        .help = "Lists what the mouse and the keys do."},
    {.action = Action::About, .key = "about", .menu = "Help", .label = "About Relievo", .icon = "info", .help = "Version and licence."},
});

constexpr const ActionRow* findAction(std::string_view key) // nullptr when unknown
{
    for (const ActionRow& row : kActions)
        if (row.key == key)
            return &row;
    return nullptr;
}

consteval bool actionsAreSound()
{
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        if (kActions[i].action != Action(i))
            return false;
        for (std::size_t j = 0; j < i; ++j)
            if (kActions[j].key == kActions[i].key || (!kActions[i].shortcut.empty() && kActions[j].shortcut == kActions[i].shortcut))
                return false;
        if (kActions[i].key.empty() || kActions[i].menu.empty() || kActions[i].label.empty() || kActions[i].help.empty())
            return false;
    }
    return true;
}
static_assert(actionsAreSound(), "a row out of order, a key or shortcut twice, or a row without menu, label or help");
static_assert(kActions.size() == std::size_t(Action::About) + 1, "an action without row");

} // namespace relievo
