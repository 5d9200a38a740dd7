// Asking how a mesh is baked to a relief object.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDialog>

class QLineEdit;
class QPushButton;
class QLabel;

namespace relievo {

class MainWindow;
class Segmented;

// The options of `relievo impostor`; what is chosen stays for the next time. Bakes by MeasuringRun when it is accepted.
class ImpostorDialog : public QDialog {
    Q_OBJECT
public:
    explicit ImpostorDialog(MainWindow& window);
    QStringList options() const; // of the command, but for the folder
    void accept() override;

private:
    Segmented* addChoice(const QString& label, const QString& key, const std::vector<int>& values, int usual, const QString& tip);
    void tellSize(); // and whether it can be baked

    MainWindow& m_window;
    struct Choice {
        QString key;
        std::vector<int> values;
        Segmented* buttons = nullptr;
        int value() const;
    };
    std::vector<Choice> m_choices; // sides, layers, size, supersample
    QLineEdit* m_folder = nullptr;
    QLabel* m_hint = nullptr;
    QPushButton* m_bake = nullptr;
};

// Tells why when the mesh cannot be baked.
void askForImpostor(MainWindow& window);

} // namespace relievo
