// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>

namespace pixelplumb {

/// An empty folder for a program that nobody trusts: whatever that put there is removed with it,
/// and nothing that a link there leads to.
class WorkingFolder {
public:
    WorkingFolder() { m_folder.setAutoRemove(false); }
    ~WorkingFolder();
    Q_DISABLE_COPY_MOVE(WorkingFolder)

    bool isValid() const { return m_folder.isValid(); }
    QString path() const { return m_folder.path(); }

private:
    QTemporaryDir m_folder;
};

} // namespace pixelplumb
