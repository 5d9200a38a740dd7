// Asking for files and about unsaved work.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/dialogs.h"
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace relievo {
namespace {
struct FileKindRow {
    const char* key;
    const char* label;
    const char* suffixes;
};
constexpr const char* kImages = "png jpg jpeg tif tiff tga bmp exr hdr dds";
constexpr FileKindRow kFileKinds[] = {
    {"source", "Projects, images and materials",
        "relievo png jpg jpeg tif tiff tga bmp exr hdr dds gltf glb obj tres mat material mtlx json babylon"},
    {"project", "Projects", "relievo"},
    {"image", "Images", kImages},
    {"mesh", "Meshes and relief objects", "gltf glb obj ply stl off object.json"},
    {"panorama", "Panoramas", "hdr exr"},
    {"preset", "Presets", "json relievo"},
    {"target", "Targets", "tpl json"},
    {"folder", "Folders", ""},
};
const FileKindRow& rowOf(FileKind kind)
{
    return kFileKinds[std::size_t(kind)];
}

// A chooser that lives until it is answered.
QFileDialog* chooser(QWidget* parent, const QString& title, const QString& key)
{
    auto* dialog = new QFileDialog(parent, title, QSettings().value("folders/" + key).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return dialog;
}
} // namespace

bool fits(FileKind kind, const QString& file)
{
    return QString(rowOf(kind).suffixes).split(' ').contains(QFileInfo(file).suffix().toLower());
}

void askForFile(QWidget* parent, const QString& title, FileKind kind, std::function<void(const QString&)> then)
{
    QFileDialog* dialog = chooser(parent, title, rowOf(kind).key);
    if (kind == FileKind::Folder) {
        dialog->setFileMode(QFileDialog::Directory);
    } else {
        dialog->setFileMode(QFileDialog::ExistingFile);
        dialog->setNameFilters(
            {QString("%1 (*.%2)").arg(rowOf(kind).label, QString(rowOf(kind).suffixes).replace(" ", " *.")), "All files (*)"});
    }
    QObject::connect(dialog, &QFileDialog::fileSelected,
        [kind](const QString& file) { QSettings().setValue(QString("folders/") + rowOf(kind).key, QFileInfo(file).absolutePath()); });
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, std::move(then));
    dialog->open();
}

void rememberSaved(const QString& file)
{
    const QFileInfo saved(file);
    QSettings().setValue("folders/save-" + saved.suffix().toLower(), saved.absolutePath());
}

void askWhereToSave(
    QWidget* parent, const QString& title, const QString& proposal, const QStringList& suffixes, std::function<void(const QString&)> then)
{
    QFileDialog* dialog = chooser(parent, title, "save-" + suffixes.front());
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffixes.front());
    QStringList patterns;
    for (const QString& suffix : suffixes)
        patterns << "*." + suffix;
    dialog->setNameFilters({patterns.join(' ')});
    dialog->selectFile(proposal);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, [parent, suffixes, then = std::move(then)](const QString& file) {
        if (suffixes.contains(QFileInfo(file).suffix(), Qt::CaseInsensitive))
            return then(file);
        const QString whole = file + '.' + suffixes.front(); // the chooser takes the end of "bricks v1.2" for a suffix
        if (QFileInfo::exists(whole))
            askToReplace(parent, whole, [then, whole] { then(whole); });
        else
            then(whole);
    });
    dialog->open();
}

namespace {
QMessageBox* question(QWidget* parent, const char* name, const QString& text, const QString& more)
{
    auto* box = new QMessageBox(parent);
    box->setObjectName(name);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText); // names of files may look like marks
    box->setIcon(QMessageBox::Warning);
    box->setText(text);
    box->setInformativeText(more);
    return box;
}
} // namespace

void askToReplace(QWidget* parent, const QString& path, std::function<void()> then)
{
    const QFileInfo there(path);
    auto* box = question(parent, "replace", QObject::tr("Replace \u201c%1\u201d?").arg(there.fileName()),
        there.isDir() ? QObject::tr("The folder is not empty: files of the same names are written over.")
                      : QObject::tr("The file exists already."));
    QPushButton* replace = box->addButton(QObject::tr("Replace"), QMessageBox::AcceptRole);
    box->setDefaultButton(box->addButton(QMessageBox::Cancel));
    QObject::connect(replace, &QPushButton::clicked, parent, std::move(then));
    box->open();
}

void askForOne(QWidget* parent, const QString& title, const QStringList& lines, std::function<void(qsizetype)> then)
{
    auto* dialog = new QDialog(parent);
    dialog->setObjectName("choose-one");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* list = new QListWidget;
    list->addItems(lines);
    list->setCurrentRow(0);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(list);
    layout->addWidget(buttons);
    QObject::connect(list, &QListWidget::itemActivated, dialog, &QDialog::accept); // double click, Enter
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(dialog, &QDialog::accepted, parent, [list, then = std::move(then)] { then(list->currentRow()); });
    dialog->open();
}

void askToSaveElsewhere(QWidget* parent, const QString& text, std::function<void()> saveAs)
{
    auto* box = question(parent, "save-failed", QObject::tr("The project was not saved."), text);
    box->setIcon(QMessageBox::Critical);
    QPushButton* elsewhere = box->addButton(QObject::tr("Save as..."), QMessageBox::AcceptRole);
    box->setDefaultButton(elsewhere);
    box->addButton(QMessageBox::Cancel);
    QObject::connect(elsewhere, &QPushButton::clicked, parent, std::move(saveAs));
    box->open();
}

void askAboutUnsaved(QWidget* parent, const QString& name, const QString& alsoLost, std::function<void(Answer)> then)
{
    const bool unsaved = !name.isEmpty();
    auto* box = question(parent, "unsaved", unsaved ? QObject::tr("Save the changes to \u201c%1\u201d?").arg(name) : alsoLost,
        unsaved ? (QObject::tr("Without saving they are lost.") + ' ' + alsoLost).trimmed() : QString());
    if (unsaved)
        box->setDefaultButton(box->addButton(QMessageBox::Save));
    QPushButton* discard = box->addButton(QMessageBox::Discard);
    QPushButton* cancel = box->addButton(QMessageBox::Cancel);
    if (!unsaved) {
        discard->setText(QObject::tr("Stop it"));
        box->setDefaultButton(cancel);
    }
    QObject::connect(box, &QMessageBox::finished, parent, [then = std::move(then)](int button) {
        then(button == QMessageBox::Save ? Answer::Save : button == QMessageBox::Discard ? Answer::Discard : Answer::Cancel);
    });
    box->open();
}

} // namespace relievo
