// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

/// What keys and the wheel do throughout the program, whichever part has the focus.
///
/// - Escape that no other widget uses returns the focus to the canvas, whose keys then act again.
/// - Space is left to widgets that use it: to text fields, to a button in focus, which it presses,
///   and to a current cell that it checks. Elsewhere it plays or pauses, even in a combo box, which
///   other keys open.
/// - A letter pressed in an open menu chooses the entry in which it is underlined, even if it is
///   also the key of a window action; a letter without an entry does nothing.
/// - The wheel changes no combo or spin box without the focus; it scrolls what is around it.
class WindowKeys : public QObject {
public:
    WindowKeys(QWidget *canvas, QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool isWindowOrDock(const QObject *object) const;
    bool takesFocusBack(const QObject *watched, const QKeyEvent &key);
    bool leavesToWidget(const QObject *watched, const QKeyEvent &key) const;

    QWidget *m_canvas;
    QWidget *m_window;
};

} // namespace pixelplumb
