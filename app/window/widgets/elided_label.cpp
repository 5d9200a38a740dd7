// Cutting text where there is no room for it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/elided_label.h"

namespace relievo {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setFullText(const QString& text)
{
    if (toolTip() == m_full)
        setToolTip({});
    m_full = text;
    elide();
}

// A tooltip of another text stays.
void ElidedLabel::elide()
{
    setText(fontMetrics().elidedText(m_full, Qt::ElideRight, width()));
    if (toolTip().isEmpty() || toolTip() == m_full)
        setToolTip(text() == m_full ? QString() : m_full);
}

void ElidedLabel::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    elide();
}

} // namespace relievo
