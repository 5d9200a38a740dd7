// The techniques as buttons side by side, or as a list where the window is too narrow for them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/techniques.h"
#include <QVector>
#include <QWidget>
#include <functional>
#include <string>

class QComboBox;

namespace relievo {

class Segmented;

class TechniqueBar : public QWidget {
    Q_OBJECT
public:
    explicit TechniqueBar(QWidget* parent = nullptr);
    void show(const std::string& technique);
    Segmented* buttons() const { return m_buttons; }
    const QVector<const TechniqueRow*>& rows() const { return m_rows; } // those that the GPU can draw

Q_SIGNALS:
    void chosen(const relievo::TechniqueRow& row);

protected:
    void resizeEvent(QResizeEvent*) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, 24}; }

private:
    QVector<const TechniqueRow*> m_rows;
    Segmented* m_buttons;
    QComboBox* m_list;
};

// The same as a menu at a point of the screen; it deletes itself.
void popUpTechniques(QWidget* parent, QPoint at, const std::string& current, const std::function<void(const TechniqueRow&)>& chosen);

} // namespace relievo
