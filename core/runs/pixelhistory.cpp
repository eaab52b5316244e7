// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/pixelhistory.h"

#include "core/methods/rejectiontext.h"
#include "core/oracle/effecttruth.h"
#include "core/oracle/strokeoracle.h"
#include "core/runs/edgename.h"
#include "core/runs/formulaexplanation.h"
#include "core/runs/refusaltext.h"
#include "core/scan/choicenames.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

QString distanceText(const oracle::EdgeVerdict &edge)
{
    const bool alongColumn = !edge.distanceAlongColumn.isNone();
    const Quantity &exact = alongColumn ? edge.distanceAlongColumn : edge.distanceAlongRow;
    if (exact.isNone())
        return QStringLiteral("at no distance: the edge is a point");
    return QStringLiteral("%1 px measured along the %2 (%3 px square to the edge)")
        .arg(toText(exact), alongColumn ? QStringLiteral("column") : QStringLiteral("row"),
             QString::number(edge.distance, 'g', 6));
}

/// Which edge keeps the sample out, by how much, under which rule.
QString refusalText(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                    std::int64_t y)
{
    const FillRule rule = traced.scene.settings.fillRule;
    if (attempt.kind != PrimitiveKind::Triangle)
        return QStringLiteral("The %1 does not cover it.").arg(nameOf(attempt.kind));
    if (attempt.verdict.zeroArea) {
        return rule == FillRule::Closed
            ? QStringLiteral("The triangle has no area, and the sample is not on its segment.")
            : QStringLiteral("The triangle has no area: only the closed rule paints a segment.");
    }
    const auto refusing = std::ranges::min_element(
        attempt.verdict.edges, [](const oracle::EdgeVerdict &a, const oracle::EdgeVerdict &b) {
            return std::pair(a.accepts, a.distance) < std::pair(b.accepts, b.distance);
        });
    const QString &edge = attempt.edgeNames[std::size_t(refusing - attempt.verdict.edges.begin())];
    if (refusing->edgeFunction == 0)
        return QStringLiteral("The sample lies exactly on %1, and %2.")
            .arg(edge, tieText(traced, attempt.primitive, *refusing, x, y));
    return QStringLiteral("Refused by %1: the sample is at %2, under the rule %3.")
        .arg(edge, distanceText(*refusing), nameText(nameOf(rule)));
}

QString channelText(const PixelAttempt &attempt, std::size_t channel, QChar name)
{
    return QStringLiteral("%1 = %2 → %3")
        .arg(name)
        .arg(toText(attempt.sample->colour[channel]))
        .arg(std::clamp<std::int64_t>(attempt.sample->level[channel], 0, 255));
}

QString writtenText(const PixelAttempt &attempt)
{
    QString text = QStringLiteral("Writes %1, %2, %3.")
                       .arg(channelText(attempt, 0, u'R'), channelText(attempt, 1, u'G'),
                            channelText(attempt, 2, u'B'));
    if (attempt.sample->clamped)
        text += QStringLiteral(" A level left 0 … 255 and was clamped.");
    return text;
}

/// Why the kernel passed over a sample that the truth covers.
QString missedText(const PixelAttempt &attempt, const ScanTrace &trace)
{
    if (attempt.primitive >= trace.primitiveCount())
        return QStringLiteral("Not recorded: the recording ended at its limit before this pixel.");
    if (attempt.sample)
        return QStringLiteral("Missing: the truth covers it, but the kernel refused the sample.");
    if (trace.isCut())
        return QStringLiteral("Not recorded: the recording ended at its limit before this pixel.");
    if (!attempt.span)
        return QStringLiteral("Missing: the truth covers it, the kernel did not come here.");
    const SpanRecord &span = *attempt.span;
    if (span.lower.isNone())
        return QStringLiteral("Missing: the truth covers it, the kernel did not write it.");
    return QStringLiteral("Missing: the truth covers it, but the %1's bounds %2 and %3 give the "
                          "samples %4 … %5.")
        .arg(span.place.axis == SpanAxis::Column ? QStringLiteral("column") : QStringLiteral("row"),
             toText(span.lower), toText(span.upper))
        .arg(span.firstSample)
        .arg(span.endSample - 1);
}

/// What became of a sample on which more than coverage and colour were decided.
QString shadedText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    const TraceStep step = trace.stepAt(attempt.step);
    const QString told
        = trace.sampleWords(step.span, step.sample - trace.firstSampleOf(step.span)).sentence;
    if (!attempt.written)
        return told;
    const Colour colour = unpacked(attempt.change.after);
    QString text = QStringLiteral("Writes %1, %2, %3.")
                       .arg(colour.red())
                       .arg(colour.green())
                       .arg(colour.blue());
    if (!told.isEmpty())
        text += u' ' + told;
    if (attempt.sample->clamped)
        text += QStringLiteral(" A level left 0 … 255 and was clamped.");
    return text;
}

/// To what a run that departs from the right algorithm may owe its wrong pixels; empty of others.
QString variantText(const TracedScene &traced)
{
    const VariantSet variants = traced.scene.settings.variants;
    QStringList names;
    for (const Variant variant : allVariants) {
        if (variants.contains(variant))
            names.append(nameText(nameOf(variant)));
    }
    return names.isEmpty()
        ? QString()
        : QStringLiteral(" The run has the variant %1.").arg(names.join(QStringLiteral(", ")));
}

QString reasonOf(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                 std::int64_t y)
{
    if (attempt.primitive < traced.trace->primitiveCount()) {
        if (const auto rejection = traced.trace->setUp(attempt.primitive).rejection)
            return rejectionText(*rejection);
    }
    const bool isAntialiasedShape = attempt.kind != PrimitiveKind::Triangle
        && oracle::truthOf(traced.primitives.appearance).antialiasing != Antialiasing::None
        && traced.method->supports(Effect::Antialiasing);
    if ((traced.plan || isAntialiasedShape) && attempt.sample)
        return shadedText(attempt, traced);
    if (!attempt.written) {
        return attempt.verdict.covered ? missedText(attempt, *traced.trace) + variantText(traced)
                                       : refusalText(attempt, traced, x, y);
    }
    QString text = writtenText(attempt);
    if (!attempt.verdict.covered)
        return text + QStringLiteral(" Extra: the truth does not cover it. ")
            + refusalText(attempt, traced, x, y) + variantText(traced);
    if (attempt.kind != PrimitiveKind::Triangle)
        return text;
    const Colour exact
        = oracle::byteColourAt(traced.primitives.triangles[attempt.primitive], attempt.change.x,
                               attempt.change.y, traced.scene.settings.rounding);
    if (packed(exact) != attempt.change.after)
        text += QStringLiteral(" The exact colour is %1, %2, %3.")
                    .arg(exact.red())
                    .arg(exact.green())
                    .arg(exact.blue())
            + variantText(traced);
    return text;
}

/// The truth of one primitive at a pixel.
void judge(PixelAttempt &attempt, const TracedScene &traced, std::int64_t x, std::int64_t y)
{
    const Primitives &primitives = traced.primitives;
    if (attempt.kind == PrimitiveKind::Triangle)
        attempt.verdict = oracle::judge(primitives.triangles[attempt.primitive],
                                        boundaryRuleOf(traced.scene), x, y);
    else
        attempt.verdict.covered
            = oracle::covers(primitives.shape(attempt.primitive), primitives.appearance,
                             traced.scene.frame.origin, x, y);
}

/// What the run did there.
void recall(PixelAttempt &attempt, const ScanTrace &trace, std::int64_t x, std::int64_t y)
{
    if (attempt.primitive >= trace.primitiveCount())
        return;
    if (const auto visit = trace.visitOf(attempt.primitive, x, y)) {
        const std::size_t span = trace.spanOf(*visit);
        attempt.span = trace.span(span);
        attempt.spanHeading = spanHeading(trace, span);
        attempt.sample = trace.samples(span)[*visit - trace.firstSampleOf(span)];
        attempt.step = trace.indexOfSample(*visit);
        attempt.change = trace.changes()[*visit];
        attempt.written = attempt.change.isWritten();
        return;
    }
    auto span = trace.spanOn(attempt.primitive, SpanAxis::Column, x);
    if (!span)
        span = trace.spanOn(attempt.primitive, SpanAxis::Row, y);
    if (span) {
        attempt.span = trace.span(*span);
        attempt.spanHeading = spanHeading(trace, *span);
    }
}

/// Whether the truth or the run may have painted the pixel; false is sure, and quick to find.
bool mayHavePainted(const TracedScene &traced, std::size_t primitive, std::int64_t x,
                    std::int64_t y)
{
    const Primitives &primitives = traced.primitives;
    if (!primitives.isTriangle(primitive))
        return true;
    const auto &[a, b, c] = primitives.triangles[primitive].vertices;
    const auto isBetween = [](Lattice sample, Lattice p, Lattice q, Lattice r) {
        return sample >= std::min({p, q, r}) && sample <= std::max({p, q, r});
    };
    const LatticePoint sample = latticePixel(x, y);
    if (isBetween(sample.x, a.position.x, b.position.x, c.position.x)
        && isBetween(sample.y, a.position.y, b.position.y, c.position.y))
        return true;
    return primitive < traced.trace->primitiveCount()
        && traced.trace->visitOf(primitive, x, y).has_value();
}

PixelAttempt attemptOf(std::size_t primitive, const TracedScene &traced, std::int64_t x,
                       std::int64_t y)
{
    PixelAttempt attempt;
    attempt.primitive = primitive;
    attempt.kind = traced.primitives.kindOf(primitive);
    judge(attempt, traced, x, y);
    recall(attempt, *traced.trace, x, y);
    if (attempt.kind == PrimitiveKind::Triangle)
        attempt.exactColour = oracle::colourAt(traced.primitives.triangles[primitive], x, y);
    if (attempt.hasEdges()) {
        const SetUpRecord setUp = primitive < traced.trace->primitiveCount()
            ? traced.trace->setUp(primitive)
            : SetUpRecord();
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            attempt.edgeNames[edge]
                = edgeName(setUp, attempt.verdict.edges[edge].from, attempt.verdict.edges[edge].to);
    }
    attempt.reason = reasonOf(attempt, traced, x, y);
    return attempt;
}

} // namespace

std::vector<PixelAttempt> pixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y)
{
    return briefPixelHistory(traced, x, y, std::numeric_limits<std::size_t>::max()).attempts;
}

BriefPixelHistory briefPixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y,
                                    std::size_t listedRefusals)
{
    BriefPixelHistory history;
    std::size_t refusals = 0;
    for (std::size_t primitive = 0; primitive < traced.primitives.size(); ++primitive) {
        if (!traced.method->draws(traced.primitives.kindOf(primitive)))
            continue;
        if (refusals >= listedRefusals && !mayHavePainted(traced, primitive, x, y)) {
            ++history.furtherRefusals;
            continue;
        }
        PixelAttempt attempt = attemptOf(primitive, traced, x, y);
        const bool isRefusal = !attempt.written && !attempt.verdict.covered;
        if (isRefusal && ++refusals > listedRefusals)
            ++history.furtherRefusals;
        else
            history.attempts.push_back(std::move(attempt));
    }
    return history;
}

} // namespace pixelplumb
