// The mapping between sliders and numbers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/slider_scale.h"
#include <QObject>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
// The power of ten times 1, 2 or 5 that is next below `x` > 0.
double roundStep(double x)
{
    const double power = std::pow(10., std::floor(std::log10(x)));
    const double lead = x / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

// Whether what is usual lies in the first tenth of the range.
bool isMostlySmall(const ParameterRow& row)
{
    static const Parameters defaults;
    const Value value = get(defaults, row);
    const float* usual = std::get_if<float>(&value);
    return usual && *usual > 0.f && *usual <= 0.1f * row.max;
}

// For four digits that count.
int decimalsOf(double value)
{
    const double size = std::abs(value);
    return size < 1e-12 ? 4 : std::max(0, 3 - int(std::floor(std::log10(size) + 1e-9)));
}
} // namespace

double SliderScale::position(double v) const
{
    v = std::clamp(v, min, max);
    switch (kind) {
    case Kind::Logarithmic:
        return std::log(v / min) / std::log(max / min);
    case Kind::Cubic:
        return std::cbrt((v - min) / (max - min));
    case Kind::SignedCubic:
        return 0.5 + 0.5 * std::cbrt(v / max);
    case Kind::Linear:
        break;
    }
    return (v - min) / (max - min);
}

double SliderScale::value(double p) const
{
    p = std::clamp(p, 0., 1.);
    switch (kind) {
    case Kind::Logarithmic:
        return min * std::pow(max / min, p);
    case Kind::Cubic:
        return min + (max - min) * p * p * p;
    case Kind::SignedCubic:
        return max * std::pow(2 * p - 1, 3);
    case Kind::Linear:
        break;
    }
    return min + (max - min) * p;
}

double SliderScale::rounded(double v, Grain grain) const
{
    const double way = grain == Grain::Fine ? 1. / 2000 : grain == Grain::Normal ? 1. / 200 : 1. / 20;
    const double p = position(v);
    const double local = value(std::min(p + way / 2, 1.)) - value(std::max(p - way / 2, 0.)); // the range that this way covers here
    const double step = whole ? std::max(1., roundStep(local * 1.001)) : roundStep(local * 1.001);
    return std::clamp(std::round(v / step) * step, min, max);
}

SliderScale scaleOf(const ParameterRow& row)
{
    SliderScale scale{SliderScale::Kind::Linear, row.min, row.max, kindOf(row) == ValueKind::Whole};
    if (row.min > 0 && row.max / row.min >= 100)
        scale.kind = SliderScale::Kind::Logarithmic;
    else if (row.min == 0 && !scale.whole && (row.max >= 10 || isMostlySmall(row)))
        scale.kind = SliderScale::Kind::Cubic;
    else if (row.min == -row.max && row.unit == "tile")
        scale.kind = SliderScale::Kind::SignedCubic;
    return scale;
}

QString plainNumber(double value)
{
    QString text = QString::number(value, 'f', decimalsOf(value));
    if (text.contains('.'))
        while (text.endsWith('0') || text.endsWith('.'))
            if (const bool point = text.endsWith('.'); text.chop(1), point)
                break;
    return text;
}

QString numberText(const ParameterRow& row, double value)
{
    if (row.key == "metresPerUV" && value == 0)
        return QObject::tr("auto"); // measured from the mesh
    if (kindOf(row) == ValueKind::Whole)
        return QString::number(std::lround(value));
    const double reach = std::max(std::abs(double(row.min)), std::abs(double(row.max)));
    const int most = std::min(decimalsOf(value), 5);
    int digits = row.unit == "deg" ? 1 : row.min > 0 && row.min < 0.001f ? 4 : reach < 2 ? 3 : reach < 100 || row.max >= 500 ? 2 : 1;
    digits = std::min(digits, most);
    while (digits < most && std::abs(QString::number(value, 'f', digits).toDouble() - value) > 5e-5 * std::abs(value))
        ++digits;
    const QString text = QString::number(value, 'f', digits);
    return text.startsWith('-') && text.toDouble() == 0 ? text.mid(1) : text; // no "-0.00"
}

} // namespace relievo
