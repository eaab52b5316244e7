// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/panels.h"

#include <QDockWidget>

class QMainWindow;

namespace pixelplumb {

/// The dock of a row of the table of panels. Its panel is built when the dock is first shown, in
/// front or behind a tab, or when somebody asks for it.
class PanelDock : public QDockWidget {
    Q_OBJECT

public:
    PanelDock(const Panel &row, const WindowParts &parts, QMainWindow *window);

    const Panel &row() const { return m_row; }
    bool isBuilt() const { return widget() != nullptr; }
    QWidget *panel();

    void setVisible(bool visible) override;

signals:
    void built(QWidget *panel);

private:
    const Panel &m_row;
    WindowParts m_parts;
};

} // namespace pixelplumb
