// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/number/three.h"
#include "core/scan/degeneratesegment.h"
#include "core/scan/scanobserver.h"
#include "core/scan/tests/edgetestwalker.h"
#include "core/scan/workstage.h"

/// Scan conversion by testing samples: each is inside or outside by three edge functions (Scan
/// Conversion slides, "Edge Equations: Code") or by the three weights that they give (Triangles
/// slides, "for all x do for all y do"; Rasterization slides, "Barycentric Coordinates of P (2D)").
/// One kernel serves all; its EdgeTestForm says which of the slides' variants it is.
namespace pixelplumb {

/// A sample of a triangle of zero area, about which edge functions say nothing.
template <class A>
TestedSample<A> segmentSampleAt(const DegenerateSegment &segment, std::int64_t x, std::int64_t y)
{
    TestedSample<A> sample;
    sample.ofSegment = true;
    sample.covered = segment.covers(x, y);
    if (!sample.covered)
        return sample;
    sample.colour = threeOf([&](std::size_t channel) {
        const auto [numerator, denominator] = segment.level(channel, x, y);
        return A::fraction(numerator, denominator);
    });
    return sample;
}

/// Colours the samples of a span that are inside. Forced inline, like its callers: a call would
/// keep the innermost numbers in memory.
template <class A, EdgeTestForm form, class Observer, class SampleAt>
[[gnu::always_inline]] inline void colourSpan(const EdgeTestSpan<A> &span, ByteRounding rounding,
                                              FrameView frame, Observer observer, SampleAt sampleAt)
{
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    constexpr bool isRow = form.order == LoopOrder::RowByRow;
    for (std::int64_t along = span.firstTested; along < span.endTested; ++along) {
        const std::int64_t x = isRow ? along : span.coordinate;
        const std::int64_t y = isRow ? span.coordinate : along;
        TestedSample<A> sample = sampleAt(x, y);
        QRgb *pixel = frame.at(x, y);
        if (sample.covered) {
            sample.level = threeOf(
                [&](std::size_t channel) { return A::level(sample.colour[channel], rounding); });
            const QRgb after = pixelOfLevels(sample.level);
            observer.pixelWritten(x, y, *pixel, after, sample);
            *pixel = after;
        } else {
            observer.sampleRejected(x, y, *pixel, sample);
        }
    }
}

/// Tests the samples of one span of a triangle that has area and colours those inside.
template <class A, EdgeTestForm form, class Observer>
[[gnu::always_inline]] inline void testTriangleSpan(const SpanWalker<A, form> &walker,
                                                    const EdgeTestSpan<A> &span,
                                                    ByteRounding rounding, FrameView frame,
                                                    Observer observer)
{
    EdgeTestSpan<A> numbers = span;
    colourSpan<A, form>(
        span, rounding, frame,
        observer, [&](std::int64_t x, std::int64_t y) __attribute__((always_inline)) {
            const TestedSample<A> sample = walker.sampleAt(x, y, numbers);
            if constexpr (SpanWalker<A, form>::isIncremental) {
                if constexpr (form.order == LoopOrder::RowByRow)
                    walker.stepX(numbers);
                else
                    walker.stepY(numbers);
            }
            return sample;
        });
}

/// Tests the samples of one span of a triangle of zero area.
template <class A, EdgeTestForm form, class Observer>
void testSegmentSpan(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span,
                     ByteRounding rounding, FrameView frame, Observer observer)
{
    const DegenerateSegment segment(Triangle{setUp.vertices});
    colourSpan<A, form>(span, rounding, frame, observer, [&](std::int64_t x, std::int64_t y) {
        return segmentSampleAt<A>(segment, x, y);
    });
}

/// Walks a span again, alone, with the same numbers: it reads only the set-up and the span.
template <class A, EdgeTestForm form, class Observer>
void testSpan(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span, ByteRounding rounding,
              FrameView frame, Observer observer)
{
    if (setUp.zeroArea)
        testSegmentSpan<A, form>(setUp, span, rounding, frame, observer);
    else
        testTriangleSpan(SpanWalker<A, form>(setUp), span, rounding, frame, observer);
}

/// Walks the spans of the box; `test(span)` tests the samples of one.
template <class A, EdgeTestForm form, class Observer, class Test, class Step>
[[gnu::always_inline]] inline void walkSpans(const EdgeTestSetUp<A> &setUp, EdgeTestSpan<A> span,
                                             Observer observer, Test test, Step stepToNext)
{
    constexpr bool isRow = form.order == LoopOrder::RowByRow;
    const SampleBox &box = setUp.tested;
    span.firstSample = isRow ? setUp.visited.firstX : setUp.visited.firstY;
    span.endSample = isRow ? setUp.visited.endX : setUp.visited.endY;
    span.firstTested = isRow ? box.firstX : box.firstY;
    span.endTested = isRow ? box.endX : box.endY;
    const std::int64_t end = isRow ? box.endY : box.endX;
    for (span.coordinate = isRow ? box.firstY : box.firstX; span.coordinate < end;
         ++span.coordinate) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        observer.spanEntered(span);
        test(span);
        stepToNext(span);
    }
}

/// Tests a triangle of zero area. Its set-up is a copy, so that the numbers of all other triangles
/// can stay in registers.
template <class A, EdgeTestForm form, class Observer>
[[gnu::noinline]] void testSegment(EdgeTestSetUp<A> setUp, ByteRounding rounding, FrameView frame,
                                   Observer observer)
{
    const auto test = [&](const EdgeTestSpan<A> &span) {
        testSegmentSpan<A, form>(setUp, span, rounding, frame, observer);
    };
    walkSpans<A, form>(setUp, {}, observer, test, [](EdgeTestSpan<A> &) {});
}

/// Tests the samples of one triangle.
template <class A, EdgeTestForm form, ScanObserver<EdgeTestNumbers<A>> Observer>
void testSamples(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                 Observer observer)
{
    const EdgeTestSetUp<A> setUp
        = edgeTestSetUp<A, form>(triangle, {settings, frame}, frame, settings.variants);
    observer.primitiveBegun(setUp);
    if (setUp.zeroArea && settings.fillRule != FillRule::Closed) {
        observer.primitiveRejected(PrimitiveRejection::ZeroArea);
        return;
    }
    if (setUp.tested.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    if (setUp.zeroArea) {
        testSegment<A, form>(setUp, settings.rounding, frame, observer);
        return;
    }
    using Walker = SpanWalker<A, form>;
    const Walker walker(setUp);
    EdgeTestSpan<A> first;
    if constexpr (Walker::isIncremental)
        walker.start(first, setUp.tested.firstX, setUp.tested.firstY);
    const auto test = [&](const EdgeTestSpan<A> &span) __attribute__((always_inline))
    {
        testTriangleSpan(walker, span, settings.rounding, frame, observer);
    };
    walkSpans<A, form>(
        setUp, first, observer, test, [&](EdgeTestSpan<A> & span) __attribute__((always_inline)) {
            if constexpr (Walker::isIncremental) {
                if constexpr (form.order == LoopOrder::RowByRow)
                    walker.stepY(span);
                else
                    walker.stepX(span);
            }
        });
}

} // namespace pixelplumb
