// How the way of a slider maps to the range of a number: linear, logarithmic or bent, and rounded to values worth having.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <QString>

namespace relievo {

// Maps value to position in [0, 1] and back; both monotone, ends map to ends.
struct SliderScale {
    // Logarithmic: positive and at least a hundredfold. Cubic: from 0 to 10 or more, or to ten times the default or more; fine
    // near 0. SignedCubic: the same about 0.
    enum class Kind { Linear, Logarithmic, Cubic, SignedCubic };
    Kind kind = Kind::Linear;
    double min = 0, max = 1;
    bool whole = false; // integers only

    double position(double value) const;
    double value(double position) const;
    // To about 1 / 200 of the way (coarse: 1 / 20, fine: 1 / 2000), as a round number; never outside [min, max].
    enum class Grain { Fine, Normal, Coarse };
    double rounded(double value, Grain grain) const;
};
SliderScale scaleOf(const ParameterRow& row);

// At most four digits that count and no exponent: "1000", "0.000025".
QString plainNumber(double value);

// As many decimals for all values of a row as its range makes sense of, so that columns stay calm; more where a value is small,
// fewer where it is large, for about four digits that count.
QString numberText(const ParameterRow& row, double value);

} // namespace relievo
