// Starting, stopping and telling of exports.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_run.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/widgets/text.h"
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

namespace relievo {
namespace {
constexpr int kToldFor = 30000; // ms that a success stands in the message line
}

ExportRun::ExportRun(const Document& document, const Assets& assets, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_assets(assets)
    , m_background(this)
{
    m_toldLongEnough.setSingleShot(true);
    m_toldLongEnough.setInterval(kToldFor);
    connect(&m_toldLongEnough, &QTimer::timeout, this, [this] { m_assets.messages().clear("export"); });
    connect(&m_background, &Background::busyChanged, this, &ExportRun::busyChanged);
    connect(&m_background, &Background::progressed, this, [this](float share) {
        if (m_tellsInLine)
            tellRunning(share);
        Q_EMIT progressed(share);
    });
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        end(m_running, failure(m_running.out.toStdString(), what.toStdString(), "Nothing usable was written"));
    });
    connect(&document, &Document::started, this, [this] {
        m_last.reset();
        m_replaceable.clear();
        m_assets.messages().clear("export");
    });
}

Expected<void> ExportRun::ready() const
{
    if (!m_assets.ready() || !m_assets.upToDate())
        return failure(ErrorCode::NotReady, m_document.name().toStdString(), "its files are not loaded",
            "Wait until they are, or clear what is missing");
    if (m_assets.missingMesh() && !m_assets.missingMesh()->asBefore) // what would be written is as deep as the mesh is large
        return failure(ErrorCode::NotFound, m_document.state().mesh, "this mesh is not there, and its size decides the depth in metres",
            "Put it back, or choose another one");
    return {};
}

QString ExportRun::takenBy(const ExportChoice& choice) const
{
    const QFileInfo out(choice.out);
    if (mayReplace(choice.out) && out.isDir())
        return {};
    if (out.isDir() && !QDir(choice.out).isEmpty())
        return choice.out;
    for (const std::filesystem::path& file : choice.target->writes(choice.jobOf(m_document.state(), m_assets.resources())))
        if (const QString path = QString::fromStdString(file.string()); QFileInfo::exists(path) && !mayReplace(path))
            return path;
    return {};
}

void ExportRun::start(const ExportChoice& choice)
{
    for (const auto& file : choice.target->writes(choice.jobOf(m_document.state(), m_assets.resources())))
        allowReplacing(QString::fromStdString(file.string()));
    allowReplacing(choice.out);
    m_assets.messages().clear("export");
    m_toldLongEnough.stop();
    m_running = choice;
    m_background.start([this, choice, state = m_document.state(), resources = m_assets.resources(),
                           project = m_document.file().toStdString()](const Progress& progress) -> Background::Then {
        ExportJob job = choice.jobOf(state, resources, progress);
        job.alsoRead = {project};
        const auto result = choice.target->run(job);
        return [this, choice, result] { end(choice, result); };
    });
    if (m_tellsInLine)
        tellRunning(0.f);
}

void ExportRun::stop()
{
    m_background.cancel();
    end(m_running,
        failure(ErrorCode::Cancelled, m_running.out.toStdString(), "the export was stopped",
            "Files that it had written by then are still there"));
}

void ExportRun::tellRunning(float share)
{
    const QString text = tr("Exporting for %1: %2 %").arg(qt(m_running.target->label)).arg(int(share * 100.f));
    m_assets.messages().set("export", QList<Message>{{.text = text, .isNotice = true, .choices = {{tr("Stop"), [this] { stop(); }}}}});
}

void ExportRun::end(const ExportChoice& choice, const Expected<Exported>& result)
{
    Messages& messages = m_assets.messages();
    if (result) {
        m_last = choice;
        rememberSaved(choice.out);
    }
    if (m_tellsInLine && result) {
        const QString text = tr("Exported to %1.").arg(QDir::toNativeSeparators(choice.out));
        messages.set("export",
            QList<Message>{{.text = text, .isNotice = true, .choices = {{tr("Open folder"), [choice] { openFolderOf(choice); }}}}});
        m_toldLongEnough.start();
    } else if (m_tellsInLine) {
        messages.set("export", result.error());
    }
    Q_EMIT ended({choice, result});
}

void openFolderOf(const ExportChoice& choice)
{
    const QFileInfo out(choice.out);
    QDesktopServices::openUrl(QUrl::fromLocalFile(out.isDir() ? out.absoluteFilePath() : out.absolutePath()));
}

} // namespace relievo
