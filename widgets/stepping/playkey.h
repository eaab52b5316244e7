// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace pixelplumb {

/// Leaves Space to those who have a use for it: to fields that are typed in, to a button in focus,
/// which it presses, and to a cell in hand that it checks. From everywhere else it plays or pauses:
/// also from a box, which other keys open and in which something was just chosen.
class PlayKey : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// A window, or a panel that may float as one.
    void watch(QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace pixelplumb
