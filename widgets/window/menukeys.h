// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace pixelplumb {

/// A letter that is pressed in an open menu chooses the entry in which it is underlined, though it
/// is the key of an action of the window as well; what is no entry's does nothing.
class MenuKeys : public QObject {
public:
    /// In all menus of the program.
    explicit MenuKeys(QObject *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace pixelplumb
