// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include <optional>

class QDockWidget;
class QMainWindow;

namespace pixelplumb {

/// Shown, and not behind the tab of another, where Qt places it beside the window.
bool isInFront(const QDockWidget &dock);

/// The room that a panel takes from the canvas while it is open, and gives back when it is closed;
/// half of the window's width stays the canvas's, whatever is opened or dragged, as far as the
/// panels beside it can be so narrow.
class DockRoom : public QObject {
    Q_OBJECT

public:
    static constexpr int tabsHeight = 40; ///< logical pixels: more than any style's tabs

    /// The panels that stand around the canvas at first.
    struct Usual {
        QDockWidget *formula;
        QDockWidget *pixelGrid;
        QDockWidget *pixelHistory;
        QDockWidget *columns;
        int formulaWidth; ///< that it needs
    };

    DockRoom(QMainWindow *window, const QList<QDockWidget *> &docks, const Usual &usual);

    /// Before a panel is shown: how high what stands below the canvas is.
    void remember(QDockWidget *dock);
    /// For a panel that is shown.
    void makeFor(QDockWidget *dock);

public slots:
    /// What the last study below the canvas had more is the canvas's again.
    void giveBack();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    int half() const;
    void keepHalf();
    void makeBelow(QDockWidget *dock);
    void makeBeside(QDockWidget *dock);
    QList<QDockWidget *> studiesBelow() const;

    QMainWindow *m_window;
    QWidget *m_centre; ///< of the window: the canvas
    QList<QDockWidget *> m_docks;
    Usual m_usual;
    std::optional<int> m_heightBefore; ///< of what is below the canvas, while a study has more
};

} // namespace pixelplumb
