// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/edgerefusal.h"

#include "core/methods/words/formulatext.h"
#include "core/runs/explain/refusaltext.h"
#include "core/runs/explain/segmenttext.h"
#include "core/runs/explain/shapereason.h"
#include "core/scan/choicenames.h"
#include "core/trace/namednumbers.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QString distanceText(const oracle::EdgeVerdict &edge, const ScanTrace &trace)
{
    const auto [exact, axis] = scanDistance(edge, trace);
    if (exact.isNone())
        return u"at no distance: the edge is a point"_s;
    return u"%1 px measured along the %2 (%3 px perpendicular to the edge)"_s.arg(
        toText(exact), axis == SpanAxis::Column ? u"column"_s : u"row"_s,
        QString::number(edge.distance, 'g', 6));
}

/// Of the samples in the frame along the loop that passes the pixel's column or row, the first and
/// the last; if none does, of the columns or rows in the frame that have loops.
struct TestedExtent {
    QString samples; ///< "rows"
    Quantity first, last;
};
TestedExtent testedExtentOf(const PixelAttempt &attempt, const ScanTrace &trace)
{
    const QString rows = "rows";
    const QString columns = "columns";
    if (attempt.span)
        return {attempt.span->place.axis == SpanAxis::Row ? columns : rows,
                Quantity::integer(attempt.span->firstDrawn),
                Quantity::integer(attempt.span->endDrawn - 1)};
    const SetUpRecord setUp = trace.setUp(attempt.primitive);
    const NamedNumbers numbers(trace.numbers().setUp, setUp.cells);
    const bool isByRows = !numbers[u"y_min"_s].isNone();
    return isByRows ? TestedExtent{rows, numbers[u"y_min"_s], numbers[u"y_max"_s]}
                    : TestedExtent{columns, numbers[u"x_min"_s], numbers[u"x_max"_s]};
}

/// That the sample lies outside of the samples that are tested, and which these are.
QString untestedText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const QString box = traced.scene.settings.variants.contains(Variant::RoundedBox)
        ? u"rounded box"_s
        : u"box"_s;
    QString text = u"Not tested: it lies outside of the %1 of the vertices"_s.arg(box);
    const auto [samples, first, last] = testedExtentOf(attempt, *traced.trace);
    if (first.toDouble() <= last.toDouble())
        text += u", of which the %1 %2 … %3 are in the frame"_s.arg(samples, toText(first),
                                                                    toText(last));
    return text + u". "_s;
}

/// By what the run itself passed over a sample that the truth refuses, where that may be another
/// reason.
QString ownReasonText(const PixelAttempt &attempt, const TracedScene &traced)
{
    if (isDecidedByOutline(attempt, *traced.trace)) {
        const QString decided = stepBesideText(attempt, traced);
        return decided.isEmpty() ? u" The outline has no pixel in this column."_s : decided;
    }
    if (attempt.written || !mayDecideOtherwise(traced))
        return {};
    if (attempt.sample)
        return deciderText(attempt, traced);
    return attempt.span && !attempt.span->lower.isNone()
        ? u" In the run, %1."_s.arg(boundsText(*attempt.span, traced.scene.settings.arithmetic))
        : QString();
}

QString segmentRefusalText(const PixelAttempt &attempt, const TracedScene &traced,
                           const QString &start)
{
    if (traced.scene.settings.fillRule != FillRule::Closed)
        return u"The triangle has no area: only the closed rule paints a segment."_s;
    return start.arg(
               segmentText(traced.primitives.triangles[attempt.primitive], attempt.x, attempt.y))
        + ownReasonText(attempt, traced);
}

/// Its samples, or its area, have decided; the centre's place is given for orientation.
QString partlyRefusedText(const PixelAttempt &attempt, const TracedScene &traced,
                          const oracle::EdgeVerdict &refusing, const QString &edge)
{
    const QString place = refusing.edgeFunction == 0
        ? tiesText(attempt, traced, TieSide::Other)
        : u"beyond %1, at %2"_s.arg(edge, distanceText(refusing, *traced.trace));
    return noPartText(traced) + u" The pixel's centre lies %1."_s.arg(place);
}

} // namespace

ScanDistance scanDistance(const oracle::EdgeVerdict &edge, const ScanTrace &trace)
{
    const ScanDistance alongColumn{edge.distanceAlongColumn, SpanAxis::Column};
    const ScanDistance alongRow{edge.distanceAlongRow, SpanAxis::Row};
    const bool isByRows = trace.spanCount() > 0 && trace.placeOf(0).axis == SpanAxis::Row;
    const ScanDistance &scanned = isByRows ? alongRow : alongColumn;
    return scanned.exact.isNone() ? (isByRows ? alongColumn : alongRow) : scanned;
}

std::size_t refusingEdge(const oracle::SampleVerdict &verdict)
{
    const auto refusing = std::ranges::min_element(
        verdict.edges, [](const oracle::EdgeVerdict &a, const oracle::EdgeVerdict &b) {
            return std::pair(a.accepts, a.distance) < std::pair(b.accepts, b.distance);
        });
    return std::size_t(refusing - verdict.edges.begin());
}

bool mayDecideOtherwise(const TracedScene &traced)
{
    return !traced.method->isStableUnder(traced.scene.settings);
}

QString tiesText(const PixelAttempt &attempt, const TracedScene &traced, TieSide side)
{
    QStringList ties;
    for (std::size_t i = 0; i < attempt.verdict.edges.size(); ++i) {
        const oracle::EdgeVerdict &edge = attempt.verdict.edges[i];
        if (edge.edgeFunction == 0 && edge.accepts == (side == TieSide::This))
            ties.append(u"exactly on %1, and %2"_s.arg(
                attempt.edgeNames[i],
                tieText(traced, attempt.primitive, edge, attempt.x, attempt.y)));
    }
    return ties.join(u"; it lies "_s);
}

QString deciderText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const auto decisions = decisionsOf(traced.trace->numbers().sample, *attempt.sample);
    return u' ' + refusalSentence(traced, attempt.primitive, *attempt.sample, decisions);
}

bool hasExactBounds(const SpanRecord &span, Arithmetic arithmetic)
{
    const bool isFloat = arithmetic == Arithmetic::Float32 || arithmetic == Arithmetic::Float64;
    return isFloat && span.lower.isRational() && span.upper.isRational();
}

QString boundsText(const SpanRecord &span, Arithmetic arithmetic)
{
    const QString pattern = hasExactBounds(span, arithmetic)
        ? u"the %1's exact bounds %2 and %3 give "_s
        : u"the %1's bounds %2 and %3 give "_s;
    const QString bounds = pattern.arg(span.place.axis == SpanAxis::Column ? u"column"_s : u"row"_s,
                                       toText(span.lower), toText(span.upper));
    return span.firstSample < span.endSample
        ? bounds + u"the samples %1 … %2"_s.arg(span.firstSample).arg(span.endSample - 1)
        : bounds + u"no sample"_s;
}

QString triangleRefusalText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const bool isBesideBox = isUntested(attempt, *traced.trace);
    const bool isOfTruthAlone = attempt.written || isBesideBox || mayDecideOtherwise(traced)
        || isDecidedByOutline(attempt, *traced.trace);
    const QString untested = isBesideBox ? untestedText(attempt, traced) : QString();
    if (attempt.verdict.zeroArea)
        return segmentRefusalText(attempt, traced,
                                  isOfTruthAlone
                                      ? untested + u"The triangle has no area. In truth, %1."_s
                                      : u"The triangle has no area, and %1."_s);
    if (!noPartText(traced).isEmpty() && !attempt.isCentreRefused())
        return noPartText(traced);
    const std::size_t index = refusingEdge(attempt.verdict);
    const oracle::EdgeVerdict &refusing = attempt.verdict.edges[index];
    const QString &edge = attempt.edgeNames[index];
    if (!noPartText(traced).isEmpty())
        return partlyRefusedText(attempt, traced, refusing, edge);
    const QString own = ownReasonText(attempt, traced);
    if (refusing.edgeFunction == 0) {
        const QString ties = tiesText(attempt, traced, TieSide::Other);
        return untested + u"The sample lies %1."_s.arg(ties)
            + (own.contains(ties) ? QString() : own);
    }
    return untested
        + u"%1 %2: the sample is at %3, under the rule %4."_s.arg(
            isOfTruthAlone ? u"The truth refuses it by"_s : u"Refused by"_s, edge,
            distanceText(refusing, *traced.trace), nameText(nameOf(traced.scene.settings.fillRule)))
        + own;
}

} // namespace pixelplumb
