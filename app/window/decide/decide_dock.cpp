// The pages of the dock.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/decide_dock.h"
#include "app/window/decide/distance_page.h"
#include "app/window/decide/speed_page.h"
#include "app/window/decide/tune_panel.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/theme.h"
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kHeight = 280, kLeastHeight = 200, kNarrowDock = 520; // px
} // namespace

DecideDock::DecideDock(Document& document, Assets& assets, const Viewport& viewport, QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(tr("Speed against error")))
    , m_tabs(new Segmented({{tr("Plot"), tr("What each technique and setting costs and how wrong it is, in this view"), {}},
          {tr("Tune"), tr("The cheapest setting within an error, or the most exact one within a cost"), {}},
          {tr("Distance"), tr("How far away relief and error can still be seen"), {}}}))
    , m_pages(new QStackedWidget)
    , m_speed(new SpeedPage(document, assets, viewport))
    , m_tune(new TunePanel(document, assets, viewport))
    , m_distance(new DistancePage(document, assets, viewport))
{
    setObjectName("decide");
    setRole(*m_title, "heading");
    m_tabs->setObjectName("pages");
    m_tabs->setCurrent(0);
    for (QWidget* page : {static_cast<QWidget*>(m_speed), static_cast<QWidget*>(m_tune), static_cast<QWidget*>(m_distance)}) // as the tabs
        m_pages->addWidget(page);
    connect(m_tabs, &Segmented::chosen, m_pages, &QStackedWidget::setCurrentIndex);
    auto* close = new QToolButton;
    close->setObjectName("close");
    close->setIcon(icon("clear"));
    close->setToolTip(tr("Closes this"));
    connect(close, &QToolButton::clicked, this, &DecideDock::closed);
    auto* head = new QHBoxLayout;
    head->setSpacing(2 * kGrid);
    head->addWidget(m_title);
    head->addWidget(m_tabs);
    head->addStretch(1);
    head->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(3 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    layout->setSpacing(kGrid);
    layout->addWidget(hairline());
    layout->addLayout(head);
    layout->addWidget(m_pages, 1);
    setMinimumHeight(kLeastHeight);
    setMaximumHeight(kHeight);
}

QSize DecideDock::sizeHint() const
{
    return {QWidget::sizeHint().width(), kHeight};
}

void DecideDock::showPage(QWidget& page)
{
    m_pages->setCurrentWidget(&page);
    m_tabs->setCurrent(m_pages->currentIndex());
}

void DecideDock::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_title->setVisible(width() >= kNarrowDock);
}

} // namespace relievo
