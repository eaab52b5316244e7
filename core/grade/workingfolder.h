// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"

#include <QString>
#include <QStringList>

namespace pixelplumb {

struct ProgramUser;

/// An empty temporary folder for a program that runs without a sandbox. Its supervisor removes it
/// with all its content, but without following links, when the program and its descendants are
/// gone. It is locked while this object lives; an unlocked one, whose maker and supervisor were
/// killed, is removed when the next program is started without a sandbox.
class WorkingFolder {
public:
    WorkingFolder();
    ~WorkingFolder(); ///< removes it if no supervisor did
    Q_DISABLE_COPY_MOVE(WorkingFolder)

    /// Whether it exists and belongs to that user; otherwise errno says why not.
    bool isReadyFor(const ProgramUser &user) const;
    const QString &path() const { return m_path; }
    /// The command that removes it.
    QStringList removal() const;
    /// Kills the processes that were started in it, as far as they can be found; needed if the
    /// supervisor was killed.
    void endProcesses() const;

private:
    QString m_path; ///< empty where it could not be made
    Descriptor m_lock;
};

} // namespace pixelplumb
