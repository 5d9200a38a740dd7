// Computing FLIP for the window.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/flip_map.h"
#include "core/analysis/image_metrics.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace relievo {
namespace {
FlipPicture flipPicture(const Image& reference, const Image& test)
{
    const std::vector<float> map = Flip(reference).map(test);
    FlipPicture made{Image{.width = reference.width, .height = reference.height, .channels = 4, .data = {}}};
    made.heat.data.resize(map.size() * 4, std::byte(255));
    std::array<glm::vec3, 256> colors;
    for (std::size_t i = 0; i < colors.size(); ++i)
        colors[i] = heatColor(float(i) / 255.f) * 255.f + 0.5f;
    for (std::size_t i = 0; i < map.size(); ++i) {
        made.mean += double(map[i]);
        made.most = std::max(made.most, double(map[i]));
        const glm::vec3& color = colors[std::size_t(std::lround(std::clamp(map[i], 0.f, 1.f) * 255.f))];
        for (int channel = 0; channel < 3; ++channel)
            made.heat.data[i * 4 + std::size_t(channel)] = std::byte(int(color[channel]));
    }
    made.mean /= double(std::max(map.size(), std::size_t(1)));
    return made;
}
} // namespace

FlipMap::FlipMap(QObject* parent) : QObject(parent) { }

void FlipMap::want(Image reference, Image test)
{
    m_background.start([this, reference = std::move(reference), test = std::move(test)](const Progress&) -> Background::Then {
        auto made = std::make_shared<const FlipPicture>(flipPicture(reference, test));
        return [this, made] {
            m_made = made;
            Q_EMIT this->made();
        };
    });
}

void FlipMap::forget()
{
    m_background.cancel();
    m_made.reset();
}

} // namespace relievo
