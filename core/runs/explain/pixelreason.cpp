// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/pixelreason.h"

#include "core/geometry/triangle.h"
#include "core/methods/words/formulatext.h"
#include "core/methods/words/rejectiontext.h"
#include "core/oracle/effecttruth.h"
#include "core/runs/contender.h"
#include "core/runs/explain/edgerefusal.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/explain/refusaltext.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "core/runs/explain/segmenttext.h"
#include "core/runs/explain/shapereason.h"
#include "core/scan/choicenames.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int64_t largestRedrawn = std::int64_t(1) << 18; ///< px, in less than a millisecond

QRgb pixelUnder(VariantSet variants, const PixelAttempt &attempt, const TracedScene &traced)
{
    ScanSettings settings = traced.scene.settings;
    settings.variants = variants;
    const FrameBuffer frame(traced.scene.frame);
    Run(traced.method, aloneOf(traced.primitives, attempt.primitive), settings, frame.view())
        .draw(frame.view());
    return *frame.view().at(attempt.x, attempt.y);
}

/// The variants without which the primitive would treat the pixel differently. All, if only several
/// together make the difference or the frame is too large to test each.
std::vector<Variant> variantsToBlame(const PixelAttempt &attempt, const TracedScene &traced)
{
    const VariantSet set = traced.scene.settings.variants;
    const FrameSpec &frame = traced.scene.frame;
    const std::vector<Variant> all = variantsIn(set);
    if (std::int64_t(frame.width) * frame.height > largestRedrawn)
        return all;
    const QRgb drawn = pixelUnder(set, attempt, traced);
    std::vector<Variant> blamed;
    for (const Variant variant : all) {
        if (pixelUnder(set.without(variant), attempt, traced) != drawn)
            blamed.push_back(variant);
    }
    return blamed.empty() && all.size() > 1 ? all : blamed;
}

/// What may make a pixel wrong in a run that departs from the correct algorithm; else empty.
QString variantText(const PixelAttempt &attempt, const TracedScene &traced)
{
    QString text;
    for (const Variant variant : variantsToBlame(attempt, traced)) {
        const VariantWords &words = wordsOf(variant, traced.method->spanAxis);
        text += u" The run has the variant “%1”: %2 in place of %3. %4"_s.arg(
            nameText(words.title), nameText(words.printed), nameText(words.right),
            nameText(words.fault));
    }
    return text;
}

/// What keeps a sample out: an edge of a triangle, or what the kernel found of a shape.
QString refusalText(const PixelAttempt &attempt, const TracedScene &traced)
{
    if (attempt.kind == PrimitiveKind::Triangle)
        return triangleRefusalText(attempt, traced);
    const QString found = attempt.written ? QString() : visitText(attempt, *traced.trace);
    const QString uncovered = u"The %1 does not cover it."_s.arg(nameOf(attempt.kind));
    return (found.isEmpty() && !attempt.written ? uncovered : found)
        + (attempt.written ? stepOfPixelText(attempt, traced) : stepBesideText(attempt, traced))
        + tieOfShapeText(attempt, traced);
}

QString channelText(const PixelAttempt &attempt, std::size_t channel, QChar name)
{
    return u"%1 = %2 → %3"_s.arg(name)
        .arg(toText(attempt.sample->colour[channel]))
        .arg(std::clamp<std::int64_t>(attempt.sample->level[channel], 0, 255));
}

QString writtenText(const PixelAttempt &attempt)
{
    QString text
        = u"Writes %1, %2, %3."_s.arg(channelText(attempt, 0, u'R'), channelText(attempt, 1, u'G'),
                                      channelText(attempt, 2, u'B'));
    if (attempt.sample->clamped)
        text += u" A level went outside 0 … 255 and was clamped."_s;
    return text;
}

/// The edges, or the segment of a triangle without area, on which a written sample lies, and why
/// they are the triangle's own; empty where no rule gives an edge to one of its sides.
QString keptTiesText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const FillRule rule = traced.scene.settings.fillRule;
    if (attempt.verdict.zeroArea)
        return u" The triangle has no area, and %1."_s.arg(
            segmentText(traced.primitives.triangles[attempt.primitive], attempt.x, attempt.y));
    if (rule == FillRule::Closed || rule == FillRule::Open)
        return {};
    const QString ties = tiesText(attempt, traced, TieSide::This);
    return ties.isEmpty() ? ties : u" The sample lies %1."_s.arg(ties);
}

/// The numbers by which the kernel took a sample of a triangle that the truth refuses; empty if it
/// tests no samples.
QString acceptingText(const PixelAttempt &attempt, const TracedScene &traced)
{
    if (attempt.kind != PrimitiveKind::Triangle)
        return {};
    QStringList accepted;
    for (const SampleDecision &decision :
         decisionsOf(traced.trace->numbers().sample, *attempt.sample)) {
        if (!decision.value.isNone())
            accepted.append(u"%1 = %2"_s.arg(decision.title, term(decision.value)));
    }
    return accepted.isEmpty()
        ? QString()
        : u" The run accepted it by its own numbers: %1."_s.arg(accepted.join(u", "_s));
}

/// Why the kernel passed over a sample that the truth covers.
QString missedText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    if (attempt.primitive >= trace.primitiveCount())
        return u"Not recorded: the recording ended at its limit before this pixel."_s;
    if (attempt.sample)
        return u"Missing: the truth covers it, but the kernel refused the sample."_s
            + (attempt.kind == PrimitiveKind::Triangle ? deciderText(attempt, traced) : QString());
    if (trace.isCut())
        return u"Not recorded: the recording ended at its limit before this pixel."_s;
    if (!attempt.span)
        return u"Missing: the truth covers it, the kernel did not come here."_s
            + stepBesideText(attempt, traced);
    if (attempt.kind == PrimitiveKind::Line)
        return u"Missing: the truth covers it, but the line's pixel here is another."_s
            + stepBesideText(attempt, traced) + tieOfShapeText(attempt, traced);
    const SpanRecord &span = *attempt.span;
    const std::int64_t place = span.place.axis == SpanAxis::Column ? attempt.y : attempt.x;
    if (span.lower.isNone() && (place < span.firstSample || place >= span.endSample)) {
        const QString decided = stepBesideText(attempt, traced);
        const QString line = span.place.axis == SpanAxis::Column ? u"column"_s : u"row"_s;
        if (!decided.isEmpty())
            return u"Missing: the truth covers it, but in this %1 the kernel fills "
                   "only the samples %2 … %3."_s.arg(line)
                       .arg(span.firstSample)
                       .arg(span.endSample - 1)
                + decided;
        // A box is clipped to the frame.
        return span.firstDrawn < span.endDrawn
            ? u"Missing: the truth covers it, but in this %1 the kernel tests only "
              "the samples %2 … %3."_s.arg(line)
                  .arg(span.firstDrawn)
                  .arg(span.endDrawn - 1)
            : u"Missing: the truth covers it, but in this %1 the kernel tests no "
              "sample of the frame."_s.arg(line);
    }
    if (span.lower.isNone())
        return u"Missing: the truth covers it, the kernel did not write it."_s;
    return u"Missing: the truth covers it, but %1."_s.arg(
        boundsText(span, traced.scene.settings.arithmetic));
}

/// What became of a sample that more than coverage and colour decided.
QString shadedText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const QString told = visitText(attempt, *traced.trace);
    if (!attempt.written)
        return told;
    const Colour colour = unpacked(attempt.change.after);
    QString text = u"Writes %1, %2, %3."_s.arg(colour.red()).arg(colour.green()).arg(colour.blue());
    if (!told.isEmpty())
        text += u' ' + told;
    if (attempt.sample->clamped)
        text += u" A level went outside 0 … 255 and was clamped."_s;
    return text;
}

bool isRejectedByKernel(const ScanTrace &trace, std::size_t primitive)
{
    return std::ranges::binary_search(trace.rejectedPrimitives(), primitive);
}

/// The sentences for any attempt.
QString sentencesOn(const PixelAttempt &attempt, const TracedScene &traced)
{
    // What a kernel found out about a sample says more than that it drew nothing.
    const bool isRefused = attempt.kind == PrimitiveKind::Triangle || attempt.sample.has_value();
    if (attempt.primitive < traced.trace->primitiveCount()) {
        const auto rejection = rejectionOf(traced, attempt.primitive);
        if (rejection && (!isRefused || isRejectedByKernel(*traced.trace, attempt.primitive)))
            return (attempt.verdict.covered ? u"Missing: the truth covers it. "_s : QString())
                + rejectionText(*rejection);
    }
    const bool isAntialiasedShape = attempt.kind != PrimitiveKind::Triangle
        && oracle::truthOf(traced.primitives.appearance).antialiasing != Antialiasing::None
        && traced.method->supports(Effect::Antialiasing);
    if ((traced.shading() || isAntialiasedShape) && attempt.sample)
        return shadedText(attempt, traced);
    const auto approximation = [&] { return approximationText(*traced.trace, attempt.primitive); };
    if (!attempt.written) {
        return attempt.verdict.covered
            ? missedText(attempt, traced) + variantText(attempt, traced) + approximation()
            : refusalText(attempt, traced);
    }
    QString text = writtenText(attempt);
    if (!attempt.verdict.covered)
        return text + u" Extra: the truth does not cover it"_s
            + (attempt.exactColour[0].isNone()
                   ? u". "_s
                   : u"; the true levels are those of %1. "_s.arg(
                       attempt.verdict.zeroArea ? u"its segment, prolonged"_s
                                                : u"the triangle's plane outside of it"_s))
            + refusalText(attempt, traced).trimmed() + acceptingText(attempt, traced)
            + variantText(attempt, traced) + approximation();
    if (attempt.kind != PrimitiveKind::Triangle)
        return text + stepOfPixelText(attempt, traced) + variantText(attempt, traced);
    text += keptTiesText(attempt, traced);
    if (isDecidedByOutline(attempt, *traced.trace))
        text += stepBesideText(attempt, traced);
    const Colour exact
        = oracle::byteColourAt(traced.primitives.triangles[attempt.primitive], attempt.change.x,
                               attempt.change.y, traced.scene.settings.rounding);
    if (packed(exact) != attempt.change.after)
        text += u" The true colour is %1, %2, %3."_s.arg(exact.red())
                    .arg(exact.green())
                    .arg(exact.blue())
            + variantText(attempt, traced);
    return text;
}

} // namespace

QString reasonOf(const PixelAttempt &attempt, const TracedScene &traced)
{
    return withMinus(sentencesOn(attempt, traced));
}

} // namespace pixelplumb
