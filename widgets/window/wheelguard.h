// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace pixelplumb {

/// Keeps the wheel from changing a combo or spin box without the focus; it scrolls what is around
/// it instead. One for the whole program, dialogs and floating panels included.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QObject *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace pixelplumb
