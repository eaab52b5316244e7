// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"
#include "core/scan/scanobserver.h"
#include "core/scan/spanaxis.h"
#include "core/scan/workstage.h"

/// Edge walking row by row (Rasterization slides and Scan Conversion slides, "Edge Walking") is the
/// column scan of the plane turned by a quarter to (u, v) = (−y, x): columns from left to right are
/// rows from the highest y to the lowest, and rules, trapezoids and increments are the column
/// scan's own. The rule (±ε², +ε) there is (+ε, ∓ε²) here: top-left, with the upper signs where y
/// points up.
namespace pixelplumb {

constexpr LatticePoint turned(const LatticePoint &point) { return {-point.y, point.x}; }

/// Keeps only the extreme vertices, in (x, y) order, of a triangle of zero area, which lies between
/// them by design: where vertices coincide, turning could change their order.
constexpr Triangle betweenExtremes(const Triangle &triangle)
{
    Triangle result = triangle;
    if (doubledArea(triangle) == 0) {
        const std::array<int, 3> order = sortedByColumn(triangle);
        result.vertices[std::size_t(order[1])] = result.vertices[std::size_t(order[2])];
    }
    return result;
}

constexpr Triangle turned(const Triangle &triangle)
{
    Triangle result = triangle;
    for (Vertex &vertex : result.vertices)
        vertex.position = turned(vertex.position);
    return result;
}

/// A frame seen in (u, v): each row of the frame is a column, the highest row first.
struct TurnedView {
    FrameView frame;
    std::int64_t firstColumn = 0; ///< −(the highest row)
    std::int64_t firstRow = 0;
    std::ptrdiff_t stride = 1; ///< pixels from v to v + 1: along the row

    explicit TurnedView(FrameView of)
        : frame(of)
        , firstColumn(1 - of.endRow())
        , firstRow(of.firstColumn)
    {
    }

    std::int64_t endColumn() const { return firstColumn + frame.height; }
    std::int64_t endRow() const { return firstRow + frame.width; }
    QRgb *at(std::int64_t u, std::int64_t v) const { return frame.at(v, -u); }
};

/// Passes on what a scan along an axis announces: pixels at their true positions; spans and set-ups
/// of a row scan stay turned.
template <SpanAxis axis, class Observer>
class AxisListener {
public:
    explicit AxisListener(Observer observer)
        : m_observer(observer)
    {
    }

    WorkStage enter(WorkStage stage) const requires HearsStages<Observer>
    {
        return m_observer.enter(stage);
    }
    template <class SetUp>
    void primitiveBegun(const SetUp &setUp)
    {
        m_observer.primitiveBegun(setUp);
    }
    void primitiveRejected(const Rejection &rejection) { m_observer.primitiveRejected(rejection); }
    template <class Span>
    void spanEntered(const Span &span)
    {
        m_observer.spanEntered(span);
    }
    template <class Sample>
    void sampleRejected(std::int64_t u, std::int64_t v, QRgb pixel, const Sample &sample)
    {
        m_observer.sampleRejected(isTurned ? v : u, isTurned ? -u : v, pixel, sample);
    }
    template <class Sample>
    void pixelWritten(std::int64_t u, std::int64_t v, QRgb before, QRgb after, const Sample &sample)
    {
        m_observer.pixelWritten(isTurned ? v : u, isTurned ? -u : v, before, after, sample);
    }

protected:
    static constexpr bool isTurned = axis == SpanAxis::Row;

    Observer m_observer;
};

template <SpanAxis axis, class Observer>
inline constexpr bool readsNumbers<AxisListener<axis, Observer>> = readsNumbers<Observer>;

} // namespace pixelplumb
