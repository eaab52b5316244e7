// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace pixelplumb {

/// Leaves Space to widgets that use it: to text fields, to a button in focus, which it presses, and
/// to a current cell that it checks. Elsewhere it plays or pauses, even in a combo box, which other
/// keys open.
class PlayKey : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Watches a window, or a panel that may float as one.
    void watch(QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace pixelplumb
