// The panel on the left: the maps of the material, the mesh and the environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include <QVector>
#include <QWidget>

class QComboBox;
class QToolButton;

namespace relievo {

class ElidedLabel;
class MapRow;
class Section;
class Segmented;

class MapPanel : public QWidget {
    Q_OBJECT
public:
    MapPanel(Document& document, Assets& assets, QWidget* parent = nullptr);

    // A file for one slot; "" clears it. The channel and flip begin as the file's name and pixels suggest.
    void assign(MapKind kind, const QString& file);
    // The file of a slot has moved; other missing maps that lie beside it are found too.
    void locate(MapKind kind, const QString& file);
    void setMesh(const QString& nameOrFile);
    void choosePart(const QString& material);
    void setEnvironment(const QString& nameOrFile);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<void(State&)> locateOthers(const QString& file) const; // missing maps that lie beside `file`
    void addMaps(Section& section);
    void addMesh(Section& section);
    void addEnvironment(Section& section);
    void refresh();
    void showParts(const State& state, const Mesh* mesh);
    Document& m_document;
    Assets& m_assets;
    QVector<MapRow*> m_rows;
    Segmented* m_shapes = nullptr;
    QComboBox* m_parts = nullptr;
    ElidedLabel *m_meshName = nullptr, *m_meshFacts = nullptr, *m_environmentName = nullptr;
    QToolButton* m_studio = nullptr;
};

} // namespace relievo
