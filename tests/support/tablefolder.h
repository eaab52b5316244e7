// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <QTemporaryDir>

namespace pixelplumb {

/// A folder of exported tables, and the programs for which they are meant as their readers: Qt's
/// parser of JSON at once, python3 for all of the folder.
class TableFolder {
public:
    /// Why one of a run's tables, of any level and format, cannot be written or read; empty where
    /// all can be.
    QString faultOf(const TracedScene &traced) const;
    /// The same; those that are CSV or JSON are kept for python3 as NAME-LEVEL.
    QString faultOfKept(const TracedScene &traced, const QString &name);
    /// Why python3 cannot read all that was kept; empty where it can.
    QString faultByPython() const;
    int keptCount() const { return m_kept; }

private:
    QTemporaryDir m_folder;
    int m_kept = 0;
};

} // namespace pixelplumb
