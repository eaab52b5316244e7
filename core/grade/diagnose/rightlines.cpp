// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/rightlines.h"

#include "core/grade/rounding/trianglemargin.h"
#include "core/oracle/oracle.h"
#include "core/runs/scenerun.h"

#include <algorithm>
#include <limits>
#include <set>

namespace pixelplumb {

namespace {

/// The error that rounding allows in a primitive's numbers: none in exact arithmetic.
class Drift {
public:
    Drift(const TracedScene &run, std::size_t primitive, const Margin &margin)
    {
        const bool isNone = margin.isStrict() || margin.tolerance == Arithmetic::Exact
            || !run.primitives.isTriangle(primitive);
        if (isNone)
            return;
        const Triangle &triangle = run.primitives.triangles[primitive];
        m_bound.emplace(triangle, margin.tolerance);
        m_margin.emplace(triangle, run.scene, margin);
    }

    double ofEnds(SpanAxis axis) const { return m_bound ? m_bound->endError(axis) : 0; }

    /// The largest of the three levels' errors.
    double ofLevels(std::int64_t x, std::int64_t y) const
    {
        double largest = 0;
        for (std::size_t channel = 0; m_bound && channel < 3; ++channel)
            largest = std::max(largest, m_bound->levelError(x, y, channel).value_or(anything));
        return largest;
    }

    /// False where drawing is optional.
    bool isDecided(std::int64_t x, std::int64_t y) const
    {
        return !m_margin || m_margin->containmentOf(x, y) != Containment::Undecided;
    }

    /// The frame's samples that may be drawn although the exact run does not draw them.
    SampleBox reachIn(const FrameSpec &frame) const
    {
        return m_bound ? m_bound->reachIn(frame) : SampleBox{};
    }

    static constexpr double anything = std::numeric_limits<double>::infinity();

private:
    std::optional<ArithmeticBound> m_bound;
    std::optional<TriangleMargin> m_margin;
};

/// False where a right program may draw none of the span's samples, and so may leave out its line.
bool isSureToDraw(const ScanTrace &trace, std::size_t index, const Drift &drift)
{
    return std::ranges::any_of(trace.samples(index), [&drift](const SampleRecord &record) {
        return record.fate == SampleFate::Written && drift.isDecided(record.x, record.y);
    });
}

/// Appends the pixels that a span writes.
void appendPixels(const ScanTrace &trace, std::size_t index, const Drift &drift,
                  std::vector<RightLine> &lines)
{
    const std::size_t primitive = trace.primitiveOf(index);
    std::size_t sample = trace.firstSampleOf(index);
    for (const SampleRecord &record : trace.samples(index)) {
        const std::size_t step = trace.indexOfSample(sample++);
        if (record.fate != SampleFate::Written)
            continue;
        lines.push_back({{std::nullopt, record.x, record.y},
                         primitive,
                         step,
                         {record.colour.begin(), record.colour.end()},
                         drift.ofLevels(record.x, record.y),
                         drift.isDecided(record.x, record.y)});
    }
}

/// Appends the columns or rows of a triangle in the frame that the run skipped because they hold no
/// pixel; `own`: the first of its lines.
void appendPassedOver(const TracedScene &run, std::size_t primitive, SpanAxis axis,
                      const Drift &drift, std::size_t own, std::vector<RightLine> &lines)
{
    if (!run.primitives.isTriangle(primitive))
        return;
    const bool isColumn = axis == SpanAxis::Column;
    Triangle triangle = run.primitives.triangles[primitive];
    if (!isColumn) {
        for (Vertex &vertex : triangle.vertices)
            std::swap(vertex.position.x, vertex.position.y);
    }
    std::set<Place> there;
    for (std::size_t i = own; i < lines.size(); ++i)
        there.insert(lines[i].place);
    const FrameSpec &frame = run.scene.frame;
    const std::int64_t first = isColumn ? frame.firstColumn : frame.firstRow;
    const std::int64_t end = first + (isColumn ? frame.width : frame.height);
    for (std::int64_t at = first; at < end; ++at) {
        const Place place = isColumn ? Place{axis, at, 0} : Place{axis, 0, at};
        const auto bounds = there.contains(place)
            ? std::nullopt
            : oracle::columnAt(triangle, FillRule::Closed, at);
        if (bounds)
            lines.push_back({place,
                             primitive,
                             run.trace->indexOfSetUp(primitive),
                             {bounds->yBottom, bounds->yTop},
                             drift.ofEnds(axis),
                             false});
    }
}

/// Appends the pixels that rounding may add to a primitive, with any levels; `own`: the first of
/// its lines.
void appendUndecided(const TracedScene &run, std::size_t primitive, const Drift &drift,
                     std::size_t own, std::vector<RightLine> &lines)
{
    std::set<Place> written;
    for (std::size_t i = own; i < lines.size(); ++i)
        written.insert(lines[i].place);
    const std::size_t step = run.trace->indexOfSetUp(primitive);
    const SampleBox box = drift.reachIn(run.scene.frame);
    for (std::int64_t y = box.firstY; y < box.endY; ++y) {
        for (std::int64_t x = box.firstX; x < box.endX; ++x) {
            const Place place{std::nullopt, x, y};
            if (!written.contains(place) && !drift.isDecided(x, y))
                lines.push_back(
                    {place, primitive, step, std::vector<Quantity>(3), Drift::anything, false});
        }
    }
}

} // namespace

std::shared_ptr<const TracedScene> rightRunOf(Scene scene, const LineKinds &kinds)
{
    const auto runOf = [&]() -> std::shared_ptr<const TracedScene> {
        const Method *method = methodNamed(QString::fromStdString(scene.method));
        scene.settings.arithmetic = Arithmetic::Exact;
        scene.settings.variants = {};
        return method && objectionTo(scene).isEmpty() ? traceScene(scene) : nullptr;
    };
    const auto hasBounds = [](const ScanTrace &trace, SpanAxis axis) {
        for (std::size_t i = 0; i < trace.spanCount(); ++i) {
            if (trace.placeOf(i).axis == axis && !trace.span(i).lower.isNone())
                return true;
        }
        return trace.spanCount() == 0;
    };
    auto run = runOf();
    const bool isEnough = run && (!kinds.hasColumns || hasBounds(*run->trace, SpanAxis::Column))
        && (!kinds.hasRows || hasBounds(*run->trace, SpanAxis::Row));
    if (isEnough)
        return run;
    scene.method = kinds.hasRows ? "row-walk" : "column-scan";
    return runOf();
}

std::vector<RightLine> rightLinesOf(const TracedScene &run, const LineKinds &kinds,
                                    const Margin &margin)
{
    const ScanTrace &trace = *run.trace;
    std::vector<RightLine> lines;
    for (std::size_t primitive = 0; primitive < trace.primitiveCount(); ++primitive) {
        const Drift drift(run, primitive, margin);
        const std::size_t own = lines.size();
        for (std::size_t i = trace.firstSpanOf(primitive); i < trace.endSpanOf(primitive); ++i) {
            const SpanRecord span = trace.span(i);
            const SpanAxis axis = span.place.axis;
            const bool isColumn = axis == SpanAxis::Column;
            const bool isWanted
                = isColumn ? kinds.hasColumns : axis == SpanAxis::Row && kinds.hasRows;
            if (isWanted && !span.lower.isNone()) {
                const std::int64_t at = span.place.coordinate;
                lines.push_back({isColumn ? Place{axis, at, 0} : Place{axis, 0, at},
                                 primitive,
                                 trace.indexOfSpan(i),
                                 {span.lower, span.upper},
                                 drift.ofEnds(axis),
                                 isSureToDraw(trace, i, drift)});
            }
            if (kinds.hasPixels)
                appendPixels(trace, i, drift, lines);
        }
        if (kinds.hasColumns)
            appendPassedOver(run, primitive, SpanAxis::Column, drift, own, lines);
        if (kinds.hasRows)
            appendPassedOver(run, primitive, SpanAxis::Row, drift, own, lines);
        if (kinds.hasPixels)
            appendUndecided(run, primitive, drift, own, lines);
    }
    return lines;
}

} // namespace pixelplumb
