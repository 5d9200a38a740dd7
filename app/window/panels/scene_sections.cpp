// Choosing and showing mesh and environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/scene_sections.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/dropping.h"
#include "app/window/widgets/elided_label.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/ground/srgb.h"
#include "core/image/environment/environment.h"
#include "core/mesh/mesh.h"
#include "core/state/environments.h"
#include "core/state/shapes.h"
#include <QFileInfo>
#include <QIcon>
#include <QImage>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

namespace relievo {
namespace {
QToolButton* lineButton(const char* picture, const QString& tip)
{
    auto* button = new QToolButton;
    button->setIcon(icon(picture));
    button->setIconSize({16, 16});
    button->setFixedSize(24, 24);
    button->setToolTip(tip);
    return button;
}

ElidedLabel* factsLabel()
{
    auto* label = new ElidedLabel;
    label->setFont(smallFont());
    label->setProperty("role", "dim");
    return label;
}

Segmented* shapeButtons()
{
    QVector<Segmented::Item> shapes;
    for (std::string_view shape : kShapes)
        shapes.append({{}, qt(shape).replace(0, 1, qt(shape).left(1).toUpper()), icon(shape)});
    return new Segmented(shapes);
}

void showFile(ElidedLabel& label, const std::string& file, bool missing, const char* role)
{
    const QString path = QString::fromStdString(file), name = QFileInfo(path).fileName();
    setRole(label, missing ? "warning" : role);
    label.setFullText(missing ? QObject::tr("missing: %1").arg(name) : name);
    label.setToolTip(path);
}

QString meshFacts(const Mesh& mesh)
{
    const glm::vec3 size = mesh.boundsMax - mesh.boundsMin;
    return QObject::tr("%1 triangles   %2 \u00d7 %3 \u00d7 %4 m")
        .arg(mesh.indices.size() / 3)
        .arg(double(size.x), 0, 'g', 3)
        .arg(double(size.y), 0, 'g', 3)
        .arg(double(size.z), 0, 'g', 3);
}
} // namespace

MeshSection::MeshSection(QWidget* parent)
    : Section(tr("Mesh"), parent)
    , m_shapes(shapeButtons())
    , m_parts(new ChoiceList)
    , m_name(factsLabel())
    , m_facts(factsLabel())
{
    m_shapes->setObjectName("shapes");
    m_parts->setObjectName("parts");
    m_parts->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a long name does not widen the panel
    m_parts->setToolTip(
        tr("Which part of the mesh shows the material, by the materials of its file; the maps that the file has for it are taken"));
    m_name->setObjectName("mesh-name");
    auto* open = lineButton("mesh", tr("Open a mesh: glTF, OBJ, PLY, STL, OFF"));
    auto* facts = new QVBoxLayout;
    facts->setSpacing(0);
    facts->addWidget(m_name);
    facts->addWidget(m_facts);
    // What is chosen is above what comes and goes with the choice: nothing moves away under the mouse.
    auto* line = new QHBoxLayout;
    line->addWidget(m_shapes);
    line->addStretch(1);
    line->addWidget(open);
    body()->addLayout(line);
    body()->addLayout(facts);
    body()->addWidget(m_parts);
    connect(m_parts, &QComboBox::activated, this, [this](int index) { Q_EMIT partChosen(m_parts->itemData(index).toString()); });
    connect(m_shapes, &Segmented::chosen, this, [this](int index) { Q_EMIT chosen(qt(kShapes[std::size_t(index)])); });
    connect(open, &QToolButton::clicked, this,
        [this] { askForFile(this, tr("Open a mesh"), FileKind::Mesh, [this](const QString& file) { Q_EMIT chosen(file); }); });
}

void MeshSection::show(const State& state, const Mesh* mesh, bool missing)
{
    const std::string_view ofObject = shapeOfObject(state.mesh);
    const auto shape = std::find(kShapes.begin(), kShapes.end(), state.mesh);
    m_shapes->setCurrent(shape == kShapes.end() ? -1 : int(shape - kShapes.begin()));
    if (ofObject.empty())
        showFile(*m_name, state.mesh, missing, "dim");
    else
        m_name->setFullText(tr("%1, as a relief object").arg(qt(ofObject)));
    m_name->setVisible(shape == kShapes.end());
    m_facts->setFullText(missing ? tr("a plane stands in") : mesh ? meshFacts(*mesh) : QString());
    showParts(state, mesh);
}

// The materials that parts of the mesh name, when there is a choice.
void MeshSection::showParts(const State& state, const Mesh* mesh)
{
    m_parts->clear();
    m_parts->addItem(tr("All parts"), QString());
    QStringList names;
    for (const MeshPart& part : mesh ? mesh->parts : std::vector<MeshPart>{})
        if (!names.contains(qt(part.material)))
            names.append(qt(part.material));
    for (const QString& name : names)
        m_parts->addItem(name, name);
    const bool textured = mesh && std::ranges::any_of(mesh->materials, [](const MeshMaterial& m) { return m.maps != MapSlots(); });
    m_parts->setVisible(names.size() > 1 || textured);
    m_parts->setCurrentIndex(std::max(0, m_parts->findData(QString::fromStdString(state.part))));
}

namespace {
// All around, the horizon in the middle, as it is seen when its average is a middle grey.
QIcon thumbnail(std::string_view key)
{
    constexpr int kAcross = 96, kDown = 48;
    QImage image(kAcross, kDown, QImage::Format_RGB32);
    for (int y = 0; y < kDown; ++y)
        for (int x = 0; x < kAcross; ++x) {
            const glm::vec2 turn
                = glm::vec2(2.f * (float(x) + 0.5f) / float(kAcross) - 1.f, (float(y) + 0.5f) / float(kDown)) * glm::pi<float>();
            const glm::vec3 towards(std::sin(turn.x) * std::sin(turn.y), std::cos(turn.y), -std::cos(turn.x) * std::sin(turn.y));
            const glm::vec3 seen = 1.f - glm::exp(-0.7f * builtInRadiance(key, towards));
            image.setPixelColor(x, y, QColor::fromRgbF(srgbOf(seen.x), srgbOf(seen.y), srgbOf(seen.z)));
        }
    QPixmap pixmap = QPixmap::fromImage(image);
    pixmap.setDevicePixelRatio(2.);
    return QIcon(pixmap);
}
} // namespace

EnvironmentSection::EnvironmentSection(QWidget* parent) : Section(tr("Environment"), parent), m_choice(new ChoiceList), m_name(factsLabel())
{
    setObjectName("environment");
    setAcceptDrops(true);
    m_name->setObjectName("environment-name");
    m_choice->setObjectName("environments");
    m_choice->setIconSize({48, 24});
    m_choice->setToolTip(tr("The surroundings that light the mesh and that it mirrors: built in, or a panorama of your own"));
    for (const EnvironmentRow& row : kEnvironments)
        m_choice->addItem(thumbnail(row.key), qt(row.label), qt(row.key));
    auto* open = lineButton("open", tr("Open a panorama: HDR or EXR"));
    auto* line = new QHBoxLayout;
    line->addWidget(m_choice, 1);
    line->addWidget(open);
    body()->addLayout(line);
    body()->addWidget(m_name);
    connect(m_choice, &QComboBox::activated, this, [this](int index) { Q_EMIT chosen(m_choice->itemData(index).toString()); });
    connect(open, &QToolButton::clicked, this,
        [this] { askForFile(this, tr("Open a panorama"), FileKind::Panorama, [this](const QString& file) { Q_EMIT chosen(file); }); });
}

void EnvironmentSection::show(const State& state, bool missing)
{
    const bool isBuiltIn = isBuiltInEnvironment(state.environment);
    while (m_choice->count() > int(kEnvironments.size()))
        m_choice->removeItem(m_choice->count() - 1);
    if (!isBuiltIn)
        m_choice->addItem(tr("Panorama"), QString::fromStdString(state.environment));
    m_choice->setCurrentIndex(m_choice->findData(QString::fromStdString(state.environment)));
    showFile(*m_name, state.environment, missing, "dim");
    m_name->setVisible(!isBuiltIn);
}

bool EnvironmentSection::event(QEvent* event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return Section::event(event);
    auto* drop = static_cast<QDropEvent*>(event);
    const auto urls = drop->mimeData()->urls();
    if (urls.size() != 1 || !fits(FileKind::Panorama, urls.front().toLocalFile()))
        return Section::event(event);
    acceptCopy(*drop);
    if (event->type() == QEvent::Drop)
        Q_EMIT chosen(urls.front().toLocalFile());
    return true;
}

} // namespace relievo
