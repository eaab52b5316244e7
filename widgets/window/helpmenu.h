// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

class QMenuBar;

namespace pixelplumb {

/// The key sheet, made from the menus of the bar, and what the program is.
class HelpMenu : public QMenu {
    Q_OBJECT

public:
    explicit HelpMenu(QMenuBar *bar);

private:
    void showKeys(const QMenuBar *bar);
    void showAbout();
};

} // namespace pixelplumb
