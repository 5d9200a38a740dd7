// Drawing what an engine will show.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/engine_pictures.h"
#include "app/window/dialogs/export_form.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/exporters/engines/packing.h"
#include "render/windowless.h"
#include <QGridLayout>
#include <QLabel>

namespace relievo {
namespace {
constexpr int kHeight = 152, kLeastWidth = 160; // px, of a picture
constexpr int kDrawnAfter = 150; // ms after the last change
constexpr int kSamples = 8; // a pixel

QImage imageOf(const Image& drawn)
{
    return QImage(reinterpret_cast<const uchar*>(drawn.data.data()), drawn.width, drawn.height, QImage::Format_RGBA8888).copy();
}

// Picture A alone, shaded.
State shadedBy(const State& state, std::string_view technique, const Parameters& parameters)
{
    State one = ofFirstPane(state);
    one.panes.front().technique = technique;
    one.parameters = parameters;
    return one;
}
} // namespace

Expected<EnginePair> drawnByBoth(
    const ExportChoice& choice, const State& state, const Resources& resources, QSize size, const Progress& progress)
{
    const ExportJob job = choice.jobOf(state, resources, progress);
    const TechniqueRow* const engine = findTechnique(choice.target->engine.technique);
    const Parameters parameters = parametersOf(job);
    if (!engine || !resources.material->height)
        return failure(std::string(choice.target->label), "no technique stands for what it draws", "Choose another target");
    const auto context = WindowlessContext::create();
    if (!context)
        return tl::unexpected(context.error());
    Renderer renderer;
    const auto draw = [&](const State& one, Resources data) {
        return drawPicture(renderer, one, 0, data, {}, size.width(), size.height(), kSamples, false);
    };
    const auto ours = draw(shadedBy(state, techniqueOf(job), parameters), resources);
    if (!ours)
        return tl::unexpected(ours.error());
    const WrittenHeights heights = writtenHeights(job, parameters);
    Parameters written = heights.with(parameters);
    if (!job.cures.contains(Cure::Normals) && !resources.material->map(MapKind::Normal))
        written.normalStrength = 0.f; // it has nothing to light the relief by
    Resources theirs = resources;
    if (heights.span != 1.f || job.size != 0) {
        auto material = std::make_shared<Material>(*resources.material);
        material->height = heights.field;
        theirs.material = std::move(material);
        theirs.accelerationMaps = {};
    }
    if (progress.cancelled())
        return cancelled(std::string(choice.target->label));
    const auto engines = draw(shadedBy(state, engine->key, written), std::move(theirs));
    if (!engines)
        return tl::unexpected(engines.error());
    return EnginePair{imageOf(*ours), imageOf(*engines)};
}

EnginePictures::EnginePictures(const ExportForm& form, const Document& document, const Assets& assets)
    : m_form(form)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
    , m_ours(side("our-picture"))
    , m_engines(side("engine-picture"))
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid);
    int column = 0;
    for (const Side& one : {m_ours, m_engines}) {
        grid->addWidget(one.picture, 0, column);
        grid->addWidget(one.caption, 1, column);
        grid->setColumnStretch(column++, 1);
    }
    m_rest.setSingleShot(true);
    m_rest.setInterval(kDrawnAfter);
    connect(&m_rest, &QTimer::timeout, this, &EnginePictures::draw);
    connect(&form, &ExportForm::edited, this, &EnginePictures::changed);
    connect(&document, &Document::changed, this, &EnginePictures::changed);
    connect(&assets, &Assets::resourcesChanged, this, &EnginePictures::changed);
}

EnginePictures::Side EnginePictures::side(const char* name)
{
    Side made{new QLabel, new QLabel};
    made.picture->setObjectName(name);
    made.picture->setFixedHeight(kHeight);
    made.picture->setMinimumWidth(kLeastWidth);
    made.picture->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    made.picture->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    made.picture->setWordWrap(true);
    made.picture->setProperty("role", "dim");
    made.caption->setFont(smallFont());
    made.caption->setProperty("role", "dim");
    made.caption->setFixedHeight(QFontMetrics(smallFont()).lineSpacing());
    return made;
}

void EnginePictures::showEvent(QShowEvent* event)
{
    m_rest.start();
    QWidget::showEvent(event);
}

void EnginePictures::hideEvent(QHideEvent* event)
{
    m_rest.stop();
    m_background.cancel();
    QWidget::hideEvent(event);
}

void EnginePictures::resizeEvent(QResizeEvent* event)
{
    changed();
    QWidget::resizeEvent(event);
}

void EnginePictures::changed()
{
    if (isVisible())
        m_rest.start();
}

void EnginePictures::draw()
{
    const ExportChoice choice = m_form.choice();
    const TechniqueRow* const engine = findTechnique(choice.target->engine.technique);
    const Resources& resources = m_assets.resources();
    if (!engine)
        return clear(tr("No picture: how it is drawn depends on what opens it."));
    if (!m_assets.ready() || !m_assets.upToDate() || !resources.material || !resources.mesh)
        return clear(tr("Drawn when the files are loaded."));
    if (!resources.material->height)
        return clear(tr("No picture: the material has no height map."));
    m_background.start([this, choice, name = qt(engine->engine), state = m_document.state(), resources,
                           size = m_ours.picture->size() * devicePixelRatioF()](const Progress& progress) -> Background::Then {
        const auto pair = drawnByBoth(choice, state, resources, size, progress);
        return [this, pair, name] { show(pair, name); };
    });
}

void EnginePictures::show(const Expected<EnginePair>& pair, const QString& engine)
{
    if (!pair)
        return clear(QString::fromStdString(message(pair.error())));
    const auto put = [this](const Side& to, const QImage& image, const QString& caption) {
        QPixmap pixels = QPixmap::fromImage(image);
        pixels.setDevicePixelRatio(devicePixelRatioF());
        to.picture->setPixmap(pixels);
        to.caption->setText(caption);
    };
    put(m_ours, pair->ours, tr("Relievo"));
    put(m_engines, pair->engines, tr("%1 (as drawn)").arg(engine));
}

void EnginePictures::clear(const QString& why)
{
    m_background.cancel();
    m_ours.picture->setText(why);
    m_engines.picture->clear();
    for (const Side& one : {m_ours, m_engines})
        one.caption->clear();
}

} // namespace relievo
