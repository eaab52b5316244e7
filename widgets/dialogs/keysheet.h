// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QList>

class QMenu;

namespace pixelplumb {

/// Every key of the window, read from its menus: what is on the sheet is what the keys do.
class KeySheet : public QDialog {
    Q_OBJECT

public:
    explicit KeySheet(const QList<QMenu *> &menus, QWidget *parent = nullptr);
};

/// A table a menu, a row an action that has a key.
QString keySheetHtml(const QList<QMenu *> &menus);

} // namespace pixelplumb
