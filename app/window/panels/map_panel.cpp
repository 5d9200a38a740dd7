// Assigning maps, mesh and environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/map_panel.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/panels/map_row.h"
#include "app/window/widgets/choice_list.h"
#include "app/window/widgets/elided_label.h"
#include "app/window/widgets/section.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/gltf/pictures.h"
#include "core/state/shapes.h"
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

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

MapPanel::MapPanel(Document& document, Assets& assets, QWidget* parent) : QWidget(parent), m_document(document), m_assets(assets)
{
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* maps = new Section(tr("Maps"));
    auto* mesh = new Section(tr("Mesh"));
    auto* environment = new Section(tr("Environment"));
    addMaps(*maps);
    addMesh(*mesh);
    addEnvironment(*environment);
    for (Section* section : {maps, mesh, environment})
        column->addWidget(section);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    connect(&assets, &Assets::resourcesChanged, this, &MapPanel::refresh);
    connect(&assets, &Assets::refused, this, &MapPanel::refresh);
    connect(&document, &Document::changed, this, [this](Changes what) {
        if (what & (Changes(Change::Maps) | Change::Mesh | Change::Environment))
            refresh();
    });
    refresh();
}

void MapPanel::addMaps(Section& section)
{
    section.body()->setContentsMargins(0, 0, 0, 4);
    section.body()->setSpacing(0);
    for (const MapKindRow& kind : kMapKinds) {
        auto* line = new MapRow(kind);
        section.body()->addWidget(line);
        m_rows.append(line);
        connect(line, &MapRow::assignWanted, this, [this, &kind] {
            askForFile(
                this, tr("%1 map").arg(qt(kind.label)), FileKind::Image, [this, &kind](const QString& file) { assign(kind.kind, file); });
        });
        connect(line, &MapRow::locateWanted, this, [this, &kind] {
            askForFile(this, tr("Locate the %1 map").arg(qt(kind.label)), FileKind::Image,
                [this, &kind](const QString& file) { locate(kind.kind, file); });
        });
        connect(line, &MapRow::dropped, this, [this, &kind](const QString& file) { assign(kind.kind, file); });
        connect(line, &MapRow::cleared, this, [this, &kind] { assign(kind.kind, {}); });
        connect(line, &MapRow::inverted, this, [this, &kind](bool on) {
            m_assets.propose(kind.kind == MapKind::Normal ? tr("Flip green") : tr("Invert %1").arg(qt(kind.label)),
                [&kind, on](State& state) { state.slots[std::size_t(kind.kind)].invert = on; });
        });
        connect(line, &MapRow::channelChosen, this, [this, &kind](Channel channel) {
            m_assets.propose(tr("Channel of %1").arg(qt(kind.label)),
                [&kind, channel](State& state) { state.slots[std::size_t(kind.kind)].channel = channel; });
        });
    }
}

void MapPanel::addMesh(Section& section)
{
    QVector<Segmented::Item> shapes;
    for (std::string_view shape : kShapes)
        shapes.append({{}, qt(shape).replace(0, 1, qt(shape).left(1).toUpper()), icon(shape)});
    m_shapes = new Segmented(shapes);
    m_shapes->setObjectName("shapes");
    auto* open = lineButton("mesh", tr("Open a mesh: glTF, OBJ, PLY, STL, OFF"));
    section.body()->addWidget(m_shapes);
    m_parts = new ChoiceList;
    m_parts->setObjectName("parts");
    m_parts->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a long name does not widen the panel
    m_parts->setToolTip(
        tr("Which part of the mesh shows the material, by the materials of its file; the maps that the file has for it are taken"));
    section.body()->addWidget(m_parts);
    connect(m_parts, &QComboBox::activated, this, [this](int index) { choosePart(m_parts->itemData(index).toString()); });
    auto* line = new QHBoxLayout;
    auto* facts = new QVBoxLayout;
    facts->setSpacing(0);
    facts->addWidget(m_meshName = factsLabel());
    facts->addWidget(m_meshFacts = factsLabel());
    m_meshName->setObjectName("mesh-name");
    line->addLayout(facts, 1);
    line->addWidget(open, 0, Qt::AlignTop);
    section.body()->addLayout(line);
    connect(m_shapes, &Segmented::chosen, this, [this](int index) { setMesh(qt(kShapes[std::size_t(index)])); });
    connect(open, &QToolButton::clicked, this,
        [this] { askForFile(this, tr("Open a mesh"), FileKind::Mesh, [this](const QString& file) { setMesh(file); }); });
}

void MapPanel::addEnvironment(Section& section)
{
    section.setObjectName("environment");
    section.setAcceptDrops(true);
    section.installEventFilter(this);
    auto* line = new QHBoxLayout;
    m_environmentName = new ElidedLabel;
    m_environmentName->setObjectName("environment-name");
    auto* open = lineButton("open", tr("Open a panorama: HDR or EXR"));
    m_studio = lineButton("reset", tr("Back to the built-in studio"));
    line->addWidget(m_environmentName, 1);
    line->addWidget(m_studio);
    line->addWidget(open);
    section.body()->addLayout(line);
    connect(m_studio, &QToolButton::clicked, this, [this] { setEnvironment("studio"); });
    connect(open, &QToolButton::clicked, this,
        [this] { askForFile(this, tr("Open a panorama"), FileKind::Panorama, [this](const QString& file) { setEnvironment(file); }); });
}

void MapPanel::assign(MapKind kind, const QString& file)
{
    const QString name = qt(row(kind).label);
    const std::string path = file.isEmpty() ? std::string() : QFileInfo(file).absoluteFilePath().toStdString();
    m_assets.assign(path.empty() ? tr("Clear %1").arg(name) : tr("Assign %1").arg(name), kind, path);
}

std::function<void(State&)> MapPanel::locateOthers(const QString& file) const
{
    QVector<std::size_t> lost;
    for (const MapRow* line : m_rows)
        if (line->isMissing())
            lost.append(std::size_t(line->kind().kind));
    return [lost, folder = QFileInfo(file).absoluteDir()](State& state) {
        for (std::size_t i : lost) {
            const QString beside = folder.filePath(QFileInfo(QString::fromStdString(state.slots[i].file)).fileName());
            if (pictureMayExist(beside.toStdString()))
                state.slots[i].file = beside.toStdString();
        }
    };
}

void MapPanel::locate(MapKind kind, const QString& file)
{
    m_assets.propose(tr("Locate maps"), [kind, file, others = locateOthers(file)](State& state) {
        others(state);
        state.slots[std::size_t(kind)].file = QFileInfo(file).absoluteFilePath().toStdString();
    });
}

void MapPanel::setMesh(const QString& nameOrFile)
{
    if (!m_assets.locatesMesh(nameOrFile))
        return m_assets.propose(tr("Mesh"), [nameOrFile](State& state) { state.mesh = nameOrFile.toStdString(), state.part.clear(); });
    m_assets.propose(tr("Locate mesh"), [nameOrFile, others = locateOthers(nameOrFile)](State& state) {
        others(state);
        state.mesh = nameOrFile.toStdString(); // the part stays
    });
}

// "" for all parts.
void MapPanel::choosePart(const QString& material)
{
    const std::shared_ptr<const Mesh> mesh = m_assets.resources().mesh;
    m_assets.propose(
        material.isEmpty() ? tr("All parts") : tr("Part %1").arg(material), [mesh, name = material.toStdString()](State& state) {
            state.part = name;
            const auto found = std::ranges::find(mesh->materials, name, &MeshMaterial::name);
            for (std::size_t i = 0; found != mesh->materials.end() && i < state.slots.size(); ++i)
                if (!found->maps[i].file.empty()) // what the file lacks, such as heights, stays
                    state.slots[i] = found->maps[i];
        });
}

// The materials that parts of the mesh name, when there is a choice.
void MapPanel::showParts(const State& state, const Mesh* mesh)
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

void MapPanel::setEnvironment(const QString& nameOrFile)
{
    m_assets.propose(tr("Environment"), [nameOrFile](State& state) { state.environment = nameOrFile.toStdString(); });
}

void MapPanel::refresh()
{
    const State& state = m_document.state();
    const Resources& loaded = m_assets.resources();
    for (MapRow* line : m_rows)
        line->show(state.slots[std::size_t(line->kind().kind)], loaded.material.get());
    const auto shape = std::find(kShapes.begin(), kShapes.end(), state.mesh);
    m_shapes->setCurrent(shape == kShapes.end() ? -1 : int(shape - kShapes.begin()));
    const bool noMesh = m_assets.missingMesh() && loaded.meshName == state.mesh;
    showFile(*m_meshName, state.mesh, noMesh, "dim");
    m_meshName->setVisible(shape == kShapes.end());
    m_meshFacts->setFullText(noMesh ? tr("a plane stands in") : loaded.mesh ? meshFacts(*loaded.mesh) : QString());
    showParts(state, noMesh ? nullptr : loaded.mesh.get());
    const bool studio = state.environment == "studio";
    showFile(*m_environmentName, studio ? tr("Studio").toStdString() : state.environment,
        m_assets.missingEnvironment() && loaded.environmentName == state.environment, "");
    m_studio->setVisible(!studio);
}

// A panorama dropped on the environment; whatever else is left to the window.
bool MapPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QWidget::eventFilter(watched, event);
    auto* drop = static_cast<QDropEvent*>(event);
    const auto urls = drop->mimeData()->urls();
    if (urls.size() != 1 || !fits(FileKind::Panorama, urls.front().toLocalFile()))
        return false;
    drop->acceptProposedAction();
    if (event->type() == QEvent::Drop)
        setEnvironment(urls.front().toLocalFile());
    return true;
}

} // namespace relievo
