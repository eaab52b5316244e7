// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

/// Every key of the window, read from its menus, so that the sheet never disagrees with the keys.
class KeySheet : public QDialog {
    Q_OBJECT

public:
    explicit KeySheet(const QList<QMenu *> &menus, QWidget *parent = nullptr);
};

/// A table per menu, a row per action that has a key.
QString keySheetHtml(const QList<QMenu *> &menus);

} // namespace pixelplumb
