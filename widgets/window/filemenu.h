// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QMenu>

namespace pixelplumb {

/// Scenes as files, and everything that is exported.
class FileMenu : public QMenu {
    Q_OBJECT

public:
    FileMenu(const WindowParts &parts, QWidget *window);

signals:
    void examplesRequested();

private:
    void addExports(const WindowParts &parts);
};

} // namespace pixelplumb
