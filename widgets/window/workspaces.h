// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/panels.h"

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QPointer>

#include <array>
#include <iterator>

class QMainWindow;
class QSettings;

namespace pixelplumb {

class FirstArrangement;

/// The workspace that the window shows, the way back to those before it, and how the panels of each
/// lie: as a person has left them, in this run or the last, else as at first.
class Workspaces : public QObject {
    Q_OBJECT

public:
    Workspaces(QMainWindow *window, FirstArrangement *first, QObject *parent);

    Workspace current() const { return m_current; }
    void goTo(Workspace workspace);
    bool canGoBack() const { return !m_visited.isEmpty(); }
    /// To the workspace before this one, as a browser goes back to a page.
    void goBack();
    /// The panels of the current one lie as at first; the others stay as they are.
    void reset();

    /// As the run before left them; as at first where it left nothing that this window could show.
    void restore(const QSettings &settings);
    void store(QSettings &settings);

signals:
    void leaving(); ///< the current one, whose panels are still there
    void changed();

private:
    /// What is found again in a workspace.
    struct Kept {
        QByteArray layout;
        QPointer<QWidget> focus;
    };

    Kept &kept(Workspace workspace) { return m_kept[std::size_t(workspace)]; }
    void keepCurrent();
    void showCurrent();
    void enter(Workspace workspace);

    QMainWindow *m_window;
    FirstArrangement *m_first;
    Workspace m_current = Workspace::Step;
    QList<Workspace> m_visited; ///< on the way to the current one
    std::array<Kept, std::size(allWorkspaces)> m_kept;
};

/// "Step", to be read on a button.
QString titleOf(Workspace workspace);

} // namespace pixelplumb
