// How different two pictures look: the map of FLIP, computed off the interface's thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/background.h"
#include "core/image/image.h"
#include <QObject>
#include <memory>
#include <optional>

namespace relievo {

struct FlipPicture {
    Image heat; // RGBA U8, row 0 at the top: the colours of heat maps, 0 to 1
    double mean = 0., most = 0.; // over all pixels
};

class FlipMap : public QObject {
    Q_OBJECT
public:
    explicit FlipMap(QObject* parent = nullptr);

    // Of the first picture as the reference; both RGBA U8, of one size. What is being computed is dropped.
    void want(Image reference, Image test);
    void forget(); // the pictures have changed
    const FlipPicture* picture() const { return m_made.get(); } // null while there is none
    bool busy() const { return m_background.busy(); }

Q_SIGNALS:
    void made();

private:
    Background m_background;
    std::shared_ptr<const FlipPicture> m_made;
};

} // namespace relievo
