// From the names of Qt to our icons.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/own_icons.h"
#include "app/window/widgets/theme.h"
#include <algorithm>
#include <iterator>

namespace relievo {
namespace {
struct OwnIconRow {
    QStyle::StandardPixmap which;
    const char* icon; // of resources/icons
};
constexpr OwnIconRow kOwnIcons[] = {
    {QStyle::SP_FileDialogToParent, "up"},
    {QStyle::SP_FileDialogBack, "left"},
    {QStyle::SP_ArrowBack, "left"},
    {QStyle::SP_ArrowForward, "right"},
    {QStyle::SP_FileDialogNewFolder, "new-folder"},
    {QStyle::SP_FileDialogDetailedView, "details"},
    {QStyle::SP_FileDialogListView, "list"},
    {QStyle::SP_FileDialogContentsView, "details"},
    {QStyle::SP_FileDialogInfoView, "info"},
    {QStyle::SP_DirIcon, "folder"},
    {QStyle::SP_DirClosedIcon, "folder"},
    {QStyle::SP_DirOpenIcon, "open"},
    {QStyle::SP_DirHomeIcon, "home"},
    {QStyle::SP_DirLinkIcon, "folder"},
    {QStyle::SP_FileIcon, "new"},
    {QStyle::SP_FileLinkIcon, "new"},
    {QStyle::SP_ComputerIcon, "computer"},
    {QStyle::SP_DesktopIcon, "computer"},
    {QStyle::SP_DriveHDIcon, "drive"},
    {QStyle::SP_MessageBoxInformation, "info"},
    {QStyle::SP_MessageBoxQuestion, "info"},
    {QStyle::SP_MessageBoxWarning, "warning"},
    {QStyle::SP_MessageBoxCritical, "error"},
};
constexpr int kBoxIcon = 32; // px

const char* ownIcon(QStyle::StandardPixmap which)
{
    const auto row = std::ranges::find(kOwnIcons, which, &OwnIconRow::which);
    return row == std::end(kOwnIcons) ? nullptr : row->icon;
}
} // namespace

OwnIcons::OwnIcons() : QProxyStyle("Fusion") { }

QIcon OwnIcons::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const
{
    const char* own = ownIcon(which);
    return own ? relievo::icon(own) : QProxyStyle::standardIcon(which, option, widget);
}

QPixmap OwnIcons::standardPixmap(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const
{
    const char* own = ownIcon(which);
    return own ? relievo::icon(own).pixmap(kBoxIcon) : QProxyStyle::standardPixmap(which, option, widget);
}

int OwnIcons::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const
{
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
}

} // namespace relievo
