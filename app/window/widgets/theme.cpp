// Palettes, the style sheet and tinted icons.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/theme.h"
#include "app/window/widgets/own_icons.h"
#include "app/window/widgets/text.h"
#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSettings>
#include <QStyle>
#include <QSvgRenderer>
#include <QWidget>

namespace relievo {
namespace {
struct LookRow {
    const char *name, *window, *field, *raised, *hovered, *line, *text, *dim, *accent, *onAccent, *warning, *error;
};
constexpr LookRow kLooks[] = {
    // name     window     field      raised     hovered    line       text       dim        accent     onAccent   warning    error
    {"dark", "#282828", "#1f1f1f", "#363636", "#404040", "#3a3a3a", "#d8d8d8", "#b0b0b0", "#5b9bd5", "#101820", "#e0a84a", "#f08078"},
    {"light", "#eeeeee", "#ffffff", "#e2e2e2", "#d6d6d6", "#cdcdcd", "#202020", "#565656", "#2f74b5", "#ffffff", "#7f4c00", "#b3261e"},
};

// Families with digits of equal width, best first.
constexpr const char* kFamilies[] = {"Noto Sans", "Open Sans", "Roboto", "DejaVu Sans"};

QPalette paletteOf(const LookRow& row)
{
    QPalette palette;
    const auto all = [&](QPalette::ColorRole role, const char* color) { palette.setColor(role, QColor(color)); };
    all(QPalette::Window, row.window);
    all(QPalette::Base, row.field);
    all(QPalette::AlternateBase, row.window);
    all(QPalette::Button, row.raised);
    all(QPalette::Midlight, row.hovered);
    all(QPalette::Light, row.hovered);
    all(QPalette::Mid, row.line);
    all(QPalette::Dark, row.line);
    all(QPalette::Shadow, row.field);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        all(role, row.text);
    all(QPalette::PlaceholderText, row.dim);
    all(QPalette::Highlight, row.accent);
    all(QPalette::HighlightedText, row.onAccent);
    all(QPalette::Link, row.accent);
    all(QPalette::BrightText, row.warning);
    all(QPalette::ToolTipBase, row.raised);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor faint(row.dim);
        faint.setAlphaF(0.6f);
        palette.setColor(QPalette::Disabled, role, faint);
    }
    return palette;
}

QString styleSheet(const LookRow& row)
{
    QFile file(":/resources/style/editor.qss");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString text = QString::fromUtf8(file.readAll());
    const std::pair<const char*, const char*> words[] = {{"@window", row.window}, {"@field", row.field}, {"@raised", row.raised},
        {"@hovered", row.hovered}, {"@line", row.line}, {"@text", row.text}, {"@dim", row.dim}, {"@accent", row.accent},
        {"@onAccent", row.onAccent}, {"@warning", row.warning}, {"@error", row.error}, {"@look", row.name}};
    for (const auto& [word, value] : words)
        text.replace(word, value);
    return text;
}

QFont baseFont()
{
    const QStringList present = QFontDatabase::families();
    QFont font;
    for (const char* family : kFamilies)
        if (present.contains(family)) {
            font.setFamily(family);
            break;
        }
    font.setPixelSize(kFontSize);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

// Strokes of an SVG in the palette's text colour.
class TintedSvg : public QIconEngine {
public:
    explicit TintedSvg(QString file) : m_file(std::move(file)) { }
    QIconEngine* clone() const override { return new TintedSvg(m_file); }
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const qreal ratio = painter->device()->devicePixelRatio();
        QPixmap pixels = scaledPixmap(rect.size() * ratio, mode, QIcon::Off, 1);
        painter->drawPixmap(rect, pixels);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override { return scaledPixmap(size, mode, state, 1); }
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal) override
    {
        QPixmap pixels(size);
        pixels.fill(Qt::transparent);
        QPainter painter(&pixels);
        QSvgRenderer(m_file).render(&painter);
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        painter.fillRect(pixels.rect(), QApplication::palette().color(group, QPalette::WindowText));
        return pixels;
    }

private:
    QString m_file;
};
} // namespace

void applyLook(QApplication& application, Look look)
{
    const LookRow& row = kLooks[std::size_t(look)];
    static bool s_styled = false;
    if (!s_styled) { // a style sheet stands around it and hides its name
        application.setStyle(new OwnIcons);
        s_styled = true;
    }
    application.setFont(baseFont());
    application.setPalette(paletteOf(row));
    application.setStyleSheet(styleSheet(row));
}

Look savedLook()
{
    return QSettings().value("look").toString() == "light" ? Look::Light : Look::Dark;
}

void chooseLook(Look look)
{
    applyLook(*qApp, look);
    QSettings().setValue("look", look == Look::Light ? "light" : "dark");
}

void setRole(QWidget& widget, const char* role)
{
    if (widget.property("role").toString() == role)
        return;
    widget.setProperty("role", role);
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
}

QFont smallFont()
{
    QFont font = QApplication::font();
    font.setPixelSize(kSmallFontSize);
    return font;
}

QIcon icon(std::string_view name)
{
    return QIcon(new TintedSvg(QString(":/resources/icons/%1.svg").arg(qt(name))));
}

} // namespace relievo
