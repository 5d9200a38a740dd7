// Reading and adding targets of the user's own.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/own_targets.h"
#include "core/exporters/engines/target_text.h"
#include "core/ground/file.h"
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <map>

namespace relievo {
namespace {
struct Known {
    QDateTime changed;
    qint64 size = 0;
    OwnTarget target;
};
} // namespace

QString ownTargetsFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/targets";
}

bool makeOwnTargetsFolder()
{
    return QDir().mkpath(ownTargetsFolder());
}

std::vector<OwnTarget> ownTargets()
{
    static std::map<QString, Known> read;
    std::vector<OwnTarget> all;
    for (const QFileInfo& info : QDir(ownTargetsFolder()).entryInfoList({"*.tpl", "*.json"}, QDir::Files, QDir::Name)) {
        Known& known = read[info.absoluteFilePath()];
        if (known.target.file.isEmpty() || known.changed != info.lastModified() || known.size != info.size()) {
            known = {info.lastModified(), info.size(), {info.absoluteFilePath()}};
            const auto row = ownTarget(info.absoluteFilePath().toStdString());
            if (row)
                known.target.row = *row;
            else
                known.target.fault = QString::fromStdString(message(row.error()));
        }
        all.push_back(known.target);
    }
    return all;
}

QString ownTargetPath(const QString& file)
{
    return QDir(ownTargetsFolder()).filePath(QFileInfo(file).fileName());
}

Expected<QString> addOwnTarget(const QString& file)
{
    const QString to = ownTargetPath(file);
    if (QFileInfo(file).absoluteFilePath() == to)
        return to;
    const auto text = readText(file.toStdString());
    if (!text)
        return tl::unexpected(text.error());
    if (!makeOwnTargetsFolder())
        return failure(ErrorCode::NotWritable, ownTargetsFolder().toStdString(), "the folder cannot be made", "Make it by hand");
    if (const auto written = writeAtomically(to.toStdString(), *text); !written)
        return tl::unexpected(written.error());
    return to;
}

} // namespace relievo
