// The style's icons of file and message boxes, in the program's own drawing.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QProxyStyle>

namespace relievo {

// Fusion, with the icons of resources/icons for what Qt's own dialogs show.
class OwnIcons : public QProxyStyle {
    Q_OBJECT
public:
    OwnIcons();
    QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
    int styleHint(
        StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const override; // no icons on buttons
    QPixmap standardPixmap(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
};

} // namespace relievo
