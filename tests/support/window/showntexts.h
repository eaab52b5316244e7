// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMenu;
class QWidget;

namespace pixelplumb {

/// A text and the place where it is shown.
struct ShownText {
    QString place;
    QString text;
};

/// Appends the menu's title, its entries and tool tips, and those of its submenus.
void appendTexts(QList<ShownText> &texts, const QMenu &menu);

/// The texts in a window, dock or dialog, except those of Qt's own buttons.
QList<ShownText> shownTexts(const QWidget &whole);
/// The texts in its tables, trees, lists and documents.
QList<ShownText> shownContents(const QWidget &whole);

} // namespace pixelplumb
