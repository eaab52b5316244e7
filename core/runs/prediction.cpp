// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/prediction.h"

#include "core/methods/formulatext.h"
#include "core/runs/formulaexplanation.h"
#include "core/runs/pixelhistory.h"
#include "core/runs/spanheadings.h"
#include "core/scene/coordinatetext.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int leastPlaces = 2; // of a decimal that may be rounded
constexpr double readingError = 1e-9; // relative; of a fraction that is read as a double

/// The number that a formula computes: what stands before "←" or "=".
QString assignedIn(const QString &symbols)
{
    const qsizetype end
        = std::max(symbols.indexOf(QStringLiteral(" ← ")), symbols.indexOf(QStringLiteral(" = ")));
    return symbols.left(end);
}

const FormulaLine *lineOf(const Explanation &explanation, const FormulaLine &like)
{
    const auto found = std::ranges::find_if(explanation.lines, [&](const FormulaLine &line) {
        return line.subject == like.subject && assignedIn(line.symbols) == assignedIn(like.symbols);
    });
    return found != explanation.lines.end() ? &*found : nullptr;
}

/// How many digits stand behind the point; none of what is no decimal.
int placesOf(const QString &typed)
{
    const qsizetype point = typed.indexOf(u'.');
    return point < 0 || typed.contains(u'/') ? 0 : int(typed.size() - point - 1);
}

bool isSame(double typed, double value)
{
    return std::abs(typed - value) <= readingError * std::max(1.0, std::abs(value));
}

std::optional<TraceStep> nextWriteAfter(const ScanTrace &trace, std::size_t position)
{
    for (std::size_t index = position; index < trace.stepCount(); ++index) {
        const TraceStep step = trace.stepAt(index);
        if (step.kind == StepKind::Sample && trace.changes()[step.sample].isWritten())
            return step;
    }
    return std::nullopt;
}

bool isRounded(double typed, double value, int places)
{
    const double half = 0.5 * std::pow(10.0, -places);
    return places >= leastPlaces
        && std::abs(typed - value) <= half + readingError * std::max(1.0, std::abs(value));
}

} // namespace

std::vector<Prediction> predictionsAfter(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    std::size_t index = position;
    while (index < trace.stepCount() && trace.stepAt(index).kind != StepKind::Span)
        ++index;
    if (index >= trace.stepCount())
        return {};
    const std::size_t span = trace.stepAt(index).span;
    const Explanation next = explainStep(traced, index);
    std::optional<Explanation> before;
    if (!trace.beginsPart(span))
        before = explainStep(traced, trace.indexOfSpan(span - 1));
    std::vector<Prediction> predictions;
    for (const FormulaLine &line : next.lines) {
        const FormulaLine *earlier = before ? lineOf(*before, line) : nullptr;
        predictions.push_back({next.heading, assignedIn(line.symbols), line.used,
                               earlier ? earlier->used : Quantity(), line.symbols,
                               line.symbols + QStringLiteral(" = ") + line.substituted});
    }
    return predictions;
}

std::optional<NextPixel> nextPixelAfter(const TracedScene &traced, std::size_t position)
{
    const ScanTrace &trace = *traced.trace;
    const std::optional<TraceStep> step = nextWriteAfter(trace, position);
    if (!step)
        return std::nullopt;
    const PixelChange &change = trace.changes()[step->sample];
    return NextPixel{{change.x, change.y},
                     explainStep(traced, trace.indexOfSpan(step->span)).sentence};
}

QString wrongPixelText(const TracedScene &traced, std::size_t position, const QPoint &pixel)
{
    const ScanTrace &trace = *traced.trace;
    const std::optional<TraceStep> next = nextWriteAfter(trace, position);
    if (!next)
        return {};
    const auto visit = trace.visitOf(next->primitive, pixel.x(), pixel.y());
    if (!visit || !trace.changes()[*visit].isWritten()) {
        for (const PixelAttempt &attempt :
             briefPixelHistory(traced, pixel.x(), pixel.y(), next->primitive + 1).attempts) {
            if (attempt.primitive == next->primitive)
                return attempt.reason;
        }
        return {};
    }
    if (trace.indexOfSample(*visit) < position)
        return QStringLiteral("It has been drawn already, in step %1.")
            .arg(trace.indexOfSample(*visit) + 1);
    const std::size_t span = trace.spanOf(*visit);
    return span == next->span
        ? QStringLiteral("Its turn comes later in the same span: where does the method begin?")
        : QStringLiteral("Its turn comes later: %1.").arg(spanHeading(trace, span));
}

Guess judge(const Prediction &prediction, const QString &typed)
{
    const QString text = typed.trimmed().replace(u'−', u'-');
    const auto read = parseReal(text, coordinateFormat);
    if (!read)
        return Guess::Unread;
    const double value = prediction.value.toDouble();
    if (isSame(*read, value) || isRounded(*read, value, placesOf(text)))
        return Guess::Right;
    if (!prediction.earlier.isNone() && isSame(*read, prediction.earlier.toDouble()))
        return Guess::Earlier;
    if (isSame(*read, -value))
        return Guess::OtherSign;
    if (prediction.value.isInteger() && std::abs(*read - value) == 1)
        return Guess::OneOff;
    return Guess::Wrong;
}

QString verdictText(const Prediction &prediction, Guess guess)
{
    switch (guess) {
    case Guess::Right:
        return QStringLiteral("Right: %1 = %2.").arg(prediction.reason, term(prediction.value));
    case Guess::Unread:
        return QStringLiteral("Type a number, such as 9, 8.63, 53/2 or 8 10/27.");
    case Guess::Earlier:
        return QStringLiteral("That is %1 of the span before: what does one step add to it?")
            .arg(prediction.title);
    case Guess::OneOff:
        return QStringLiteral("One off: which samples does the fill rule take?");
    case Guess::OtherSign:
        return QStringLiteral("The sign is the other one.");
    case Guess::Wrong:
        break;
    }
    return QStringLiteral("Not yet: %1. Put the numbers in, or have it shown.")
        .arg(prediction.rule);
}

} // namespace pixelplumb
