// The table of the editor's actions: menus, tool buttons, shortcuts and `describe actions` are made from it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace relievo {

struct ActionRow {
    std::string_view key; // names the handler
    std::string_view menu; // title of the menu that it stands in
    std::string_view label; // as the menu shows it; "..." when more is asked
    std::string_view shortcut; // portable text of a key sequence, "" for none
    std::string_view icon; // file under resources/icons without suffix, "" for none
    bool toggles; // keeps an on/off state
    bool startsGroup; // a line is drawn above it
    std::string_view help; // one sentence: the tooltip
};

// Menus that hold rows of other tables are filled in after the row that names them: recent files after "open-folder", samples
// after them, techniques and views at the top of "View".
inline constexpr auto kActions = std::to_array<ActionRow>({
    {"new", "File", "New", "Ctrl+N", "new", false, false, "Starts afresh with the built-in bricks."},
    {"open", "File", "Open...", "Ctrl+O", "open", false, false, "Opens a project, or one image of a texture set with its siblings."},
    {"open-folder", "File", "Open folder...", "Ctrl+Shift+O", "folder", false, false, "Opens the texture set that lies in a folder."},
    {"save", "File", "Save", "Ctrl+S", "save", false, true, "Saves the project."},
    {"save-as", "File", "Save as...", "Ctrl+Shift+S", "", false, false, "Saves the project under another name."},
    {"export", "File", "Export...", "Ctrl+E", "export", false, true, "Writes the material for another program."},
    {"quit", "File", "Quit", "Ctrl+Q", "", false, true, "Closes the editor; unsaved work is asked about."},

    {"undo", "Edit", "Undo", "Ctrl+Z", "undo", false, false, "Takes the last change back. Camera moves are not changes."},
    {"redo", "Edit", "Redo", "Ctrl+Shift+Z", "redo", false, false, "Does again what was undone."},
    {"copy-picture", "Edit", "Copy picture", "Ctrl+C", "picture", false, true, "Puts the picture as it is shown on the clipboard."},
    {"copy-camera", "Edit", "Copy camera", "Ctrl+Shift+C", "camera", false, false,
        "Puts the camera on the clipboard as text for --camera."},
    {"paste-camera", "Edit", "Paste camera", "Ctrl+Shift+V", "paste", false, false, "Takes the camera from text on the clipboard."},

    {"wireframe", "View", "Wireframe", "Z", "wireframe", true, true, "Draws the edges of the triangles over the picture."},
    {"two-panes", "View", "Compare two techniques", "C", "two-panes", true, false,
        "Two linked pictures side by side, each with its own technique."},
    {"frame", "View", "Frame all", "F", "frame", false, true, "Brings the whole mesh into view from the same side."},
    {"reset-camera", "View", "Reset camera", "Home", "home", false, false, "Brings the camera back to where it began."},
    {"light-theme", "View", "Light theme", "", "theme", true, true, "Bright surroundings instead of dark ones."},
    {"panels", "View", "Panels", "F9", "panels", true, false, "Shows or hides the panels beside the picture."},

    {"shortcuts", "Help", "Mouse and keys", "F1", "keyboard", false, false, "Lists what the mouse and the keys do."},
    {"about", "Help", "About Relievo", "", "info", false, false, "Version and licence."},
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
        for (std::size_t j = 0; j < i; ++j)
            if (kActions[j].key == kActions[i].key || (!kActions[i].shortcut.empty() && kActions[j].shortcut == kActions[i].shortcut))
                return false;
        if (kActions[i].key.empty() || kActions[i].menu.empty() || kActions[i].label.empty() || kActions[i].help.empty())
            return false;
    }
    return true;
}
static_assert(actionsAreSound(), "a key or shortcut twice, or a row without menu, label or help");

} // namespace relievo
