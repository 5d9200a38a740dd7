// The ray inspector: click into the picture, and see how each technique searched there, and why it is right or wrong.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "app/window/document/background.h"
#include "app/window/inspector/inspection_job.h"
#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace relievo {

class RayPlot;
class Segmented;
class StepTable;

// Costs nothing while it is hidden. Follows the document: the point stays where it is in the picture.
class RayInspector : public QWidget {
    Q_OBJECT
public:
    RayInspector(Document& document, Assets& assets, QWidget* parent = nullptr);
    void pick(const PickedPoint& point);
    const std::optional<PickedPoint>& picked() const { return m_point; }
    const Inspected& inspected() const { return m_inspected; }
    bool busy() const { return m_background.busy() || m_again.isActive(); }

Q_SIGNALS:
    void closed();
    void pointChanged(); // picked, shown or hidden

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    void compute();
    void take(const Inspected& inspected);
    void refresh(); // plot, table and sentence, of what is chosen
    const RayInspection* shown(std::size_t pane) const; // of the ray that is chosen; null when it has none
    void copySvg();
    void copyCsv();

    Document& m_document;
    Assets& m_assets;
    Background m_background;
    std::optional<PickedPoint> m_point;
    Inspected m_inspected;
    Segmented *m_panes, *m_which;
    QLabel *m_verdict, *m_note;
    RayPlot* m_plot;
    StepTable* m_table;
    QToolButton* m_copy;
    QTimer m_again;
    bool m_isNarrow = false;
};

} // namespace relievo
