// Assigning maps, mesh and environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/map_panel.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/panels/map_row.h"
#include "app/window/panels/scene_sections.h"
#include "app/window/widgets/dropping.h"
#include "app/window/widgets/painting.h"
#include "app/window/widgets/text.h"
#include "core/gltf/pictures.h"
#include "core/mesh/mesh.h"
#include <QAbstractButton>
#include <QDir>
#include <QFileInfo>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace relievo {
namespace {
constexpr float kLeastPitchOfPlane = 15.f; // degrees

// The line over the maps that the material lacks; a file that is dragged onto it opens it.
class AddMap : public QAbstractButton {
public:
    AddMap()
    {
        setObjectName("add-map");
        setText(MapPanel::tr("Add map"));
        setToolTip(MapPanel::tr("Shows the kinds of map that the material does not have yet"));
        setCheckable(true);
        setAcceptDrops(true);
        setFixedHeight(28);
        setFocusPolicy(Qt::TabFocus);
        setCursor(Qt::PointingHandCursor);
    }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override
    {
        event->ignore(); // a drop here is the window's
        if (!draggedFile(*event).isEmpty())
            setChecked(true);
    }
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }
    void paintEvent(QPaintEvent*) override
    {
        SmoothPainter painter(this);
        relievo::icon(isChecked() ? "down" : "right").paint(&painter, QRect(26, (height() - 12) / 2, 12, 12));
        painter.setPen(underMouse() || hasFocus() ? accent(palette()) : dimText(palette()));
        painter.drawText(rect().adjusted(60, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
    }
};
} // namespace

MapPanel::MapPanel(Document& document, Assets& assets, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_assets(assets)
    , m_mesh(new MeshSection)
    , m_environment(new EnvironmentSection)
{
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* maps = new Section(tr("Maps"));
    addMaps(*maps);
    column->addWidget(m_mesh); // above the maps, whose rows come and go
    column->addWidget(maps);
    column->addWidget(m_environment);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // its coming would move the rest
    scroll->setWidget(content);
    QScrollBar* bar = scroll->verticalScrollBar();
    connect(bar, &QScrollBar::rangeChanged, bar, [bar](int least, int most) { bar->setEnabled(most > least); }); // else nothing is seen
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    connect(m_mesh, &MeshSection::chosen, this, &MapPanel::setMesh);
    connect(m_mesh, &MeshSection::partChosen, this, &MapPanel::choosePart);
    connect(m_environment, &EnvironmentSection::chosen, this, &MapPanel::setEnvironment);
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
    m_lines = section.body();
    m_add = new AddMap;
    m_lines->addWidget(m_add);
    connect(m_add, &QAbstractButton::toggled, this, &MapPanel::arrangeMaps);
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

// The maps that there are, and the heights that most else comes from; the others under a line that shows and hides them.
void MapPanel::arrangeMaps()
{
    const auto stands = [](const MapRow* line) { return line->isFilled() || line->kind().kind == MapKind::Height; };
    QVector<MapRow*> standing, others;
    for (MapRow* line : m_rows)
        (stands(line) ? standing : others).append(line);
    if (standing != m_standing) {
        m_standing = standing;
        m_add->setChecked(false);
        for (MapRow* line : standing + others)
            m_lines->addWidget(line); // again, in this order
        m_lines->insertWidget(int(standing.size()), m_add);
    }
    for (MapRow* line : m_rows)
        line->setVisible(stands(line) || m_add->isChecked());
    m_add->setVisible(!others.isEmpty());
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
        return m_assets.propose(tr("Mesh"), [nameOrFile](State& state) {
            state.mesh = nameOrFile.toStdString(), state.part.clear();
            if (nameOrFile == "plane" && std::abs(state.camera.pitch) < kLeastPitchOfPlane)
                state.camera.pitch = Camera{}.pitch; // nothing is seen from its edge
        });
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
    arrangeMaps();
    const bool noMesh = m_assets.missingMesh() && loaded.meshName == state.mesh;
    m_mesh->show(state, noMesh ? nullptr : loaded.mesh.get(), noMesh);
    m_environment->show(state, m_assets.missingEnvironment() && loaded.environmentName == state.environment);
}

} // namespace relievo
