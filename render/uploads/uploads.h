// Textures of a scene in one OpenGL context, uploaded when a program first reads them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/exact_distances.h"
#include "render/gl/gl_objects.h"
#include "render/gl/program.h"
#include "render/uploads/textures.h"
#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

void bindAccelerationMap(const LinkedProgram& program, const AccelerationUpload& upload, int unit);

class Uploads {
public:
    // Forgets what belongs to other resources than these.
    void show(const Resources& resources, std::size_t panes);

    // Binds the maps, the environment and their sizes that the program reads; uploads those that are missing.
    // acceleration: of the technique, made under `wrap`; horizons: of the heights under it; or nothing.
    void bindMaps(const LinkedProgram& program, const Parameters& parameters, const std::shared_ptr<const AccelerationMap>& acceleration,
        const std::shared_ptr<const AccelerationMap>& horizons);

    // The exact answer of a pane's picture, or none: then what was kept for the pane is forgotten.
    void bindExact(const LinkedProgram& program, std::size_t pane, const std::shared_ptr<const ExactDistances>& exact);

    // How many textures lie in the context: tests see that nothing unused is uploaded.
    int textureCount() const;

private:
    struct Map {
        Texture texture;
        float levels = 0.f; // log2 of the longest side
    };
    const Map& map(MapKind kind);
    const Map& slopes(Wrap wrap);
    const AccelerationUpload& uploaded(const std::shared_ptr<const AccelerationMap>& map, Wrap wrap);
    static void bindMap(const LinkedProgram& program, const std::string& sampler, const Map& map, Wrap wrap, int unit);

    Resources m_resources;
    std::array<std::shared_ptr<const void>, kMapKindCount> m_uploadedMaps; // whose pixels lie in m_maps
    std::array<Map, kMapKindCount> m_maps;
    bool m_normalsFinely = false; // since they were filtered for the first time
    struct Exact {
        std::shared_ptr<const ExactDistances> distances;
        Texture texture;
    };
    std::map<std::size_t, Exact> m_exact; // by pane
    PerChoice<Wrap, Map> m_slopes; // of the height map, for materials without a normal map
    std::shared_ptr<const void> m_uploadedSlopes; // of which height map
    struct Acceleration {
        std::shared_ptr<const AccelerationMap> map;
        AccelerationUpload upload;
    };
    std::map<const AccelerationMap*, Acceleration> m_acceleration;
    Texture m_environment;
};

} // namespace relievo
