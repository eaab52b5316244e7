// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/deviation.h"
#include "core/scan/choicenames.h"

#include <QStringList>

#include <cmath>

namespace pixelplumb {

namespace {

QString boundName(DecidingBound bound, SpanAxis axis)
{
    if (axis == SpanAxis::Column)
        return bound == DecidingBound::Lower ? u"y_B"_s : u"y_T"_s;
    return bound == DecidingBound::Lower ? u"x_L"_s : u"x_R"_s;
}

QString kindText(Difference kind)
{
    return kind == Difference::Colour ? u"another colour"_s : nameOf(kind);
}

/// "y_T = 9.999998 instead of 10, 1.9e-06 px too low"
QString boundText(const Deviation &deviation, SpanAxis axis)
{
    const double error = errorOf(deviation.used, deviation.exact);
    return u"%1 = %2 instead of %3, %4 px too %5"_s.arg(
        boundName(deviation.bound, axis), toText(deviation.used), toText(deviation.exact),
        QString::number(std::abs(error), 'g', 2), error < 0 ? u"low"_s : u"high"_s);
}

/// "R 126.49 instead of 126 1/2", for the channels whose bytes differ.
QString coloursText(const Deviation &deviation, const JudgedRun &run, std::int64_t x,
                    std::int64_t y)
{
    const Colour drawn = run.drawn->colourAt(x, y);
    const Colour truth = run.truth->colourAt(x, y);
    std::array<Quantity, 3> used, exact;
    const ScanTrace &trace = *run.traced->trace;
    if (const auto visit = trace.visitOf(*deviation.primitive, x, y)) {
        const std::size_t span = trace.spanOf(*visit);
        used = trace.samples(span)[*visit - trace.firstSampleOf(span)].colour;
    }
    // With effects the bytes do not come from these levels.
    if (!run.traced->shading())
        exact = exactLevelsAt(*run.traced, *deviation.primitive, x, y);
    QStringList parts;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (drawn.channels[channel] == truth.channels[channel])
            continue;
        QString part = u"%1 %2 instead of %3"_s.arg(QLatin1Char("RGB"[channel]))
                           .arg(drawn.channels[channel])
                           .arg(truth.channels[channel]);
        if (!used[channel].isNone() && !exact[channel].isNone())
            part += u" (the level %1 instead of %2)"_s.arg(toText(used[channel]),
                                                           toText(exact[channel]));
        parts.append(part);
    }
    return parts.join(u", "_s);
}

/// For triangles the deciding number is known; for shapes only that it was rounded on the way.
QString precisionText(const Deviation &deviation, const JudgedRun &run, const QString &arithmetic)
{
    const ScanTrace &trace = *run.traced->trace;
    const bool isShape = deviation.primitive && !run.primitives->isTriangle(*deviation.primitive);
    if (!isShape
        || trace.setUp(*deviation.primitive).rejection == PrimitiveRejection::NotRepresentable)
        return u"%1 cannot represent the deciding numbers"_s.arg(arithmetic);
    return u"%1 rounds the deciding numbers"_s.arg(arithmetic);
}

QString causeText(const Deviation &deviation, const JudgedRun &run)
{
    const QString arithmetic = nameText(nameOf(run.traced->scene.settings.arithmetic));
    switch (deviation.reason) {
    case Disagreement::None:
    case Disagreement::TieRule:
    case Disagreement::Undrawn:
        return {};
    case Disagreement::Rounding:
        return u"the rounding of one level"_s;
    case Disagreement::Drift:
        return deviation.bound == DecidingBound::None
            ? u"the increments accumulated in %1 missed the exact value"_s.arg(arithmetic)
            : u"%1 can represent the exact bound, but the accumulated increments missed it"_s.arg(
                arithmetic);
    case Disagreement::Precision:
        return precisionText(deviation, run, arithmetic);
    case Disagreement::Method:
        return run.traced->method->supports(Arithmetic::Exact)
            ? u"the method does so even in exact arithmetic"_s
            : u"caused by the method or by %1; without exact arithmetic one cannot tell which"_s
                  .arg(arithmetic);
    case Disagreement::NotRecorded:
        return u"the recording ended before this pixel"_s;
    }
    return {};
}

} // namespace

QString textOf(const Deviation &deviation, const JudgedRun &run, std::int64_t x, std::int64_t y)
{
    if (deviation.reason == Disagreement::None)
        return {};
    QStringList parts;
    if (deviation.bound != DecidingBound::None)
        parts.append(boundText(deviation, run.traced->trace->placeOf(*deviation.span).axis));
    else if (deviation.kind == Difference::Colour && deviation.primitive)
        parts.append(coloursText(deviation, run, x, y));
    parts.append(causeText(deviation, run));
    QString text = kindText(deviation.kind) + u": "_s + parts.join(u"; "_s);
    if (deviation.isTie)
        text += u"; the sample lies exactly on an edge"_s;
    return withMinus(text);
}

} // namespace pixelplumb
