// Asking for files and about unsaved work.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs.h"
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

namespace relievo {
namespace {
struct FileKindRow {
    const char* key;
    const char* label;
    const char* suffixes;
};
constexpr const char* kImages = "png jpg jpeg tif tiff tga bmp exr hdr dds";
constexpr FileKindRow kFileKinds[] = {
    {"source", "Projects and images", "relievo png jpg jpeg tif tiff tga bmp exr hdr dds"},
    {"project", "Projects", "relievo"},
    {"image", "Images", kImages},
    {"mesh", "Meshes", "gltf glb obj ply stl off"},
    {"panorama", "Panoramas", "hdr exr"},
    {"preset", "Presets", "json relievo"},
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
    QObject::connect(dialog, &QFileDialog::fileSelected,
        [key](const QString& file) { QSettings().setValue("folders/" + key, QFileInfo(file).absolutePath()); });
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
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, std::move(then));
    dialog->open();
}

void askWhereToSave(
    QWidget* parent, const QString& title, const QString& proposal, const QString& suffix, std::function<void(const QString&)> then)
{
    QFileDialog* dialog = chooser(parent, title, "save-" + suffix);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->setNameFilters({QString("*.%1").arg(suffix)});
    dialog->selectFile(proposal);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, std::move(then));
    dialog->open();
}

void askAboutUnsaved(QWidget* parent, const QString& name, std::function<void(Answer)> then)
{
    auto* question = new QMessageBox(parent);
    question->setObjectName("unsaved");
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setText(QObject::tr("Save the changes to \u201c%1\u201d?").arg(name));
    question->setInformativeText(QObject::tr("Without saving they are lost."));
    question->setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    question->setDefaultButton(QMessageBox::Save);
    QObject::connect(question, &QMessageBox::finished, parent, [then = std::move(then)](int button) {
        then(button == QMessageBox::Save ? Answer::Save : button == QMessageBox::Discard ? Answer::Discard : Answer::Cancel);
    });
    question->open();
}

} // namespace relievo
