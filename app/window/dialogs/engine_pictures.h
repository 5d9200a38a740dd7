// Two small pictures of the export dialog: the material here, and as the chosen engine draws what is written for it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>

class QLabel;

namespace relievo {

class ExportForm;
struct ExportChoice;

struct EnginePair {
    QImage ours, engines;
};
// As picture A is seen, `size` pixels each; the engine gets the heights that the choice writes. Makes an OpenGL context for its thread.
// Errors: no context, what cannot be drawn, no technique that stands for the engine, cancelled.
Expected<EnginePair> drawnByBoth(
    const ExportChoice& choice, const State& state, const Resources& resources, QSize size, const Progress& progress = {});

// Drawn in the background while they are seen, when choice, document or camera have changed and the hand rests. Their room stays where
// there are none.
class EnginePictures : public QWidget {
    Q_OBJECT
public:
    EnginePictures(const ExportForm& form, const Document& document, const Assets& assets);
    bool busy() const { return m_rest.isActive() || m_background.busy(); }

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    struct Side {
        QLabel *picture, *caption;
    };
    Side side(const char* name);
    void changed();
    void draw();
    void show(const Expected<EnginePair>& pair, const QString& engine);
    void clear(const QString& why);
    const ExportForm& m_form;
    const Document& m_document;
    const Assets& m_assets;
    Background m_background;
    QTimer m_rest;
    Side m_ours, m_engines;
};

} // namespace relievo
