// The page of the main window: the picture between its panels, messages below; it remembers where the window was and how it was divided.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include <vector>

class QSplitter;

namespace relievo {

class Segmented;

// Where the window is too narrow for a panel on each side, both stand in one column, one at a time.
class Page : public QWidget {
    Q_OBJECT
public:
    // What stands left, in the middle, under it, right and along the bottom. Owned by the page.
    struct Parts {
        QWidget *maps, *picture;
        std::vector<QWidget*> underPicture;
        QWidget *parameters, *messages;
    };
    explicit Page(const Parts& parts, QWidget* parent = nullptr);
    void showPanels(bool on); // on both sides
    bool panelsShown() const { return m_panelsShown; }
    // Between sessions: where the window was, and how the page in it was divided.
    void restore(QWidget& window);
    void save(const QWidget& window) const;
    QSize minimumSizeHint() const override; // of a narrow window, however wide it is now

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    Parts m_parts;
    QSplitter* m_splitter;
    QWidget *m_side, *m_tabLine; // the column on the right, and what chooses the panel in it
    Segmented* m_tabs;
    QByteArray m_wide; // how the splitter stood with three parts
    bool m_isNarrow = false;
    bool m_panelsShown = true;
};

} // namespace relievo
