// The look of plots.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/custom_plot.h"
#include "app/window/widgets/theme.h"

namespace relievo {

void applyLook(QCustomPlot& plot, const QPalette& colors)
{
    plot.setBackground(field(colors));
    QColor behind = field(colors);
    behind.setAlpha(190);
    plot.legend->setBrush(behind);
    plot.legend->setBorderPen(QPen(lineColor(colors)));
    plot.legend->setTextColor(colors.color(QPalette::Text));
    plot.legend->setFont(smallFont());
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setLabelFont(smallFont());
        axis->setTickLabelFont(smallFont());
        axis->setBasePen(QPen(lineColor(colors)));
        axis->setTickPen(QPen(lineColor(colors)));
        axis->setSubTickPen(QPen(lineColor(colors)));
        axis->setTickLabelColor(dimText(colors));
        axis->setLabelColor(dimText(colors));
        axis->grid()->setPen(QPen(lineColor(colors), 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
}

} // namespace relievo
