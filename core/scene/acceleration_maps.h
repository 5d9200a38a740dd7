// The acceleration maps of a scene, and the maps of horizons that its light reads: the only place that holds them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/maps/acceleration/acceleration_map.h"
#include "core/state/state.h"
#include "core/state/techniques.h"
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

namespace relievo {

struct Material;

// A map that a pane wants of the material's heights.
struct MapWish {
    std::string_view row; // of kBakedMaps
    Wrap wrap = Wrap::Repeat;
    bool allLevels = false; // of the heights' mip levels; else the finest only
    bool operator==(const MapWish&) const = default;
};
// That the technique searches with, and of horizons; none for most.
std::vector<MapWish> mapWishes(const TechniqueRow& technique, const Parameters& parameters);

// Of one height map at a time; cheap to copy, copies share the maps.
class AccelerationMaps {
public:
    using Map = std::shared_ptr<const AccelerationMap>;

    // The map that the technique searches the material's heights with under the parameters (wrap mode, mip levels); nullptr for a technique
    // that needs none. Errors: NotReady when it is not made yet, or was made of other heights or for fewer levels; Refused without heights.
    Expected<Map> of(const TechniqueRow& technique, const Parameters& parameters, const Material& material) const;
    // The map of horizons (horizon-slopes, or the one of 16) that shadows or the light of the surroundings read; nullptr when neither does,
    // or without heights. Errors: NotReady, as above.
    Expected<Map> horizonsOf(const TechniqueRow& technique, const Parameters& parameters, const Material& material) const;

    // Makes them, from the cache or baked, when they are wanted and not there. Errors: those of the bake.
    Expected<void> make(
        const TechniqueRow& technique, const Parameters& parameters, const Material& material, const Progress& progress = {});

    // The same for all panes of a State; others are kept.
    Expected<void> makeFor(const State& state, const Material& material, const Progress& progress = {});
    // Rows of kBakedMaps that the panes want and that are not there, each as often as it has to be made; none without a height map.
    std::vector<std::string_view> missingFor(const State& state, const Material& material) const;

    // Forgets those that no pane of the State reads.
    void keepOnlyOf(const State& state, const Material& material);
    bool holds(const AccelerationMap* map) const;
    std::size_t count() const { return m_made.size(); }

private:
    using Key = std::pair<std::string_view, Wrap>; // row of kBakedMaps; two panes may wrap differently
    struct Made {
        Map map;
        std::shared_ptr<const void> heights; // HeightField::identity
        bool allLevels = false;
    };
    static Key keyOf(const MapWish& wish) { return {wish.row, wish.wrap}; }
    Map find(const MapWish& wish, const Material& material) const; // nullptr when it is not made
    Expected<void> make(const MapWish& wish, const Parameters& parameters, const Material& material, const Progress& progress);
    std::map<Key, Made> m_made;
};

} // namespace relievo
