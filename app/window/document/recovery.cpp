// Copies of unsaved work.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/recovery.h"
#include "core/ground/file.h"
#include "core/ground/shown_text.h"
#include <QAbstractButton>
#include <QDateTime>
#include <QDir>
#include <QMessageBox>
#include <QStandardPaths>
#include <QUuid>

namespace relievo {
namespace {
constexpr int kWait = 3000; // ms from a change to the copy

QString projectNameFile(const QString& copy)
{
    return copy + ".project";
}

QString lockFile(const QString& copy)
{
    return copy + ".lock";
}

void removeCopy(const QString& copy, QLockFile& lock)
{
    QFile::remove(copy);
    QFile::remove(projectNameFile(copy));
    lock.unlock();
}

// The lock of a copy that no program keeps any more. Whether one does is asked of the system, which lets go of a lock when its holder ends:
// process numbers are used again, at once in a container.
std::shared_ptr<QLockFile> claim(const QString& copy)
{
    auto lock = std::make_shared<QLockFile>(lockFile(copy));
    lock->setStaleLockTime(0);
    if (QFile::exists(lockFile(copy)) && !lock->removeStaleLockFile())
        return nullptr;
    return lock->tryLock(0) ? lock : nullptr;
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
    , m_file(QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + ".relievo"))
    , m_lock(lockFile(m_file))
{
    m_lock.setStaleLockTime(0);
    m_wait.setSingleShot(true);
    m_wait.setInterval(kWait);
    connect(&m_wait, &QTimer::timeout, this, &Recovery::write);
    connect(&document, &Document::changed, this, &Recovery::documentChanged);
    connect(&document, &Document::titleChanged, this, &Recovery::documentChanged);
}

Recovery::~Recovery()
{
    forget();
}

void Recovery::forget()
{
    if (m_lock.isLocked())
        removeCopy(m_file, m_lock);
}

void Recovery::documentChanged()
{
    if (m_document.isModified()) {
        if (!m_wait.isActive())
            m_wait.start();
        return;
    }
    m_wait.stop();
    forget();
}

// A copy that cannot be written is no reason to disturb: saving the project would tell.
void Recovery::write()
{
    if (!QDir().mkpath(QFileInfo(m_file).path()))
        return;
    if (!m_lock.isLocked() && !m_lock.tryLock(0))
        return;
    (void)writeAtomically(projectNameFile(m_file).toStdString(), m_document.file().toStdString());
    (void)writeState(m_document.state(), m_file.toStdString());
}

std::optional<LeftBehind> leftBehind(const QString& folder)
{
    for (const QFileInfo& copy : QDir(folder).entryInfoList({"*.relievo"}, QDir::Files, QDir::Time)) {
        auto lock = claim(copy.filePath());
        if (!lock)
            continue;
        if (auto read = readState(State{}, copy.filePath().toStdString()))
            return LeftBehind{copy.filePath(), std::move(*read), projectOf(copy.filePath()), std::move(lock)};
    }
    return {};
}

void restore(MainWindow& window, const LeftBehind& copy)
{
    Document* document = &window.document();
    QObject::connect(
        document, &Document::started, document,
        [document, file = copy.file, lock = copy.lock, wanted = copy.read.state] {
            if (document->state() != wanted)
                return; // it could not be opened, and something else was: the copy waits for the next start
            document->undoStack().resetClean(); // unsaved: it asks before it is lost again
            removeCopy(file, *lock);
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
    question->setTextFormat(Qt::PlainText);
    question->setObjectName("left-behind");
    question->setAttribute(Qt::WA_DeleteOnClose);
    QAbstractButton* restored = question->addButton(QObject::tr("Restore"), QMessageBox::AcceptRole);
    QAbstractButton* discarded = question->addButton(QObject::tr("Discard"), QMessageBox::DestructiveRole);
    question->addButton(QObject::tr("Not now"), QMessageBox::RejectRole); // what Escape presses; without it the box hears none
    QObject::connect(question, &QMessageBox::buttonClicked, &window, [&window, copy = *copy, restored, discarded](QAbstractButton* button) {
        if (button == restored)
            restore(window, copy);
        else if (button == discarded)
            removeCopy(copy.file, *copy.lock);
    });
    question->open();
}

} // namespace relievo
