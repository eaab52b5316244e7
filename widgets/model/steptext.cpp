// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/steptext.h"

#include "core/runs/explain/rejectedprimitives.h"
#include "core/runs/spanheadings.h"
#include "widgets/look/corewords.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

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
    const bool refused = rejectionOf(traced, primitive).has_value();
    return (refused ? StepText::tr("%1 %2 draws nothing") : StepText::tr("%1 %2 set up"))
        .arg(coreWord(nameOf(traced.primitives.kindOf(primitive))), QString::number(primitive));
}

/// Which pixel it is, and how it differs; the current step need not have drawn it.
QString firstDifferenceText(const TracedScene &traced)
{
    const std::optional<TracedScene::WrongPixel> wrong = traced.firstWrongPixel();
    if (!wrong)
        return {};
    const auto text = [&] {
        switch (traced.differences.at(wrong->x, wrong->y)) {
        case Difference::Missing:
            return wrong->decidedAt == traced.trace->stepCount()
                ? StepText::tr("first difference from the truth: pixel (%1, %2) is missing when "
                               "the run ends")
                : StepText::tr("first difference from the truth: pixel (%1, %2) is missing, and "
                               "this step was the last that could have drawn it");
        case Difference::Extra:
            return StepText::tr("first difference from the truth: pixel (%1, %2) is extra");
        case Difference::Colour:
        case Difference::Undecidable:
        case Difference::None:
            break;
        }
        return StepText::tr("first difference from the truth: pixel (%1, %2) has another colour");
    };
    return text().arg(wrong->x).arg(wrong->y);
}

/// The translation context.
struct FrameText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::FrameText)
};

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

QString markText(const TracedScene &traced, const TraceMark &mark)
{
    switch (mark.kind) {
    case MarkKind::PartBegins:
        return StepText::tr(
            "vertex: here is a corner of the primitive, or a part of it begins or ends");
    case MarkKind::Tie:
        return StepText::tr(
            "tie: a sample here lies exactly on an edge, or a line half-way between two");
    case MarkKind::Clamp:
        return StepText::tr("clamp: a colour level left 0 … 255");
    case MarkKind::FirstDifference:
        return firstDifferenceText(traced);
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

std::optional<int> movingFrame(const SceneDocument &document)
{
    return document.scene().motion ? std::optional(document.currentFrame()) : std::nullopt;
}

QString frameText(const SceneDocument &document)
{
    const std::optional<int> frame = movingFrame(document);
    return frame ? FrameText::tr("frame %1 of %2 of the motion")
                       .arg(*frame)
                       .arg(document.scene().motion->frames - 1)
                 : QString();
}

std::optional<QPoint> typedPixel(const QString &text)
{
    static const QRegularExpression form(
        QStringLiteral(R"(^\s*\(?\s*(-?\d{1,10})\s*[,; ]\s*(-?\d{1,10})\s*\)?\s*$)"));
    const auto match = form.match(text);
    bool xFits = false;
    bool yFits = false;
    const QPoint pixel(match.captured(1).toInt(&xFits), match.captured(2).toInt(&yFits));
    return match.hasMatch() && xFits && yFits ? std::optional(pixel) : std::nullopt;
}

} // namespace pixelplumb
