// The look of the program: two palettes of neutral greys with one accent colour, one font in two sizes, one style sheet.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <string_view>

class QApplication;
class QWidget;

namespace relievo {

enum class Look { Dark, Light };

// Sets palette, font and style sheet of the whole program; may be called again to change it.
void applyLook(QApplication& application, Look look);
Look savedLook(); // of the user's settings, dark at first
void chooseLook(Look look); // applies and keeps it

// A grid of 4 px.
inline constexpr int kGrid = 4;
inline constexpr int kRowHeight = 24; // px, of a control
inline constexpr int kFontSize = 12, kSmallFontSize = 11; // px

QFont smallFont();

// What a label is for, as the style sheet colours it: "" plain, "dim", "heading", "own", "warning".
void setRole(QWidget& widget, const char* role);

// Colours by purpose; palettes carry them in these roles, so that widgets follow a change of look by themselves.
inline QColor dimText(const QPalette& palette)
{
    return palette.color(QPalette::PlaceholderText);
}
inline QColor lineColor(const QPalette& palette)
{
    return palette.color(QPalette::Mid);
} // borders
inline QColor field(const QPalette& palette)
{
    return palette.color(QPalette::Base);
} // what can be typed or dropped into
inline QColor raised(const QPalette& palette)
{
    return palette.color(QPalette::Button);
} // what can be pressed
inline QColor hovered(const QPalette& palette)
{
    return palette.color(QPalette::Midlight);
}
inline QColor accent(const QPalette& palette)
{
    return palette.color(QPalette::Highlight);
}
inline QColor onAccent(const QPalette& palette)
{
    return palette.color(QPalette::HighlightedText);
}
inline QColor warningColor(const QPalette& palette)
{
    return palette.color(QPalette::BrightText);
}

// An icon of resources/icons in the text colour of the palette, sharp at any scale; dimmed when disabled.
QIcon icon(std::string_view name);

} // namespace relievo
