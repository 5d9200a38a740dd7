// Opening what is measured.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measuring.h"
#include "core/ground/shown_text.h"
#include <algorithm>

namespace relievo::cli {

Result<Subject> openSubject(const StateOptions& options, bool whole, const Progress& progress)
{
    Subject subject{{}, {}, {{}, {}, HeightField(1, 1, {0.f}), 0.}, {}};
    if (whole) {
        auto scene = openScene(options, progress);
        if (!scene)
            return tl::unexpected(scene.error());
        subject.state = std::move(scene->state);
        subject.resources = std::move(scene->resources);
        subject.warnings = std::move(scene->warnings);
    } else {
        auto opened = openState(options, progress.part(0.f, 0.5f));
        if (!opened)
            return tl::unexpected(opened.error());
        MapSlots slots{};
        slots[std::size_t(MapKind::Height)] = opened->state.slots[std::size_t(MapKind::Height)];
        auto material = loadMaterial(slots, opened->images, nullptr, progress.part(0.5f, 1.f));
        if (!material)
            return problem(material.error());
        subject.state = std::move(opened->state);
        subject.warnings = std::move(opened->warnings);
        subject.warnings.insert(subject.warnings.end(), material->warnings.begin(), material->warnings.end());
        subject.resources.material = std::make_shared<const Material>(std::move(*material));
    }
    const auto& height = subject.resources.material->height;
    if (!height)
        return problem(
            {"the material has no height map to search", options.source.empty() ? "SOURCE" : options.source, "Add one by --height FILE"});
    const Parameters parameters = effectiveParameters(subject.state, 0);
    subject.field = {options.source, shownName(subject.state.name), height->withWrap(parameters.wrap), double(parameters.depth)};
    return subject;
}

Result<std::vector<const TechniqueRow*>> techniquesOf(const std::vector<std::string>& keys)
{
    auto rows = techniquesNamed(keys);
    if (!rows)
        return problem({rows.error().what, "--techniques " + rows.error().where, rows.error().hint}, WrongUsage);
    return *rows;
}

} // namespace relievo::cli
