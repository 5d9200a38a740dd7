// Controls made from a row of the parameter table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/parameter_editor.h"
#include "app/window/dialogs/color_dialog.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/slider.h"
#include "app/window/widgets/switch.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <cmath>

namespace relievo {
namespace {
constexpr int kNumberWidth = 60, kUnitWidth = 42; // px
constexpr int kSegmentedLetters = 14; // choices with longer texts in all become a list

// All labels stand in a column as wide as the longest.
int labelWidth(const QFontMetrics& metrics)
{
    int width = 0;
    for (const ParameterRow& row : kParameters)
        width = std::max(width, metrics.horizontalAdvance(qt(row.label)));
    return width + 2;
}

double number(const Value& value)
{
    return std::holds_alternative<int>(value) ? std::get<int>(value) : double(std::get<float>(value));
}

Value numberValue(const ParameterRow& row, double v)
{
    if (kindOf(row) == ValueKind::Whole || kindOf(row) == ValueKind::Choice)
        return int(std::lround(v));
    return float(v);
}

float encode(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.f / 2.4f) - 0.055f;
}

float decode(float srgb)
{
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}
} // namespace

QColor toDisplay(glm::vec3 c)
{
    const auto channel = [](float v) { return encode(std::clamp(v, 0.f, 1.f)); };
    return QColor::fromRgbF(channel(c.x), channel(c.y), channel(c.z));
}

glm::vec3 toLinear(const QColor& color)
{
    return {decode(color.redF()), decode(color.greenF()), decode(color.blueF())};
}

QString optionLabel(std::string_view option)
{
    QString text = qt(option);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

QString parameterTip(const ParameterRow& row)
{
    static const Parameters defaults;
    QString range;
    if (kindOf(row) == ValueKind::Choice || kindOf(row) == ValueKind::Switch)
        range = {};
    else if (kindOf(row) == ValueKind::Color)
        range = "<br>Color, set as shown, kept linear.";
    else
        range = QString("<br>%1 to %2 %3").arg(double(row.min)).arg(double(row.max)).arg(qt(row.unit)).trimmed() + '.';
    return QString("<p><b>%1</b> &nbsp;<code>%2</code><br>%3%4<br>Default %5. Double-click resets, Ctrl is fine, Shift coarse.</p>")
        .arg(qt(row.label), qt(row.key), qt(row.help), range, QString::fromStdString(toText(row, get(defaults, row))));
}

ParameterEditor::ParameterEditor(const ParameterRow& row, QWidget* parent)
    : QWidget(parent)
    , m_row(row)
    , m_value(get(Parameters{}, row))
    , m_label(new QLabel(qt(row.label), this))
{
    setObjectName(qt(row.key));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2 * kGrid);
    m_label->setFixedWidth(labelWidth(fontMetrics()));
    m_label->installEventFilter(this);
    layout->addWidget(m_label);
    setFixedHeight(kRowHeight);
    setToolTip(parameterTip(row));
    if (kindOf(row) == ValueKind::Choice)
        addChoice(layout);
    else if (kindOf(row) == ValueKind::Switch)
        addSwitch(layout);
    else if (kindOf(row) == ValueKind::Color)
        addColor(layout);
    else
        addNumber(layout);
    show(m_value, false);
}

void ParameterEditor::addNumber(QHBoxLayout* layout)
{
    auto* slider = new Slider(scaleOf(m_row), number(m_value), this);
    auto* field = new NumberField(m_row, this);
    auto* unit = new QLabel(qt(m_row.unit), this);
    slider->setAccessibleName(qt(m_row.label));
    field->setAccessibleName(qt(m_row.label));
    field->setFixedSize(kNumberWidth, 22);
    unit->setFixedWidth(kUnitWidth);
    unit->setFont(smallFont());
    unit->setProperty("role", "dim");
    layout->addWidget(slider, 1);
    layout->addWidget(field);
    layout->setSpacing(kGrid + 2);
    layout->addWidget(unit);
    connect(slider, &Slider::pressed, this, &ParameterEditor::pressed);
    connect(slider, &Slider::released, this, &ParameterEditor::released);
    connect(field, &NumberField::pressed, this, &ParameterEditor::pressed);
    connect(field, &NumberField::released, this, &ParameterEditor::released);
    connect(slider, &Slider::resumed, this, &ParameterEditor::resumed);
    connect(slider, &Slider::resetWanted, this, &ParameterEditor::resetWanted);
    connect(slider, &Slider::moved, this, [this, field](double v) {
        field->setValue(v);
        change(numberValue(m_row, v));
    });
    connect(field, &NumberField::entered, this, [this, slider](double v) {
        slider->setValue(v);
        change(numberValue(m_row, v));
    });
    m_show = [slider, field](const Value& value) {
        slider->setValue(number(value));
        field->setValue(number(value));
    };
}

void ParameterEditor::addChoice(QHBoxLayout* layout)
{
    QVector<Segmented::Item> items;
    for (int i = 0; i < optionCount(m_row); ++i)
        items.append({optionLabel(option(m_row, i)), {}, {}});
    if (int(optionList(m_row, ' ').size()) <= kSegmentedLetters) {
        auto* choice = new Segmented(items, this);
        layout->addWidget(choice);
        layout->addStretch(1);
        connect(choice, &Segmented::chosen, this, [this](int index) { change(index); });
        m_show = [choice](const Value& value) { choice->setCurrent(std::get<int>(value)); };
        return;
    }
    auto* choice = new ChoiceList(this);
    for (const auto& item : items)
        choice->addItem(item.text);
    choice->setFocusPolicy(Qt::StrongFocus);
    layout->addWidget(choice, 1);
    connect(choice, &ChoiceList::activated, this, [this](int index) { change(index); });
    m_show = [choice](const Value& value) { choice->setCurrentIndex(std::get<int>(value)); };
}

void ParameterEditor::addSwitch(QHBoxLayout* layout)
{
    auto* button = new Switch(this);
    button->setAccessibleName(qt(m_row.label));
    layout->addWidget(button);
    layout->addStretch(1);
    connect(button, &Switch::clicked, this, [this](bool on) { change(on); });
    m_show = [button](const Value& value) { button->setChecked(std::get<bool>(value)); };
}

void ParameterEditor::addColor(QHBoxLayout* layout)
{
    auto* swatch = new Swatch(this);
    swatch->setAccessibleName(qt(m_row.label));
    layout->addWidget(swatch, 1);
    m_show = [this, swatch](const Value& value) {
        const QColor color = toDisplay(std::get<glm::vec3>(value));
        swatch->setColor(color);
        if (auto* dialog = findChild<ColorDialog*>())
            dialog->show(color);
    };
    connect(swatch, &Swatch::clicked, this, [this] {
        if (auto* open = findChild<ColorDialog*>())
            return open->raise();
        auto* dialog = new ColorDialog(toDisplay(std::get<glm::vec3>(m_value)), this);
        dialog->setWindowTitle(m_label->text());
        connect(dialog, &ColorDialog::pressed, this, &ParameterEditor::pressed);
        connect(dialog, &ColorDialog::released, this, &ParameterEditor::released);
        connect(dialog, &ColorDialog::chosen, this, [this](const QColor& color) { change(toLinear(color)); });
        dialog->move(window()->mapToGlobal(QPoint(0, 2 * kRowHeight))); // over the maps: the picture shows what is chosen
        dialog->QWidget::show();
    });
}

void ParameterEditor::change(const Value& value)
{
    m_value = value;
    Q_EMIT edited(value);
}

void ParameterEditor::show(const Value& value, bool overridden)
{
    m_value = value;
    m_overridden = overridden;
    m_show(value);
    const bool changed = value != get(Parameters{}, m_row);
    setRole(*m_label, overridden ? "own" : changed ? "" : "dim");
    m_label->setText(overridden ? QString::fromUtf8("\u25cf ") + qt(m_row.label) : qt(m_row.label));
}

bool ParameterEditor::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_label && event->type() == QEvent::MouseButtonDblClick) {
        Q_EMIT resetWanted();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ParameterEditor::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    connect(menu.addAction(tr("Reset to default")), &QAction::triggered, this, &ParameterEditor::resetWanted);
    if (m_overridden)
        connect(menu.addAction(tr("Same as the other picture")), &QAction::triggered, this, &ParameterEditor::clearWanted);
    menu.exec(event->globalPos());
}

} // namespace relievo
