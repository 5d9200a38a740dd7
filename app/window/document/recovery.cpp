// Copies of unsaved work.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/recovery.h"
#include "core/ground/shown_text.h"
#include <QAbstractButton>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QMessageBox>
#include <QStandardPaths>

namespace relievo {
namespace {
constexpr int kWait = 3000; // ms from a change to the copy

bool runs(const QString& process)
{
    if (process == QString::number(QCoreApplication::applicationPid()))
        return true;
    QFile stat("/proc/" + process + "/stat"); // "PID (name) state ..."; the name may hold brackets
    if (!stat.open(QIODevice::ReadOnly))
        return false;
    const QByteArray text = stat.readAll();
    const bool hasEnded = text.mid(text.lastIndexOf(')') + 2, 1) == "Z"; // its parent has not asked yet
    return !hasEnded && text.mid(text.indexOf('(') + 1).startsWith("relievo");
}

QString projectNameFile(const QString& copy)
{
    return copy + ".project";
}

void removeCopy(const QString& copy)
{
    QFile::remove(copy);
    QFile::remove(projectNameFile(copy));
}

QString projectOf(const QString& copy)
{
    QFile name(projectNameFile(copy));
    return name.open(QIODevice::ReadOnly) ? QString::fromUtf8(name.readAll()) : QString();
}
} // namespace

QString recoveryFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/unsaved";
}

Recovery::Recovery(Document& document, const QString& folder)
    : m_document(document)
    , m_file(QDir(folder).filePath(QString("%1.relievo").arg(QCoreApplication::applicationPid())))
{
    m_wait.setSingleShot(true);
    m_wait.setInterval(kWait);
    connect(&m_wait, &QTimer::timeout, this, &Recovery::write);
    connect(&document, &Document::changed, this, &Recovery::documentChanged);
    connect(&document, &Document::titleChanged, this, &Recovery::documentChanged);
}

Recovery::~Recovery()
{
    removeCopy(m_file);
}

void Recovery::documentChanged()
{
    if (m_document.isModified()) {
        if (!m_wait.isActive())
            m_wait.start();
        return;
    }
    m_wait.stop();
    removeCopy(m_file);
}

// A copy that cannot be written is no reason to disturb: saving the project would tell.
void Recovery::write()
{
    if (!QDir().mkpath(QFileInfo(m_file).path()))
        return;
    QFile name(projectNameFile(m_file));
    if (name.open(QIODevice::WriteOnly))
        name.write(m_document.file().toUtf8());
    (void)writeState(m_document.state(), m_file.toStdString());
}

std::optional<LeftBehind> leftBehind(const QString& folder)
{
    for (const QFileInfo& copy : QDir(folder).entryInfoList({"*.relievo"}, QDir::Files, QDir::Time)) {
        if (runs(copy.completeBaseName()))
            continue;
        if (auto read = readState(State{}, copy.filePath().toStdString()))
            return LeftBehind{copy.filePath(), std::move(*read), projectOf(copy.filePath())};
    }
    return {};
}

void restore(MainWindow& window, const LeftBehind& copy)
{
    Document* document = &window.document();
    QObject::connect(
        document, &Document::started, document,
        [document, file = copy.file, wanted = copy.read.state] {
            if (document->state() != wanted)
                return; // it could not be opened, and something else was: the copy waits for the next start
            document->undoStack().resetClean(); // unsaved: it asks before it is lost again
            removeCopy(file);
        },
        Qt::SingleShotConnection);
    window.assets().openState(copy.read.state, copy.read.warnings, copy.project);
}

void offerLeftBehind(MainWindow& window, const QString& folder)
{
    const std::optional<LeftBehind> copy = leftBehind(folder);
    if (!copy)
        return;
    const QString when = QLocale().toString(QFileInfo(copy->file).lastModified(), QLocale::ShortFormat);
    auto* question = new QMessageBox(QMessageBox::NoIcon, QObject::tr("Unsaved work"),
        QObject::tr("Relievo ended before \"%1\" was saved (%2).").arg(QString::fromStdString(shownName(copy->read.state.name)), when),
        QMessageBox::NoButton, &window);
    question->setObjectName("left-behind");
    question->setAttribute(Qt::WA_DeleteOnClose);
    QAbstractButton* restored = question->addButton(QObject::tr("Restore"), QMessageBox::AcceptRole);
    QAbstractButton* discarded = question->addButton(QObject::tr("Discard"), QMessageBox::DestructiveRole);
    question->addButton(QObject::tr("Not now"), QMessageBox::RejectRole); // what Escape presses; without it the box hears none
    QObject::connect(question, &QMessageBox::buttonClicked, &window, [&window, copy = *copy, restored, discarded](QAbstractButton* button) {
        if (button == restored)
            restore(window, copy);
        else if (button == discarded)
            removeCopy(copy.file);
    });
    question->open();
}

} // namespace relievo
