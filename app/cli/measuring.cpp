// Opening what is measured, and judging pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measuring.h"
#include "core/ground/shown_text.h"
#include "core/state/views.h"
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

PictureJudge::PictureJudge(Renderer& renderer, const State& state, Resources& resources, Image exact)
    : m_renderer(&renderer)
    , m_state(state)
    , m_resources(&resources)
    , m_exact(std::move(exact))
    , m_flip(m_exact)
{
}

Expected<PictureJudge> PictureJudge::create(Renderer& renderer, const State& state, Resources& resources, int width, int height)
{
    const State exact = withSetting(state, mostExactSetting(effectiveParameters(state, 0)));
    auto picture = drawPicture(renderer, exact, 0, resources, knownView("shaded").key, width, height, 1, false);
    if (!picture)
        return tl::unexpected(picture.error());
    return PictureJudge(renderer, state, resources, std::move(*picture));
}

Expected<PictureJudge::Verdict> PictureJudge::judge(const SearchSetting& setting)
{
    auto picture = drawPicture(
        *m_renderer, withSetting(m_state, setting), 0, *m_resources, knownView("shaded").key, m_exact.width, m_exact.height, 1, false);
    if (!picture)
        return tl::unexpected(picture.error());
    const double noise = psnr(m_exact, *picture), flip = m_flip.mean(*picture);
    return Verdict{std::move(*picture), noise, flip};
}

} // namespace relievo::cli
