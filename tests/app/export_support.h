// Driving the export dialog.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/dialogs/export_dialog.h"
#include "tests/app/window_support.h"
#include <QLabel>
#include <QLineEdit>

namespace relievo {

class ExportingTest : public WindowTest {
protected:
    ExportDialog& exportTo(const char* key)
    {
        window.action("export")->trigger();
        auto& dialog = *window.findChild<ExportDialog*>();
        dialog.setTarget(key);
        return dialog;
    }
    static QLineEdit& out(ExportDialog& dialog) { return *dialog.findChild<QLineEdit*>("out"); }
    static QLabel& result(ExportDialog& dialog) { return *dialog.findChild<QLabel*>("result"); }
    static void finish(ExportDialog& dialog)
    {
        ASSERT_TRUE(waitFor([&] { return !dialog.busy(); }));
    }
};

} // namespace relievo
