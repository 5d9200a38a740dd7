// Grouping channels by their names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imageio/layers.h"
#include "core/ground/text.h"
#include <utility>

namespace relievo::imageio {
namespace {
constexpr int kMaxParts = 64;

bool isPlainChannel(std::string_view channel)
{
    const std::string name = lowered(channel);
    return name == "r" || name == "g" || name == "b" || name == "a" || name == "y" || name == "red" || name == "green" || name == "blue"
        || name == "alpha";
}

// Which layer a channel belongs to, after those of `previous`. The distance beside a colour is no alpha.
std::string layerName(const std::string& channel, const std::string& part, const std::string& previous)
{
    const std::size_t dot = channel.rfind('.');
    if (dot == channel.npos || dot == 0)
        return isPlainChannel(channel) ? part : channel;
    const std::string name = channel.substr(0, dot);
    const bool besideColor = lowered(channel.substr(dot)) == ".z" && lowered(previous) != lowered(name + ".y");
    return besideColor ? channel : name;
}

void addLayers(const OIIO::ImageSpec& spec, int part, std::vector<Layer>& layers)
{
    const std::string partName(spec.get_string_attribute("oiio:subimagename"));
    std::string previous;
    for (int c = 0; c < spec.nchannels && layers.size() < kMaxLayers; ++c) {
        const std::string channel = std::size_t(c) < spec.channelnames.size() ? spec.channelnames[std::size_t(c)] : std::string();
        const std::string name = layerName(channel, partName, std::exchange(previous, channel));
        if (!layers.empty() && layers.back().part == part && layers.back().name == name)
            ++layers.back().channels;
        else
            layers.push_back({name, part, c, 1});
    }
}
} // namespace

std::vector<Layer> layersOf(OIIO::ImageInput& input)
{
    std::vector<Layer> layers;
    for (int part = 0; part < kMaxParts && input.seek_subimage(part, 0); ++part)
        addLayers(input.spec(), part, layers);
    input.seek_subimage(0, 0);
    return layers;
}

std::vector<std::string> namesOf(const std::vector<Layer>& layers)
{
    std::vector<std::string> names;
    for (const Layer& layer : layers)
        names.push_back(layer.name.empty() ? "plain" : layer.name);
    return names;
}

} // namespace relievo::imageio
