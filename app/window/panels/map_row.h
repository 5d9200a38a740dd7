// The line of the map panel that shows one map slot: thumbnail, facts, and what can be done with it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/material.h"
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace relievo {

class ElidedLabel;

class MapRow : public QWidget {
    Q_OBJECT
public:
    explicit MapRow(const MapKindRow& kind, QWidget* parent = nullptr);
    const MapKindRow& kind() const { return m_kind; }

    // `material` may be null (nothing loaded yet). A slot whose file is not in the material is shown as missing.
    void show(const MapSlot& slot, const Material* material);
    bool isMissing() const { return m_missing; }
    bool isFilled() const { return m_filled; }

Q_SIGNALS:
    void assignWanted(); // ask for a file
    void locateWanted(); // the file has moved: ask where it is
    void dropped(const QString& file);
    void cleared();
    void inverted(bool on);
    void channelChosen(relievo::Channel channel);

protected:
    void paintEvent(QPaintEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override; // Enter and Space as a click, Delete clears
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }
    void dragEnterEvent(QDragEnterEvent*) override;
    void dragLeaveEvent(QDragLeaveEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    const MapKindRow& m_kind;
    QPixmap m_thumbnail;
    QLabel* m_name;
    ElidedLabel* m_facts;
    QToolButton *m_locate, *m_invert, *m_clear;
    QComboBox* m_channel;
    bool m_filled = false, m_missing = false, m_dropHere = false;
};

} // namespace relievo
