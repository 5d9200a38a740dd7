// An export at work: in the background, once more when asked, told in the message line while nobody looks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include "core/exporters/exporters.h"
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace relievo {

// What is exported of a document, as which target and where to.
struct ExportChoice {
    const ExportRow* target = &kExports.front();
    QString out; // absolute, with the target's suffix
    int size = 0; // texels; 0: as the maps are
    EnumSet<Cure> cures = {};
    std::shared_ptr<const TargetText> packing = nullptr; // null: the target's own

    // The choice and what is named must outlive the job.
    ExportJob jobOf(const State& state, const Resources& resources, const Progress& progress = {}) const
    {
        return {state, resources, out.toStdString(), size, progress, {}, cures, nullptr, packing.get()};
    }
};

struct ExportEnd {
    ExportChoice choice;
    Expected<Exported> result;
};

class ExportRun : public QObject {
    Q_OBJECT
public:
    ExportRun(const Document& document, const Assets& assets, QObject* parent = nullptr);

    Expected<void> ready() const; // or why nothing can be exported now
    void start(const ExportChoice& choice);
    void stop();
    bool busy() const { return m_background.busy(); }
    const std::optional<ExportChoice>& last() const { return m_last; } // that was written of this document
    void tellInLine(bool on) { m_tellsInLine = on; }

    // The first of what an export writes over that was not written of this document or chosen knowingly, or the folder that it mixes
    // its files into; "" when there is none.
    QString takenBy(const ExportChoice& choice) const;
    void allowReplacing(const QString& path) { m_replaceable.append(path); }

Q_SIGNALS:
    void busyChanged(bool busy);
    void progressed(float share); // [0, 1]
    void ended(const relievo::ExportEnd& end);

private:
    bool mayReplace(const QString& path) const { return m_replaceable.contains(path); }
    void end(const ExportChoice& choice, const Expected<Exported>& result);
    void tellRunning(float share);
    const Document& m_document;
    const Assets& m_assets;
    Background m_background;
    ExportChoice m_running;
    std::optional<ExportChoice> m_last;
    QStringList m_replaceable;
    QTimer m_toldLongEnough; // a success, in the message line
    bool m_tellsInLine = false;
};

void openFolderOf(const ExportChoice& choice); // in the system's file manager

} // namespace relievo
