// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/steptext.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

QString tr(const char *text) { return QCoreApplication::translate("pixelplumb::StepText", text); }

QString columnText(const ScanTrace &trace, std::size_t column)
{
    const QString text = trace.halfOf(column) == ColumnHalf::First ? tr("column %1, first half")
                                                                   : tr("column %1, second half");
    return text.arg(trace.xOf(column));
}

QString triangleText(const ScanTrace &trace, std::size_t triangle)
{
    const bool refused = trace.setUp(triangle).rejection.has_value();
    return (refused ? tr("triangle %1 draws nothing") : tr("triangle %1 set up")).arg(triangle);
}

} // namespace

QString stepText(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    if (position == 0)
        return tr("nothing drawn yet");
    const TraceStep step = trace.stepAt(position - 1);
    switch (step.kind) {
    case StepKind::SetUp:
        return triangleText(trace, step.triangle);
    case StepKind::Column:
        return tr("%1 entered").arg(columnText(trace, step.column));
    case StepKind::Pixel: {
        const PixelChange &change = trace.changes()[step.pixel];
        return tr("pixel (%1, %2) written").arg(change.x).arg(change.y);
    }
    }
    return {};
}

QString markText(MarkKind kind)
{
    switch (kind) {
    case MarkKind::VertexColumn:
        return tr("the first column at or after a vertex");
    case MarkKind::Tie:
        return tr("tie: a sample of this column lies exactly on an edge");
    case MarkKind::Clamp:
        return tr("clamp: a colour level left 0 … 255");
    case MarkKind::FirstDifference:
        return tr("the first pixel that differs from the truth");
    }
    return {};
}

QString columnText(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    if (position == 0)
        return tr("before the first column");
    const TraceStep step = trace.stepAt(position - 1);
    return step.kind == StepKind::SetUp ? triangleText(trace, step.triangle)
                                        : columnText(trace, step.column);
}

} // namespace pixelplumb
