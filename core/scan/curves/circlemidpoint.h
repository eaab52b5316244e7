// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/curves/circleshape.h"
#include "core/scan/curves/flatpixel.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

#include <vector>

/// The midpoint circle and ellipse: Bresenham's idea on the implicit form (Scan Conversion slides,
/// "Lines and Curves: Implicit", F(x, y) = x² + y² − r²; Rasterization slides, "Résumé": adaptable
/// to circles, other curves). From the top, each step goes one column along, and the sign of F
/// half-way between two rows tells which of them is nearer. One octant of a circle is mirrored into
/// all eight; an ellipse has two kinds of arcs, each mirrored into four. Centre and radii are whole
/// pixels.
namespace pixelplumb {

/// An arc from an axis to where its slope is ±1, with x and y exchanged if steep so that it is
/// flat. F(x, y) = b²x² + a²y² − a²b²; decisions are 4·F, which is an integer between two rows.
template <class Integer>
struct MidpointArcOf {
    std::int64_t a = 0; ///< radius along the arc, px
    std::int64_t b = 0; ///< radius across, px
    Integer aa = Integer(a) * a; ///< a²
    Integer bb = Integer(b) * b; ///< b²
    /// The largest decision that stays in the row: 0. With StayAtZero a circle's p = F − ¼ is an
    /// integer, and p ≤ 0 stays: up to a decision of r².
    Integer mostStay = 0;

    /// 4·F(x, y − 1/2): positive where the midpoint below row y is outside, so that y − 1 is
    /// nearer.
    Integer decision(std::int64_t x, std::int64_t y) const
    {
        const Integer between = 2 * Integer(y) - 1;
        return 4 * bb * x * x + aa * between * between - 4 * aa * bb;
    }
    /// Whether the arc reaches this column: up to x = a²/√(a² + b²), rounded.
    bool reaches(std::int64_t x) const
    {
        const Integer beyond = 2 * Integer(x) - 1;
        return x <= a && (x == 0 || beyond * beyond * (aa + bb) <= 4 * aa * aa);
    }
    /// One past the last column.
    std::int64_t endColumn() const
    {
        std::int64_t last = 0;
        for (std::int64_t bit = std::int64_t(1) << 31; bit > 0; bit >>= 1)
            last += reaches(last + bit) ? bit : 0;
        return last + 1;
    }
};
using MidpointArc = MidpointArcOf<Int128>;

struct MidpointSetUp {
    LatticePoint centre; ///< px
    std::int64_t radiusX = 0; ///< px
    std::int64_t radiusY = 0;

    bool staysAtZero = false; ///< stays where p = 0; p = F − ¼ for a circle
    bool isCircle() const { return radiusX == radiusY; }
    template <class Integer = Int128>
    MidpointArcOf<Integer> arc(int number) const
    {
        MidpointArcOf<Integer> shape{radiusX, radiusY};
        if (number != 0)
            shape = {radiusY, radiusX};
        if (staysAtZero && isCircle())
            shape.mostStay = shape.aa;
        return shape;
    }
};

template <class Integer>
struct MidpointStepOf {
    int arc = 0; ///< of an ellipse: 0 flat, 1 steep
    std::int64_t x = 0; ///< x_k from the centre along the arc, px
    std::int64_t y = 0; ///< y_k from the centre across the arc, px
    bool hasDecision = false; ///< a decision led here: not at an arc's first step
    bool isEntry = false; ///< the frame does not show the step before
    std::int64_t down = 0; ///< rows that the decision moved inwards
    Integer decision = 0; ///< p_k−1 in units of decisionUnit
    Integer nextDecision = 0; ///< p_k
    /// The decision that stands for F = 1: 4, or 4·r² for a circle, whose F is x² + y² − r².
    Int128 decisionUnit = 4;

    /// Whether decisions use F = x² + y² − r² instead of F = b²x² + a²y² − a²b².
    bool isScaled() const { return decisionUnit != 4; }
};
using MidpointStep = MidpointStepOf<Int128>;

/// Whether it is the only step, that of two radii of 0: nothing decides.
template <class Integer>
bool isOnePixel(const MidpointStepOf<Integer> &step)
{
    return !step.hasDecision && step.x == 0 && step.y == 0 && step.nextDecision == 0;
}

template <class Integer>
struct MidpointNumbersOf {
    using SetUp = MidpointSetUp;
    using Span = MidpointStepOf<Integer>;
    using Sample = FlatSample;
};
using MidpointNumbers = MidpointNumbersOf<Int128>;

/// A step of the arc, computed without those before it: its row by bisection.
template <class Integer>
MidpointStepOf<Integer> midpointStepAt(const MidpointArcOf<Integer> &arc, int number,
                                       std::int64_t x)
{
    MidpointStepOf<Integer> step;
    step.arc = number;
    step.x = x;
    step.decisionUnit = 4 * (arc.a == arc.b ? std::max<Int128>(1, Int128(arc.a) * arc.a) : 1);
    for (std::int64_t bit = std::int64_t(1) << 31; bit > 0; bit >>= 1) {
        if (step.y + bit <= arc.b && arc.decision(x, step.y + bit) <= arc.mostStay)
            step.y += bit;
    }
    step.nextDecision = arc.decision(x + 1, step.y);
    return step;
}

/// Goes one column along, and a row down while the midpoint is outside. Past slope 1 and on slim
/// ellipses that can be several rows.
template <class Integer>
void advance(const MidpointArcOf<Integer> &arc, MidpointStepOf<Integer> &step)
{
    step.hasDecision = true;
    step.isEntry = false;
    step.decision = step.nextDecision;
    ++step.x;
    const std::int64_t before = step.y;
    for (; step.nextDecision > arc.mostStay && step.y > 0; --step.y)
        step.nextDecision -= 8 * arc.aa * (step.y - 1);
    step.down = before - step.y;
    step.nextDecision += 4 * arc.bb * (2 * Integer(step.x) + 1);
}

/// Writes the step's pixel and its mirror images, each once.
template <class Integer, class Observer>
void writeMirrored(const MidpointSetUp &setUp, const MidpointStepOf<Integer> &step,
                   const Colour &colour, FrameView frame, Observer observer)
{
    std::array<LatticePoint, 8> written;
    std::size_t count = 0;
    const auto write = [&](std::int64_t right, std::int64_t up) {
        const LatticePoint pixel = {setUp.centre.x + right, setUp.centre.y + up};
        const auto end = written.begin() + std::ptrdiff_t(count);
        if (std::find(written.begin(), end, pixel) != end)
            return;
        written[count++] = pixel;
        writeFlat(pixel.x, pixel.y, colour, frame, observer);
    };
    for (const int across : {1, -1}) {
        for (const int along : {1, -1}) {
            if (setUp.isCircle() || step.arc == 0)
                write(along * step.x, across * step.y);
            if (setUp.isCircle() || step.arc == 1)
                write(across * step.y, along * step.x);
        }
    }
}

/// The steps of an arc that touch the frame's columns (rows for the steep arcs), ascending.
template <class Integer>
std::vector<StepRange> midpointStepsIn(const MidpointSetUp &setUp,
                                       const MidpointArcOf<Integer> &arcShape, int arc,
                                       FrameView frame)
{
    std::vector<StepRange> ranges;
    const StepRange whole = {0, arcShape.endColumn()};
    const auto add = [&](StepRange shown, std::int64_t centre) {
        for (const StepRange range :
             {StepRange{shown.first - centre, shown.end - centre},
              StepRange{centre - shown.end + 1, centre - shown.first + 1}}) {
            if (const StepRange clipped = range.clippedTo(whole); !clipped.isEmpty())
                ranges.push_back(clipped);
        }
    };
    if (setUp.isCircle() || arc == 0)
        add(StepRange::along(frame, LineAxis::X), setUp.centre.x);
    if (setUp.isCircle() || arc == 1)
        add(StepRange::along(frame, LineAxis::Y), setUp.centre.y);
    std::ranges::sort(ranges, {}, &StepRange::first);
    std::vector<StepRange> merged;
    for (const StepRange &range : ranges) {
        if (!merged.empty() && range.first <= merged.back().end)
            merged.back().end = std::max(merged.back().end, range.end);
        else
            merged.push_back(range);
    }
    return merged;
}

template <class Integer, ScanObserver<MidpointNumbersOf<Integer>> Observer>
void scanCircleByMidpoint(const Shape &shape, VariantSet variants, FrameView frame,
                          Observer observer)
{
    const Round round = Round::of(shape);
    const auto nearest = [](Lattice units) { return floorPixel(units + unitsPerPixel / 2); };
    MidpointSetUp setUp;
    setUp.centre = {nearest(round.centre.x), nearest(round.centre.y)};
    setUp.radiusX = nearest(round.radiusX);
    setUp.radiusY = nearest(round.radiusY);
    setUp.staysAtZero = variants.contains(Variant::StayAtZero);
    observer.primitiveBegun(setUp);
    if (!round.mayTouch(frame)) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    for (int number = 0; number < (setUp.isCircle() ? 1 : 2); ++number) {
        const MidpointArcOf<Integer> arc = setUp.arc<Integer>(number);
        for (const StepRange &range : midpointStepsIn(setUp, arc, number, frame)) {
            // A later step than the arc's first shows the decision that led to it.
            const std::int64_t before = std::max<std::int64_t>(0, range.first - 1);
            MidpointStepOf<Integer> step = midpointStepAt(arc, number, before);
            if (before < range.first)
                advance(arc, step);
            step.isEntry = true;
            while (step.x < range.end) {
                [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
                observer.spanEntered(step);
                writeMirrored(setUp, step, shape.vertices[0].colour, frame, observer);
                advance(arc, step);
            }
        }
    }
}

} // namespace pixelplumb
