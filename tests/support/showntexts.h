// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMenu;
class QWidget;

namespace pixelplumb {

/// A text that is told by where it stands.
struct ShownText {
    QString place;
    QString text;
};

/// Of the menu, its entries and their tool tips, and of the menus in it.
void appendTexts(QList<ShownText> &texts, const QMenu &menu);

/// Of the parts of a window, a dock or a dialog, but for Qt's own buttons.
QList<ShownText> shownTexts(const QWidget &whole);

} // namespace pixelplumb
