// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace pixelplumb {

/// Escape that no other widget uses returns the focus to the canvas, whose keys then act again.
class EscapeKey : public QObject {
    Q_OBJECT

public:
    EscapeKey(QWidget *canvas, QObject *parent);

    /// Watches a window with all its parts, or a panel that may float as one.
    void watch(QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *m_canvas;
};

} // namespace pixelplumb
