// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace pixelplumb {

/// Escape that nobody else has a use for brings the focus back to the canvas, whose keys act again.
class EscapeKey : public QObject {
    Q_OBJECT

public:
    EscapeKey(QWidget *canvas, QObject *parent);

    /// A window with all its parts, or a panel that may float as one.
    void watch(QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *m_canvas;
};

} // namespace pixelplumb
