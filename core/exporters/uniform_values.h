// The uniforms of shaders that are exported, as JSON.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/exporters/exporters.h"
#include "core/exporters/map_images.h"
#include "core/exporters/web_data.h"
#include "core/state/techniques.h"

namespace relievo {

inline WebJson jsonOf(float value)
{
    return shortest(value);
}
inline WebJson jsonOf(int value)
{
    return value;
}
inline WebJson jsonOf(bool value)
{
    return int(value);
}
template <class Vector> WebJson jsonOf(const Vector& value) // or a matrix, column by column
{
    WebJson numbers = WebJson::array();
    const auto* first = &value[0];
    if constexpr (requires { (*first)[0]; })
        for (int i = 0; i < value.length(); ++i)
            for (int k = 0; k < value[i].length(); ++k)
                numbers.push_back(shortest(value[i][k]));
    else
        for (int i = 0; i < value.length(); ++i)
            numbers.push_back(shortest(value[i]));
    return numbers;
}

// Parameters and what is computed of them, by name: choices and switches as whole numbers, vectors and matrices as lists.
WebJson uniformValues(const Parameters& parameters, const TechniqueRow& technique, const ExportJob& job);

} // namespace relievo
