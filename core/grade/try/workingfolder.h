// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace pixelplumb {

/// A temporary folder for a program that runs without a sandbox. Its supervisor makes it, locks it,
/// and removes it with all its content, but without following links, when the program and its
/// descendants are gone. An unlocked one, whose supervisor was killed, is removed when the next
/// program is started without a sandbox.
class WorkingFolder {
public:
    WorkingFolder();
    ~WorkingFolder(); ///< removes it if no supervisor did
    Q_DISABLE_COPY_MOVE(WorkingFolder)

    const QString &path() const { return m_path; }
    /// The command that removes it.
    QStringList removal() const;
    /// Kills the processes that were started in it, as far as they can be found; needed if the
    /// supervisor was killed.
    void endProcesses() const;
    /// The supervisor goes on removing it.
    void leaveToSupervisor() { m_path.clear(); }

private:
    QString m_path;
};

} // namespace pixelplumb
