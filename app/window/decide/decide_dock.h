// The dock that helps to decide: speed against error of this view, the cheapest setting within an error, cost against distance.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

class QLabel;
class QStackedWidget;

namespace relievo {

class Assets;
class DistancePage;
class Document;
class Segmented;
class SpeedPage;
class TunePanel;
class Viewport;

class DecideDock : public QWidget {
    Q_OBJECT
public:
    DecideDock(Document& document, Assets& assets, const Viewport& viewport, QWidget* parent = nullptr);
    SpeedPage& speed() { return *m_speed; }
    TunePanel& tuning() { return *m_tune; }
    DistancePage& distance() { return *m_distance; }
    void showPage(QWidget& page); // one of these
    QSize sizeHint() const override;
    bool hasHeightForWidth() const override { return false; } // a page that wraps its lines is no reason for another height

Q_SIGNALS:
    void closed();

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    QLabel* m_title;
    Segmented* m_tabs;
    QStackedWidget* m_pages;
    SpeedPage* m_speed;
    TunePanel* m_tune;
    DistancePage* m_distance;
};

} // namespace relievo
