// Typing numbers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/slider_scale.h"
#include "app/window/widgets/text.h"
#include <QKeyEvent>
#include <QTimer>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {

NumberField::NumberField(const ParameterRow& row, QWidget* parent) : QLineEdit(parent), m_row(row)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QLineEdit::editingFinished, this, &NumberField::commit);
}

void NumberField::setValue(double value)
{
    m_value = value;
    setText(numberText(m_row, value));
    setModified(false);
}

// With nothing typed, undo and redo are the document's.
bool NumberField::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void NumberField::focusInEvent(QFocusEvent* event)
{
    QLineEdit::focusInEvent(event);
    QTimer::singleShot(0, this, &QLineEdit::selectAll); // after the click has placed its cursor
}

void NumberField::focusOutEvent(QFocusEvent* event)
{
    endStepping();
    QLineEdit::focusOutEvent(event);
}

void NumberField::keyReleaseEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat())
        endStepping();
    QLineEdit::keyReleaseEvent(event);
}

void NumberField::endStepping()
{
    if (std::exchange(m_stepping, false))
        Q_EMIT released();
}

void NumberField::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        setValue(m_value);
        return clearFocus();
    }
    const int step = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (step == 0)
        return QLineEdit::keyPressEvent(event);
    const SliderScale scale = scaleOf(m_row);
    double next = scale.rounded(scale.value(scale.position(m_value) + step * 0.01), SliderScale::Grain::Normal);
    if (scale.whole)
        next = std::clamp(m_value + step, scale.min, scale.max);
    if (!std::exchange(m_stepping, true))
        Q_EMIT pressed();
    setValue(next);
    Q_EMIT entered(next);
}

void NumberField::commit()
{
    if (!isModified())
        return;
    const std::optional<double> read = typedNumber(m_row, text());
    if (!read) {
        setValue(m_value);
        return sayRange();
    }
    double typed = *read;
    if (kindOf(m_row) == ValueKind::Whole)
        typed = std::round(typed);
    const double allowed = std::clamp(typed, double(m_row.min), double(m_row.max));
    const bool differs = allowed != m_value;
    setValue(allowed);
    if (differs)
        Q_EMIT entered(allowed);
    if (allowed != typed)
        sayRange();
}

void NumberField::sayRange()
{
    const QString range = tr("%1 to %2 %3").arg(plainNumber(m_row.min), plainNumber(m_row.max), qt(m_row.unit)).trimmed();
    // Later: a tooltip goes when the focus moves, and that is often what brought us here.
    QTimer::singleShot(0, this, [this, range] { QToolTip::showText(mapToGlobal(QPoint(0, height())), range, this, {}, 4000); });
}

std::optional<double> typedNumber(const ParameterRow& row, QString text)
{
    text = text.trimmed().replace(',', '.');
    if (text.compare(numberText(row, 0), Qt::CaseInsensitive) == 0) // "auto"
        return 0.;
    const auto drop = [&](const QString& unit) {
        const bool there = !unit.isEmpty() && text.endsWith(unit, Qt::CaseInsensitive);
        if (there)
            text.chop(unit.size());
        return there;
    };
    const bool isShare = row.max < 2 && kindOf(row) != ValueKind::Whole;
    const double scale = isShare && drop("%") ? 0.01 : 1.;
    if (row.unit != "deg" || !drop(QString::fromUtf8("\u00b0")))
        drop(qt(row.unit));
    bool sound = false;
    const double typed = text.trimmed().toDouble(&sound) * scale;
    return sound && std::isfinite(typed) ? std::optional(typed) : std::nullopt;
}

void commitTyping(const QWidget* window)
{
    if (auto* field = qobject_cast<NumberField*>(window->focusWidget()))
        field->commit();
}

} // namespace relievo
