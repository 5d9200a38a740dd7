// The ray inspector.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/ray_inspector.h"
#include "app/window/inspector/ray_plot.h"
#include "app/window/inspector/step_table.h"
#include "app/window/widgets/hairline.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kHeight = 260; // px, at first
constexpr int kNarrow = 560; // px
constexpr int kDelay = 80; // ms after a change until it is looked at again
} // namespace

RayInspector::RayInspector(Document& document, Assets& assets, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
    , m_panes(new Segmented({}))
    , m_which(new Segmented(
          {{tr("View"), tr("The ray of the eye"), {}}, {tr("Light"), tr("The ray of light to the point that was found"), {}}}))
    , m_verdict(new QLabel)
    , m_note(new QLabel)
    , m_plot(new RayPlot)
    , m_table(new StepTable)
    , m_copy(new QToolButton)
{
    setObjectName("ray-inspector");
    layOut();
    m_again.setSingleShot(true);
    m_again.setInterval(kDelay);
    connect(&m_again, &QTimer::timeout, this, &RayInspector::compute);
    const auto again = [this] {
        if (isVisible() && m_point)
            m_again.start();
    };
    connect(&document, &Document::changed, this, again);
    connect(&assets, &Assets::resourcesChanged, this, again);
    connect(&m_background, &Background::failed, this, [this](const QString& what) { take({{}, {}, what}); });
    connect(m_panes, &Segmented::chosen, this, &RayInspector::refresh);
    connect(m_which, &Segmented::chosen, this, &RayInspector::refresh);
    connect(m_table, &StepTable::chosen, m_plot, &RayPlot::mark);
    refresh();
}

void RayInspector::layOut()
{
    auto* title = new QLabel(tr("Ray inspector"));
    setRole(*title, "heading");
    m_which->setObjectName("which");
    m_which->setCurrent(0);
    m_panes->setObjectName("panes");
    m_verdict->setObjectName("verdict");
    m_verdict->setWordWrap(true);
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_note->setObjectName("note");
    setRole(*m_note, "dim");
    m_copy->setObjectName("copy");
    m_copy->setText(tr("Copy"));
    m_copy->setPopupMode(QToolButton::InstantPopup);
    m_copy->setToolTip(tr("Copies the drawing, or the table of the steps"));
    auto* menu = new QMenu(m_copy);
    menu->addAction(tr("Drawing as SVG"), this, &RayInspector::copySvg);
    menu->addAction(tr("Steps as CSV"), this, &RayInspector::copyCsv);
    m_copy->setMenu(menu);
    auto* close = new QToolButton;
    close->setObjectName("close");
    close->setIcon(icon("clear"));
    close->setToolTip(tr("Closes the ray inspector"));
    connect(close, &QToolButton::clicked, this, &RayInspector::closed);
    auto* head = new QHBoxLayout;
    head->setSpacing(2 * kGrid);
    for (QWidget* widget : {static_cast<QWidget*>(title), static_cast<QWidget*>(m_panes), static_cast<QWidget*>(m_which)})
        head->addWidget(widget);
    head->addWidget(m_note, 1);
    head->addWidget(m_copy);
    head->addWidget(close);
    auto* body = new QSplitter;
    body->addWidget(m_plot);
    body->addWidget(m_table);
    body->setStretchFactor(0, 3);
    body->setStretchFactor(1, 2);
    body->setChildrenCollapsible(false);
    body->setSizes({3000, 2000}); // shares
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(3 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    layout->setSpacing(kGrid);
    layout->addWidget(hairline());
    layout->addLayout(head);
    layout->addWidget(m_verdict);
    layout->addWidget(body, 1);
    setFixedHeight(kHeight);
}

void RayInspector::pick(const PickedPoint& point)
{
    m_point = point;
    Q_EMIT pointChanged();
    if (isVisible())
        compute();
}

// In a narrow window the drawing comes first.
void RayInspector::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (const bool narrow = width() < kNarrow; narrow != m_isNarrow) {
        m_isNarrow = narrow;
        m_table->setVisible(!narrow);
        take(Inspected(m_inspected));
    }
}

void RayInspector::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    Q_EMIT pointChanged();
    if (m_point)
        m_again.start();
}

void RayInspector::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_again.stop();
    m_background.cancel();
    Q_EMIT pointChanged();
}

void RayInspector::compute()
{
    if (!m_point || !m_assets.ready() || m_point->pane >= m_document.state().panes.size())
        return;
    m_background.start([this, state = m_document.state(), resources = m_assets.resources(), point = *m_point](const Progress& progress) {
        return Background::Then([this, inspected = inspect(state, resources, point, progress)] { take(inspected); });
    });
}

void RayInspector::take(const Inspected& inspected)
{
    const int before = m_panes->current();
    const std::size_t count = m_inspected.panes.size();
    m_inspected = inspected;
    QVector<Segmented::Item> items;
    for (const PaneInspection& pane : m_inspected.panes)
        items << Segmented::Item{m_isNarrow ? pane.name.section(' ', 0, 0) : pane.name, pane.name, {}};
    m_panes->setItems(items);
    if (!items.isEmpty())
        m_panes->setCurrent(count == m_inspected.panes.size() && before >= 0 ? before : 0);
    refresh();
}

const RayInspection* RayInspector::shown(std::size_t pane) const
{
    if (pane >= m_inspected.panes.size())
        return nullptr;
    const auto& ray = m_which->current() == 1 ? m_inspected.panes[pane].light : m_inspected.panes[pane].view;
    return ray ? &*ray : nullptr;
}

void RayInspector::refresh()
{
    std::vector<RayPlot::Shown> rays;
    std::size_t chosen = 0;
    const std::size_t current = std::size_t(std::max(m_panes->current(), 0));
    for (std::size_t i = 0; i < m_inspected.panes.size(); ++i)
        if (const RayInspection* ray = shown(i)) {
            if (i == current)
                chosen = rays.size();
            rays.push_back({*ray, m_inspected.panes[i].name});
        }
    const RayInspection* ray = shown(current);
    m_panes->setVisible(m_inspected.panes.size() > 1);
    m_which->setVisible(!m_inspected.panes.empty());
    m_copy->setEnabled(ray != nullptr);
    m_note->setText(m_inspected.panes.empty() ? QString() : m_inspected.note);
    m_verdict->setText(ray               ? qt(ray->verdict)
            : !m_inspected.panes.empty() ? tr("No light comes to this point through the relief.")
            : m_point                    ? (m_inspected.note.isEmpty() ? tr("Looking ...") : m_inspected.note)
                      : tr("Click into the picture to see how each technique searches there, and why it is right or wrong."));
    m_plot->show(ray ? rays : std::vector<RayPlot::Shown>(), m_inspected.field ? &*m_inspected.field : nullptr, chosen);
    m_table->show(ray);
}

void RayInspector::copySvg()
{
    const QByteArray svg = m_plot->svg();
    auto* copied = new QMimeData;
    copied->setData("image/svg+xml", svg);
    copied->setText(QString::fromUtf8(svg));
    QApplication::clipboard()->setMimeData(copied);
}

void RayInspector::copyCsv()
{
    if (const RayInspection* ray = shown(std::size_t(std::max(m_panes->current(), 0))))
        QApplication::clipboard()->setText(qt(inspectionCsv(*ray)));
}

} // namespace relievo
