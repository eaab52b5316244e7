// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace pixelplumb {

/// Keeps the wheel from changing a box that nobody has in hand: over a combo or spin box without
/// the focus it scrolls what is around. One for the whole program, dialogs and floating panels
/// included.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QObject *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace pixelplumb
