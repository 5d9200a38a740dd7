// The panel on the left: the maps of the material, the mesh and the environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/assets.h"
#include <QVector>
#include <QWidget>

class QAbstractButton;
class QVBoxLayout;

namespace relievo {

class EnvironmentSection;
class MapRow;
class MeshSection;
class Section;

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

private:
    std::function<void(State&)> locateOthers(const QString& file) const; // missing maps that lie beside `file`
    void addMaps(Section& section);
    void arrangeMaps();
    void refresh();
    Document& m_document;
    Assets& m_assets;
    QVector<MapRow*> m_rows, m_standing; // all, and those that are always in view
    QAbstractButton* m_add; // shows and hides the others
    QVBoxLayout* m_lines;
    MeshSection* m_mesh;
    EnvironmentSection* m_environment;
};

} // namespace relievo
