// Opening, saving and asking before work is lost.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/files.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/document/recent_files.h"
#include "app/window/document/starting_scene.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/text.h"
#include "core/ground/shown_text.h"
#include "core/image/samples/samples.h"
#include "core/image/sets/texture_set.h"
#include "core/scene/materials/material_file.h"
#include "core/scene/source.h"
#include "core/state/presets.h"
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QWidget>

namespace relievo {
namespace {
constexpr qint64 kMostText = 16 << 20; // bytes that are searched

// Whether a glTF file names pictures, by the beginning of its JSON; nothing of it is loaded.
bool bringsPictures(const QString& file)
{
    const QString suffix = QFileInfo(file).suffix().toLower();
    QFile in(file);
    return (suffix == "glb" || suffix == "gltf") && in.open(QIODevice::ReadOnly) && in.read(kMostText).contains("\"images\"");
}
} // namespace

Files::Files(Document& document, Assets& assets, Messages& messages, QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_assets(assets)
    , m_messages(messages)
    , m_window(window)
{
    connect(&document, &Document::started, this, [this] { m_messages.clear("dropped"); });
    m_assets.askFirst = [this](std::function<void()> then) { guard(std::move(then)); };
}

void Files::guard(std::function<void()> then, const QString& alsoLost)
{
    commitTyping(m_window);
    if (!unsaved() && alsoLost.isEmpty())
        return then();
    askAboutUnsaved(m_window, unsaved() ? m_document.name() : QString(), alsoLost, [this, then](Answer answer) {
        if (answer == Answer::Save)
            return save(then);
        if (answer == Answer::Cancel)
            return;
        m_assets.dropChanges();
        then();
    });
}

bool Files::unsaved() const
{
    return m_document.isModified() || m_assets.changesPending();
}

void Files::startNew()
{
    guard([this] { m_assets.openDocument(kStartingSource, startingScene()); });
}

void Files::ask()
{
    askForFile(m_window, tr("Open"), FileKind::Source, [this](const QString& file) { open(file); });
}

void Files::askFolder()
{
    askForFile(m_window, tr("Open the texture set of a folder"), FileKind::Folder, [this](const QString& folder) { open(folder); });
}

void Files::open(const QString& source)
{
    chooseSet(source, [this](const QString& chosen) { guard([this, chosen] { m_assets.openDocument(chosen); }); });
}

void Files::chooseSet(const QString& source, const std::function<void(const QString&)>& then)
{
    const std::vector<SetInFolder> sets = QFileInfo(source).isDir() ? setsIn(source.toStdString()) : std::vector<SetInFolder>();
    if (sets.size() < 2)
        return then(source);
    QStringList titles;
    for (const SetInFolder& set : sets)
        titles << QString::fromStdString(shownName(set.title));
    askForOne(m_window, tr("Sets in %1").arg(QFileInfo(source).fileName()), titles,
        [this, sets, then](qsizetype chosen) { chooseSet(QString::fromStdString(sets.at(std::size_t(chosen)).source.string()), then); });
}

void Files::save(std::function<void()> then)
{
    commitTyping(m_window);
    if (m_document.file().isEmpty())
        saveAs(std::move(then));
    else
        saveTo(m_document.file(), then);
}

void Files::saveAs(std::function<void()> then)
{
    commitTyping(m_window);
    const QString proposal = m_document.file().isEmpty() ? m_document.name() + ".relievo" : m_document.file();
    askWhereToSave(m_window, tr("Save the project"), proposal, {"relievo"}, [this, then](const QString& file) { saveTo(file, then); });
}

void Files::saveTo(const QString& file, const std::function<void()>& then)
{
    if (m_assets.changesPending()) { // what was asked for before belongs to what is saved
        connect(
            &m_assets, &Assets::changesEnded, this, [this, file, then](bool all) { saveTo(file, all ? then : nullptr); },
            Qt::SingleShotConnection);
        return;
    }
    if (const auto saved = m_document.save(file); !saved) {
        m_messages.set("save", saved.error());
        return askToSaveElsewhere(m_window, QString::fromStdString(message(saved.error())), [this, then] { saveAs(then); });
    }
    m_messages.clear("save");
    addRecentFile(QFileInfo(file).absoluteFilePath());
    rememberSaved(file);
    if (then)
        then();
}

void Files::takeMesh(const QString& file)
{
    m_assets.propose(tr("Mesh"), [file, located = m_assets.locatesMesh(file)](State& state) {
        state.mesh = file.toStdString();
        if (!located)
            state.part.clear();
    });
}

void Files::askWhatToTake(const QString& gltf)
{
    const auto choice = [this](const QString& label, const std::function<void()>& take) {
        return Offer{label, [this, take] {
                         m_messages.clear("dropped");
                         take();
                     }};
    };
    m_messages.set("dropped",
        QList<Message>{{.text = tr("Take material and mesh of %1, or one of them?").arg(QFileInfo(gltf).fileName()),
            .isNotice = true,
            .choices = {choice(tr("Both"), [this, gltf] { m_assets.openInto(gltf); }),
                choice(tr("Material"), [this, gltf] { m_assets.openInto(gltf, true); }),
                choice(tr("Mesh"), [this, gltf] { takeMesh(gltf); })}}});
}

void Files::openDropped(const QString& dropped)
{
    m_messages.clear("dropped");
    if (isMeshFile(dropped.toStdString()))
        m_assets.locatesMesh(dropped) || !bringsPictures(dropped) ? takeMesh(dropped) : askWhatToTake(dropped);
    else if (isProjectFile(dropped.toStdString()))
        open(dropped);
    else if (fits(FileKind::Preset, dropped) && !readMaterialFile(dropped.toStdString(), State()))
        applyPreset(dropped.toStdString());
    else
        chooseSet(dropped, [this](const QString& chosen) { m_assets.openInto(chosen); });
}

void Files::fillRecent(QMenu& menu)
{
    for (const QString& source : recentFiles()) {
        QAction* action = menu.addAction(QDir::toNativeSeparators(source));
        action->setEnabled(QFileInfo::exists(source));
        connect(action, &QAction::triggered, this, [this, source] { open(source); });
    }
    if (menu.isEmpty())
        menu.addAction(tr("Nothing yet"))->setEnabled(false);
}

void Files::fillSamples(QMenu& menu)
{
    for (const SampleRow& row : kSamples) {
        QAction* action = menu.addAction(qt(row.label));
        action->setToolTip(qt(row.help));
        connect(action, &QAction::triggered, this, [this, key = row.key] { m_assets.openInto("sample:" + qt(key)); });
    }
}

void Files::fillPresets(QMenu& menu)
{
    for (const PresetRow& row : kPresets) {
        QAction* action = menu.addAction(qt(row.label));
        action->setToolTip(qt(row.help));
        if (!row.sample.empty()) { // relievo render --all-scenes --size 96x72 has made it
            action->setIcon(QIcon(":/resources/scenes/" + qt(row.key) + ".png"));
            action->setIconVisibleInMenu(true);
        }
        connect(action, &QAction::triggered, this, [this, &row] {
            if (row.sample.empty())
                applyPreset(std::string(row.key));
            else
                open("scene:" + qt(row.key));
        });
    }
    menu.addSeparator();
    connect(menu.addAction(tr("From file...")), &QAction::triggered, this,
        [this] { askForFile(m_window, tr("Preset"), FileKind::Preset, [this](const QString& file) { applyPreset(file.toStdString()); }); });
}

void Files::applyPreset(const std::string& nameOrFile)
{
    const auto read = readPreset(m_document.state(), nameOrFile);
    if (!read)
        return m_messages.set("preset", read.error());
    m_messages.set("preset", read->warnings);
    // A preset holds numbers and a technique; what it says of files stays out of it.
    m_document.edit(tr("Preset"), [&](State& state) {
        state.parameters = read->state.parameters;
        state.panes.front().technique = read->state.panes.front().technique;
        state.panes.front().overrides = read->state.panes.front().overrides;
    });
    m_document.endGesture();
}

} // namespace relievo
