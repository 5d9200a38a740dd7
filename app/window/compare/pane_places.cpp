// From the window to the pictures and back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/pane_places.h"
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace relievo {

PanePlaces::PanePlaces(Document& document, std::function<std::size_t()> activePane, QWidget* viewport)
    : QObject(viewport)
    , m_viewport(viewport)
    , m_activePane(std::move(activePane))
    , m_inPlace(new InPlace(document, viewport))
    , m_zoom(new PixelZoom([this](QPointF at) { return areas()[under(at)]; }, viewport))
    , m_flip(new FlipMap(this))
{
    connect(m_inPlace, &InPlace::arranged, this, &PanePlaces::arranged);
    connect(m_inPlace, &InPlace::composed, this, &PanePlaces::composed);
    connect(m_zoom, &PixelZoom::changed, this, &PanePlaces::composed);
    connect(m_flip, &FlipMap::made, this, &PanePlaces::composed);
}

int PanePlaces::pixels(int size) const
{
    return std::max(1, int(std::lround(size * m_viewport->devicePixelRatioF())));
}

std::vector<PaneArea> PanePlaces::areas() const
{
    return m_inPlace->areas(pixels(m_viewport->width()), pixels(m_viewport->height()));
}

std::vector<PaneArea> PanePlaces::captionAreas() const
{
    return m_inPlace->captionAreas(pixels(m_viewport->width()), pixels(m_viewport->height()));
}

std::size_t PanePlaces::under(QPointF position) const
{
    if (m_inPlace->isOn())
        return m_inPlace->paneAt(position);
    return paneAt(areas(), position * m_viewport->devicePixelRatioF()).value_or(m_activePane());
}

glm::vec2 PanePlaces::toPicture(std::size_t pane, QPointF position) const
{
    const PaneArea area = areas()[pane];
    const QPointF at = position * m_viewport->devicePixelRatioF() - QPointF(area.x, area.y);
    return m_zoom->inPicture({at.x() / std::max(area.width, 1), at.y() / std::max(area.height, 1)});
}

QPointF PanePlaces::fromPicture(std::size_t pane, glm::vec2 share) const
{
    const PaneArea area = areas()[pane];
    const glm::vec2 at = m_zoom->inPlace(share);
    return QPointF(area.x + double(at.x) * area.width, area.y + double(at.y) * area.height) / m_viewport->devicePixelRatioF();
}

Arrangement PanePlaces::arrangement() const
{
    Arrangement arrangement{areas(), m_inPlace->isOn() ? m_inPlace->composition() : Composition{}, {}};
    arrangement.composition.zoom = float(m_zoom->factor()), arrangement.composition.corner = m_zoom->corner();
    if (m_inPlace->isOn())
        arrangement.pair = m_inPlace->pair();
    if (m_inPlace->isOn() && m_inPlace->mode() == InPlaceMode::Flip && m_flip->picture())
        arrangement.first = &m_flip->picture()->heat;
    return arrangement;
}

void PanePlaces::compare(PanePictures& pictures)
{
    if (!m_inPlace->isOn() || m_inPlace->mode() != InPlaceMode::Flip)
        return;
    const auto [first, second] = m_inPlace->pair();
    m_flip->want(pictures.pixels(first), pictures.pixels(second));
}

} // namespace relievo
