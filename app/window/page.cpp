// Dividing the main window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/page.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/segmented.h"
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kMapWidth = 284, kParameterWidth = 388; // px
constexpr int kBothFrom = 1040; // px of the page from which on a column stands on each side of the picture
constexpr QSize kFirstSize(1280, 800), kFrame(16, 64); // px; around a window there is its frame and often a bar

QVBoxLayout* column(QWidget* widget)
{
    auto* layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    return layout;
}
} // namespace

Page::Page(const Parts& parts, QWidget* parent)
    : QWidget(parent)
    , m_parts(parts)
    , m_splitter(new QSplitter)
    , m_side(new QWidget)
    , m_tabLine(new QWidget)
    , m_tabs(new Segmented({{tr("Values"), tr("The values of the picture"), {}}, {tr("Scene"), tr("Mesh, maps and environment"), {}}}))
{
    m_splitter->setHandleWidth(1);
    m_splitter->setChildrenCollapsible(false);
    auto* centre = new QWidget;
    auto* middle = column(centre);
    middle->addWidget(parts.picture, 1);
    for (QWidget* part : parts.underPicture)
        middle->addWidget(part);
    auto* beside = column(m_side);
    m_tabs->setObjectName("panel");
    m_tabs->setCurrent(0);
    auto* line = column(m_tabLine);
    line->setContentsMargins(12, 8, 8, 8);
    line->addWidget(m_tabs, 0, Qt::AlignLeft);
    beside->addWidget(m_tabLine);
    beside->addWidget(parts.parameters, 1);
    for (QWidget* part : {parts.maps, centre, m_side})
        m_splitter->addWidget(part);
    parts.maps->setMinimumWidth(kMapWidth); // the row of shapes
    parts.parameters->setMinimumWidth(kParameterWidth);
    m_side->setMinimumWidth(kParameterWidth); // the longest name beside the shortest slider
    connect(m_tabs, &Segmented::chosen, this, [this] { showPanels(m_panelsShown); });
    m_splitter->setStretchFactor(1, 1);
    auto* all = column(this);
    all->addWidget(hairline());
    all->addWidget(m_splitter, 1);
    all->addWidget(parts.messages);
}

void Page::showPanels(bool on)
{
    m_panelsShown = on;
    const bool scene = m_tabs->current() == 1;
    m_tabLine->setVisible(m_isNarrow);
    m_side->setVisible(on);
    m_parts.maps->setVisible(on && (!m_isNarrow || scene));
    m_parts.parameters->setVisible(on && (!m_isNarrow || !scene));
}

// In a narrow window both panels share the column on the right.
void Page::resizeEvent(QResizeEvent*)
{
    const bool narrow = width() < kBothFrom;
    if (narrow == m_isNarrow)
        return;
    m_isNarrow = narrow;
    if (narrow) {
        m_wide = m_splitter->saveState();
        m_side->layout()->addWidget(m_parts.maps);
    } else {
        m_splitter->insertWidget(0, m_parts.maps);
        m_splitter->restoreState(m_wide);
    }
    showPanels(m_panelsShown);
}

QSize Page::minimumSizeHint() const
{
    return {kParameterWidth + m_parts.picture->minimumWidth(), m_parts.picture->minimumHeight()};
}

void Page::restore(QWidget& window)
{
    const QSettings settings;
    window.resize(kFirstSize.boundedTo(window.screen()->availableSize() - kFrame));
    window.restoreGeometry(settings.value("window/geometry").toByteArray());
    if (!m_splitter->restoreState(settings.value("window/splitter").toByteArray()))
        m_splitter->setSizes({kMapWidth, window.width() - kMapWidth - kParameterWidth, kParameterWidth});
    showPanels(settings.value("window/panels", true).toBool());
}

void Page::save(const QWidget& window) const
{
    QSettings settings;
    settings.setValue("window/geometry", window.saveGeometry());
    settings.setValue("window/splitter", m_isNarrow ? m_wide : m_splitter->saveState());
    settings.setValue("window/panels", m_panelsShown);
}

} // namespace relievo
