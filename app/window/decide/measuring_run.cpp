// Running `relievo compare`, `relievo report` and `relievo impostor`.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/measuring_run.h"
#include "app/window/decide/live_sweep.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/document/files.h"
#include "app/window/main_window.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/number_field.h"
#include "core/state/state_json.h"
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>

namespace relievo {
namespace {
constexpr int kToldFor = 30000; // ms that a success stands in the message line

struct KindRow {
    const char *command, *title, *doing, *name;
    QStringList suffixes;
};
const KindRow& rowOf(Action kind)
{
    static const KindRow sheet{"compare", QT_TRANSLATE_NOOP("MeasuringRun", "Contact sheet"),
        QT_TRANSLATE_NOOP("MeasuringRun", "Drawing the contact sheet"), "sheet", {"png"}};
    static const KindRow report{"report", QT_TRANSLATE_NOOP("MeasuringRun", "Report"),
        QT_TRANSLATE_NOOP("MeasuringRun", "Measuring for the report"), "report", {"html", "csv", "json"}};
    static const KindRow object{"impostor", QT_TRANSLATE_NOOP("MeasuringRun", "Relief object"),
        QT_TRANSLATE_NOOP("MeasuringRun", "Baking the relief object"), "", {}};
    return kind == Action::ContactSheet ? sheet : kind == Action::Report ? report : object;
}

QString text(const char* of)
{
    return QCoreApplication::translate("MeasuringRun", of);
}

void open(const QString& file)
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(file));
}

// The project of the object that was written last.
QString projectIn(const QString& folder)
{
    const QFileInfoList objects = QDir(folder).entryInfoList({"*.object.json"}, QDir::Files, QDir::Time);
    return objects.isEmpty() ? QString() : objects.front().filePath().chopped(int(kObjectSuffix.size())) + ".relievo";
}
} // namespace

MeasuringRun& measuringOf(MainWindow& window)
{
    auto* run = window.findChild<MeasuringRun*>();
    return run ? *run : *new MeasuringRun(window);
}

MeasuringRun::MeasuringRun(MainWindow& window) : QObject(&window), m_window(window)
{
    m_toldLongEnough.setSingleShot(true);
    m_toldLongEnough.setInterval(kToldFor);
    connect(&m_toldLongEnough, &QTimer::timeout, this, [this] { m_window.messages().clear("measuring"); });
}

void MeasuringRun::ask(Action kind)
{
    commitTyping(&m_window);
    const KindRow& row = rowOf(kind);
    const QString proposal = QString("%1-%2.%3").arg(m_window.document().name(), QString(row.name), row.suffixes.front());
    askWhereToSave(&m_window, text(row.title), proposal, row.suffixes, [this, kind](const QString& out) { start(kind, out); });
}

void MeasuringRun::start(Action kind, const QString& out, const QStringList& more)
{
    if (busy())
        stop();
    m_toldLongEnough.stop();
    m_kind = kind;
    m_out = out;
    m_said.clear();
    m_folder = std::make_unique<QTemporaryDir>();
    State state = ofPane(m_window.document().state(), std::size_t(m_window.viewport().activePane()));
    state.name = m_window.document().name().toStdString();
    QString subject = m_folder->filePath("measured.relievo");
    if (kind == Action::Impostor)
        subject = QString::fromStdString(state.mesh);
    else if (const auto written = writeState(state, subject.toStdString()); !written)
        return end(false, QString::fromStdString(message(written.error())));
    m_process = new QProcess(this);
    m_process->setStandardOutputFile(QProcess::nullDevice());
    connect(m_process, &QProcess::readyReadStandardError, this, &MeasuringRun::read);
    connect(m_process, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
        read();
        const bool done = status == QProcess::NormalExit && code == 0;
        end(done, m_said.trimmed().isEmpty() ? tr("The program that measures has ended early.") : m_said.trimmed());
    });
    connect(m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            end(false, tr("%1 cannot be started. Install it beside the editor.").arg(QDir::toNativeSeparators(m_process->program())));
    });
    tellProgress(0);
    m_process->start(
        QCoreApplication::applicationDirPath() + "/relievo", QStringList{rowOf(kind).command, subject, "-o", out, "--progress"} + more);
}

// "\r 42 %" while it works, lines when it has something to say.
void MeasuringRun::read()
{
    static const QRegularExpression percent("\\r *(\\d+) %\\n?");
    QString said = QString::fromUtf8(m_process->readAllStandardError());
    int last = -1;
    for (auto found = percent.globalMatch(said); found.hasNext();)
        last = found.next().captured(1).toInt();
    m_said += said.remove(percent).remove("relievo: error: ");
    if (last >= 0)
        tellProgress(last);
}

void MeasuringRun::tellProgress(int percent)
{
    const QString doing = tr("%1: %2 %").arg(text(rowOf(m_kind).doing)).arg(percent);
    m_window.messages().set("measuring", QList<Message>{{.text = doing, .isNotice = true, .choices = {{tr("Stop"), [this] { stop(); }}}}});
}

void MeasuringRun::stop()
{
    if (!busy())
        return;
    m_process->disconnect(this);
    m_process->kill(); // it writes its file at once in the end, or not at all
    m_process->waitForFinished(1000);
    m_window.messages().clear("measuring");
    end(false, {});
}

void MeasuringRun::end(bool written, const QString& why)
{
    if (m_process)
        m_process->deleteLater();
    m_process = nullptr;
    m_folder.reset();
    if (written) {
        const bool isObject = m_kind == Action::Impostor;
        const QString told = tr("%1 written to %2.").arg(text(rowOf(m_kind).title), QDir::toNativeSeparators(m_out));
        const auto show = [this, isObject, out = m_out] { isObject ? m_window.files().open(projectIn(out)) : open(out); };
        m_window.messages().set("measuring", QList<Message>{{.text = told, .isNotice = true, .choices = {{tr("Open"), show}}}});
        m_toldLongEnough.start();
        if (!isObject) {
            rememberSaved(m_out);
            open(m_out);
        }
    } else if (!why.isEmpty()) {
        m_window.messages().set("measuring", QList<Message>{{.isError = true, .text = why}});
    }
    Q_EMIT ended(written);
}

} // namespace relievo
