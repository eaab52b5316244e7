// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

class QMenuBar;

namespace pixelplumb {

/// The key sheet, made from the menus of the bar, what the window's parts are for, and what the
/// program is.
class HelpMenu : public QMenu {
    Q_OBJECT

public:
    explicit HelpMenu(QMenuBar *bar);

    /// All of the bar.
    QList<QMenu *> menus() const;

private:
    void showKeys();
    void showAbout();

    QMenuBar *m_bar;
};

} // namespace pixelplumb
