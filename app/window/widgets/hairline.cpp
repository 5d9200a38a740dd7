// Frames that the style sheet draws as lines.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/hairline.h"

namespace relievo {
namespace {
QFrame* ruled(QWidget* parent, const char* role)
{
    auto* frame = new QFrame(parent);
    frame->setProperty("role", role);
    return frame;
}
} // namespace

QFrame* hairline(QWidget* parent)
{
    return ruled(parent, "line");
}

QFrame* upright(QWidget* parent)
{
    return ruled(parent, "upright");
}

} // namespace relievo
