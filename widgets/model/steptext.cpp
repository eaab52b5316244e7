// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/steptext.h"

#include "core/runs/spanheadings.h"
#include "widgets/look/corewords.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

struct StepText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::StepText)
};

/// "column 27, second half".
QString spanText(const TracedScene &traced, std::size_t span)
{
    const QString heading = spanHeading(*traced.trace, span);
    return coreWord(heading.left(1).toLower() + heading.sliced(1));
}

QString primitiveText(const TracedScene &traced, std::size_t primitive)
{
    const bool refused = traced.trace->setUp(primitive).rejection.has_value();
    return (refused ? StepText::tr("%1 %2 draws nothing") : StepText::tr("%1 %2 set up"))
        .arg(coreWord(nameOf(traced.primitives.kindOf(primitive))))
        .arg(primitive);
}

} // namespace

QString stepText(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    if (position == 0)
        return StepText::tr("nothing drawn yet");
    const TraceStep step = trace.stepAt(position - 1);
    switch (step.kind) {
    case StepKind::SetUp:
        return primitiveText(traced, step.primitive);
    case StepKind::Span:
        return StepText::tr("%1 entered").arg(spanText(traced, step.span));
    case StepKind::Sample: {
        const PixelChange &change = trace.changes()[step.sample];
        return (change.isWritten() ? StepText::tr("pixel (%1, %2) written")
                                   : StepText::tr("sample (%1, %2) refused"))
            .arg(change.x)
            .arg(change.y);
    }
    }
    return {};
}

QString markText(MarkKind kind)
{
    switch (kind) {
    case MarkKind::PartBegins:
        return StepText::tr("here a part of the primitive begins or ends: a vertex");
    case MarkKind::Tie:
        return StepText::tr(
            "tie: a sample here lies exactly on an edge, or a line half-way between two");
    case MarkKind::Clamp:
        return StepText::tr("clamp: a colour level left 0 … 255");
    case MarkKind::FirstDifference:
        return StepText::tr("the first pixel that differs from the truth");
    }
    return {};
}

QString columnText(const TracedScene &traced, std::size_t position)
{
    if (position == 0)
        return StepText::tr("before the first step");
    const TraceStep step = traced.trace->stepAt(position - 1);
    return step.kind == StepKind::SetUp ? primitiveText(traced, step.primitive)
                                        : spanText(traced, step.span);
}

} // namespace pixelplumb
