// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

class QMenuBar;

namespace pixelplumb {

/// The key sheet, made from the menu bar's menus, What's This, and the About box.
class HelpMenu : public QMenu {
    Q_OBJECT

public:
    explicit HelpMenu(QMenuBar *bar);

    /// All menus of the bar.
    QList<QMenu *> menus() const;

private:
    void showKeys();
    void showAbout();

    QMenuBar *m_bar;
};

} // namespace pixelplumb
