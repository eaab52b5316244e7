// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace pixelplumb {

/// A letter pressed in an open menu chooses the entry in which it is underlined, even if it is also
/// the key of a window action; a letter without an entry does nothing.
class MenuKeys : public QObject {
public:
    /// Acts in all menus of the program.
    explicit MenuKeys(QObject *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace pixelplumb
