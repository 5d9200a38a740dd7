// The table of steps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/inspector/step_table.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QHeaderView>
#include <glm/geometric.hpp>

namespace relievo {
namespace {
QTableWidgetItem* cell(const QString& text, bool number = true)
{
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
    return item;
}
} // namespace

double readAt(const RayInspection& ray, const SearchStep& step)
{
    const double way = glm::dot(ray.ray.duv, ray.ray.duv);
    return step.kind == StepKind::Halving && way > 0. ? glm::dot(step.uv - ray.ray.uv, ray.ray.duv) / way : step.to;
}

StepTable::StepTable(QWidget* parent) : QTableWidget(parent)
{
    setObjectName("steps");
    setColumnCount(6);
    setHorizontalHeaderLabels({tr("Step"), tr("From"), tr("To"), tr("Height"), tr("Gap"), tr("Fetches")});
    horizontalHeaderItem(4)->setToolTip(tr("How far the ray is above the relief, share of the depth"));
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setStyleSheet("QHeaderView::section { padding: 3px; }"); // six columns in a narrow dock
    verticalHeader()->setDefaultSectionSize(20);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setFont(smallFont());
    setShowGrid(false);
    setMinimumWidth(310);
    horizontalHeader()->setFont(smallFont());
    verticalHeader()->setFont(smallFont());
    connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
        const auto rows = selectionModel()->selectedRows();
        Q_EMIT chosen(rows.isEmpty() ? -1 : rows.front().row());
    });
}

void StepTable::show(const RayInspection* ray)
{
    const QSignalBlocker blocker(this);
    setRowCount(ray ? int(ray->steps.size()) : 0);
    for (int i = 0; i < rowCount(); ++i) {
        const SearchStep& step = ray->steps[std::size_t(i)];
        const double t = readAt(*ray, step);
        setItem(i, 0, cell(qt(wordOf(step.kind)), false));
        setItem(i, 1, cell(QString::number(step.from, 'f', 4)));
        setItem(i, 2, cell(QString::number(step.to, 'f', 4)));
        setItem(i, 3, cell(QString::number(step.height, 'f', 4)));
        setItem(i, 4, cell(QString::number(1. - t - step.height, 'f', 4)));
        setItem(i, 5, cell(QString::number(step.fetches)));
    }
}

} // namespace relievo
