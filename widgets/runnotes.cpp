// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/runnotes.h"

#include "core/trace/tracedscene.h"

#include <QCoreApplication>

namespace pixelplumb {

QString cutRunNote(const TracedScene &traced)
{
    return QCoreApplication::translate(
               "RunNotes",
               "Recorded are the first %L1 steps, into primitive %L2 of %L3: stepping and the "
               "panels "
               "end there. At the end the canvas shows the finished picture. To record the whole "
               "run, make the frame or the scene smaller.")
        .arg(traced.trace->stepCount())
        .arg(traced.trace->primitiveCount())
        .arg(traced.primitives.size());
}

QString cancelledRunNote()
{
    return QCoreApplication::translate(
        "RunNotes",
        "Tracing was cancelled: the panels show the run before. Undo the change, or change the "
        "scene again to trace it.");
}

} // namespace pixelplumb
