// Finding where the choice of a colour begins and ends.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/color_dialog.h"
#include <QEvent>
#include <QSignalBlocker>
#include <utility>

namespace relievo {

ColorDialog::ColorDialog(const QColor& color, QWidget* parent) : QColorDialog(color, parent)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
    installEventFilter(this);
    for (QWidget* part : findChildren<QWidget*>())
        part->installEventFilter(this);
    connect(this, &QColorDialog::currentColorChanged, this, &ColorDialog::choose);
    connect(this, &QDialog::finished, this, &ColorDialog::end);
}

void ColorDialog::show(const QColor& color)
{
    if (m_choosing || color.rgb() == currentColor().rgb())
        return;
    const QSignalBlocker silent(this);
    setCurrentColor(color);
}

void ColorDialog::choose(const QColor& color)
{
    if (!std::exchange(m_choosing, true))
        Q_EMIT pressed();
    Q_EMIT chosen(color);
}

void ColorDialog::end()
{
    if (std::exchange(m_choosing, false))
        Q_EMIT released();
}

bool ColorDialog::eventFilter(QObject* watched, QEvent* event)
{
    const bool handled = QColorDialog::eventFilter(watched, event);
    const QEvent::Type type = event->type();
    if (type == QEvent::FocusOut || type == QEvent::WindowDeactivate || type == QEvent::Hide)
        end();
    else if (type == QEvent::MouseButtonRelease) // when the part has heard of it too
        QMetaObject::invokeMethod(this, &ColorDialog::end, Qt::QueuedConnection);
    return handled;
}

} // namespace relievo
