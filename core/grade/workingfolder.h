// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"

#include <QString>
#include <QStringList>

namespace pixelplumb {

struct ProgramUser;

/// An empty folder among the temporary ones for a program that runs in no sandbox. Its supervisor
/// removes it when the program and all that came of it are gone, with whatever is in it and nothing
/// that a link there leads to. It is locked for as long as this is there: one that is not, for its
/// maker and the supervisor were killed, is removed when the next program is started so.
class WorkingFolder {
public:
    WorkingFolder();
    ~WorkingFolder(); ///< removes it where no supervisor did
    Q_DISABLE_COPY_MOVE(WorkingFolder)

    /// It is there, and that user's; else errno says why not.
    bool isReadyFor(const ProgramUser &user) const;
    const QString &path() const { return m_path; }
    /// The command that removes it.
    QStringList removal() const;
    /// Kills the processes that were started in it, as far as they are found: for when the
    /// supervisor was killed.
    void endProcesses() const;

private:
    QString m_path; ///< empty where it could not be made
    Descriptor m_lock;
};

} // namespace pixelplumb
