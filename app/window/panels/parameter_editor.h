// The line of the parameter panel that shows and changes one row of kParameters.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace relievo {

// Label and control, made for the row's kind: number with slider, whole number, choice, switch or colour.
class ParameterEditor : public QWidget {
    Q_OBJECT
public:
    ParameterEditor(const ParameterRow& row, QWidget* parent = nullptr);
    const ParameterRow& row() const { return m_row; }
    const Value& value() const { return m_value; }

    // Shows a value without signals. `overridden`: it is one pane's own, marked in the label.
    void show(const Value& value, bool overridden);

Q_SIGNALS:
    void edited(const relievo::Value& value);
    void pressed(); // a gesture begins: edits up to `released` are one step
    void released();
    void resumed(); // the gesture that just ended goes on
    void resetWanted(); // double click on the label or slider
    void clearWanted(); // the pane's own value is to go

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void addNumber(QHBoxLayout* layout);
    void addChoice(QHBoxLayout* layout);
    void addSwitch(QHBoxLayout* layout);
    void addColor(QHBoxLayout* layout);
    void change(const Value& value);
    const ParameterRow& m_row;
    Value m_value;
    bool m_overridden = false;
    QLabel* m_label;
    std::function<void(const Value&)> m_show; // brings the control in line
};

// "Depth: 0 to 0.5 tile. Distance from ... Default 0.08."
QString parameterTip(const ParameterRow& row);

// "metallic-roughness" becomes "Metallic-roughness".
QString optionLabel(std::string_view option);

QColor toDisplay(glm::vec3 linear); // sRGB
glm::vec3 toLinear(const QColor& color);

} // namespace relievo
