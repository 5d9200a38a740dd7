// The choice in the settings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/samples_at_rest.h"
#include <QSettings>
#include <algorithm>

namespace relievo {

namespace {
constexpr const char* kKey = "viewport/samples";
constexpr int kLong = 10000; // ms

int bounded(int samples)
{
    return std::clamp(samples, SamplesAtRest::kLeast, SamplesAtRest::kMost);
}
} // namespace

SamplesAtRest::SamplesAtRest() : m_wanted(bounded(QSettings().value(kKey, kUsual).toInt())) { }

void SamplesAtRest::want(int samples)
{
    m_wanted = bounded(samples);
    QSettings().setValue(kKey, m_wanted);
}

bool SamplesAtRest::isEnough(int samples) const
{
    return samples == 0 || samples >= m_wanted || (samples >= kLeast && m_since.elapsed() > kLong);
}

bool SamplesAtRest::isShown(int samples) const
{
    return samples > 0 && (isEnough(samples) || (samples & (samples - 1)) == 0);
}

} // namespace relievo
