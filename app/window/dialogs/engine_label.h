// One sentence of the export dialog: what the chosen engine will draw of the material.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include <QLabel>
#include <QTimer>

namespace relievo {

class ExportForm;

// Measured in the background while it is seen, when target or document have changed and the hand rests. Empty where no engine draws.
class EngineLabel : public QLabel {
    Q_OBJECT
public:
    EngineLabel(const ExportForm& form, const Document& document, const Assets& assets);

protected:
    void showEvent(QShowEvent*) override;

private:
    void measure();
    const ExportForm& m_form;
    const Document& m_document;
    const Assets& m_assets;
    Background m_background;
    QTimer m_rest;
};

} // namespace relievo
