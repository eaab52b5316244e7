// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/traceexport.h"
#include "core/runs/tracedscene.h"

#include <QTemporaryDir>

namespace pixelplumb {

/// The table of a run as a file has it; empty if it cannot be written.
QByteArray exported(const TracedScene &traced, const TraceExportOptions &options);

/// A folder of exported tables, checked with their intended readers: Qt's JSON parser for each
/// table at once, python3 for the whole folder.
class TableFolder {
public:
    /// Why one of a run's tables, at any level and in any format, cannot be written or read; empty
    /// if all can be.
    QString faultOf(const TracedScene &traced) const;
    /// Like faultOf(), but also keeps the CSV and JSON tables for python3, as NAME-LEVEL.
    QString faultOfKept(const TracedScene &traced, const QString &name);
    /// Why python3 cannot read all kept tables; empty if it can.
    QString faultByPython() const;
    int keptCount() const { return m_kept; }

private:
    QTemporaryDir m_folder;
    int m_kept = 0;
};

} // namespace pixelplumb
