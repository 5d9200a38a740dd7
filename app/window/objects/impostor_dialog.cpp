// A form of four choices and a folder.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/objects/impostor_dialog.h"
#include "app/window/decide/measuring_run.h"
#include "app/window/dialogs/dialogs.h"
#include "app/window/main_window.h"
#include "app/window/widgets/segmented.h"
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <algorithm>

namespace relievo {
namespace {
constexpr const char* kSettings = "impostor/";
constexpr int kPictureBytes = 6 + 8 + 2; // of normal, colour with alpha and roughness, of a texel

// Beside a mesh file a folder of its name; without one nothing is proposed.
QString proposedFolder(const QString& mesh)
{
    const QFileInfo file(mesh);
    return file.isAbsolute() ? file.dir().filePath(file.completeBaseName() + "-object") : QString();
}
} // namespace

int ImpostorDialog::Choice::value() const
{
    return values[std::size_t(std::max(buttons->current(), 0))];
}

ImpostorDialog::ImpostorDialog(MainWindow& window) : QDialog(&window), m_window(window)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("impostor");
    setWindowTitle(tr("Relief object"));
    auto* form = new QFormLayout(this);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    form->setContentsMargins(20, 20, 20, 16);
    const QString mesh = QString::fromStdString(window.document().state().mesh);
    form->addRow(tr("Mesh"), new QLabel(QFileInfo(mesh).fileName()));
    addChoice(tr("Sides"), "sides", {1, 2, 6}, 6,
        tr("1: the front, which faces +z, solid back to the end of the box. 2: front and back. 6: all sides of the box"));
    addChoice(tr("Layers"), "layers", {1, 2, 4}, 1, tr("Solid stretches along each axis: more hold what lies behind other parts"));
    addChoice(tr("Size"), "size", {128, 256, 512, 1024, 2048}, 512, tr("Texels along each side of a map"));
    addChoice(tr("Rays"), "supersample", {1, 2, 4}, 2, tr("Along each side of a texel: smoother colors, and thin parts are kept"));
    auto* place = new QHBoxLayout;
    m_folder = new QLineEdit(proposedFolder(mesh));
    m_folder->setObjectName("folder");
    m_folder->setMinimumWidth(320);
    m_folder->setPlaceholderText(tr("Folder to write to"));
    auto* browse = new QPushButton(tr("Browse..."));
    browse->setAutoDefault(false);
    place->addWidget(m_folder);
    place->addWidget(browse);
    form->addRow(tr("Folder"), place);
    m_hint = new QLabel;
    m_hint->setProperty("role", "dim");
    form->addRow({}, m_hint);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_bake = buttons->addButton(tr("Bake"), QDialogButtonBox::AcceptRole);
    m_bake->setDefault(true);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImpostorDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_folder, &QLineEdit::textChanged, this, &ImpostorDialog::tellSize);
    connect(browse, &QPushButton::clicked, this, [this] {
        askForFile(this, tr("Folder of the relief object"), FileKind::Folder, [this](const QString& chosen) { m_folder->setText(chosen); });
    });
    tellSize();
}

Segmented* ImpostorDialog::addChoice(
    const QString& label, const QString& key, const std::vector<int>& values, int usual, const QString& tip)
{
    QVector<Segmented::Item> items;
    for (const int value : values)
        items.append({QString::number(value), tip, {}});
    auto* buttons = new Segmented(items);
    buttons->setObjectName(key);
    buttons->setToolTip(tip);
    const auto kept = std::ranges::find(values, QSettings().value(kSettings + key, usual).toInt());
    buttons->setCurrent(int((kept == values.end() ? std::ranges::find(values, usual) : kept) - values.begin()));
    connect(buttons, &Segmented::chosen, this, [this, buttons](int index) {
        buttons->setCurrent(index);
        tellSize();
    });
    m_choices.push_back({key, values, buttons});
    static_cast<QFormLayout*>(layout())->addRow(label, buttons);
    return buttons;
}

QStringList ImpostorDialog::options() const
{
    QStringList options;
    for (const Choice& choice : m_choices)
        options << "--" + choice.key << QString::number(choice.value());
    return options;
}

void ImpostorDialog::tellSize()
{
    if (!m_hint || !m_bake)
        return;
    const qint64 sides = m_choices[0].value(), layers = m_choices[0].value() == 1 ? 1 : m_choices[1].value(), size = m_choices[2].value();
    const double mebibytes = double(sides * size * size * (2 * layers + kPictureBytes)) / double(1 << 20);
    m_hint->setText(tr("%1 maps of %2 x %2 texels, about %3 MiB before they are packed")
                        .arg(sides * (layers + 3))
                        .arg(size)
                        .arg(mebibytes, 0, 'f', mebibytes < 10. ? 1 : 0));
    m_bake->setEnabled(!m_folder->text().trimmed().isEmpty());
}

void ImpostorDialog::accept()
{
    for (const Choice& choice : m_choices)
        QSettings().setValue(kSettings + choice.key, choice.value());
    measuringOf(m_window).start(Action::Impostor, m_folder->text().trimmed(), options());
    QDialog::accept();
}

void askForImpostor(MainWindow& window)
{
    if (isObjectName(window.document().state().mesh))
        return window.messages().set("measuring",
            QList<Message>{
                {.isError = true, .text = QObject::tr("This is a relief object already: choose the mesh that it was baked from.")}});
    (new ImpostorDialog(window))->open();
}

} // namespace relievo
