// Dividing the main window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/page.h"
#include "app/window/widgets/hairline.h"
#include <QSettings>
#include <QSplitter>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kMapWidth = 264, kParameterWidth = 348; // px

QVBoxLayout* column(QWidget* widget)
{
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    return layout;
}
} // namespace

Page::Page(const Parts& parts, QWidget* parent) : QWidget(parent), m_parts(parts), m_splitter(new QSplitter)
{
    m_splitter->setHandleWidth(1);
    m_splitter->setChildrenCollapsible(false);
    auto* centre = new QWidget;
    auto* middle = column(centre);
    middle->addWidget(parts.picture, 1);
    middle->addWidget(parts.underPicture);
    for (QWidget* part : {parts.maps, centre, parts.parameters})
        m_splitter->addWidget(part);
    parts.maps->setMinimumWidth(284); // the row of shapes
    parts.parameters->setMinimumWidth(324); // the longest name beside a short slider
    m_splitter->setStretchFactor(1, 1);
    auto* all = column(this);
    all->addWidget(hairline());
    all->addWidget(m_splitter, 1);
    all->addWidget(parts.messages);
}

void Page::showPanels(bool on)
{
    m_panelsShown = on;
    m_parts.maps->setVisible(on);
    m_parts.parameters->setVisible(on);
}

void Page::restore(QWidget& window)
{
    const QSettings settings;
    window.resize(1280, 800);
    window.restoreGeometry(settings.value("window/geometry").toByteArray());
    if (!m_splitter->restoreState(settings.value("window/splitter").toByteArray()))
        m_splitter->setSizes({kMapWidth, window.width() - kMapWidth - kParameterWidth, kParameterWidth});
    showPanels(settings.value("window/panels", true).toBool());
}

void Page::save(const QWidget& window) const
{
    QSettings settings;
    settings.setValue("window/geometry", window.saveGeometry());
    settings.setValue("window/splitter", m_splitter->saveState());
    settings.setValue("window/panels", m_panelsShown);
}

} // namespace relievo
