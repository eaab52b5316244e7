// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/polygons/contours.h"
#include "core/scan/lines/linesymmetric.h"

/// The outline of a polygon: each edge of its contours in turn as a line between any two lattice
/// points, by Bresenham's decisions (linesymmetric.h). The pixel of a whole-pixel vertex is written
/// by both of its edges. Where a vertex lies between pixels, each edge ends at the last column, or
/// row, before it, so that the pixel nearest to a corner may be missing.
namespace pixelplumb {

struct PolygonOutlineSetUp {
    std::size_t contourCount = 0;
    std::size_t edgeCount = 0;
};

/// One pixel of an edge.
template <class Integer>
struct PolygonOutlineStepOf : SymmetricStepOf<Integer> {
    std::size_t edge = 0; ///< its index in the contours, from 0
    SymmetricSetUpOf<Integer> line; ///< that edge's own set-up
};

template <class Integer>
struct PolygonOutlineNumbersOf {
    using SetUp = PolygonOutlineSetUp;
    using Span = PolygonOutlineStepOf<Integer>;
    using Sample = Fragment<ExactArithmetic<Integer>>;
};

/// Receives the line of one edge and reports it as part of the outline. It drops the rejection of
/// an edge outside the frame: the outline judges that.
template <class Integer, class Observer>
class EdgeListener {
public:
    EdgeListener(Observer observer, std::size_t edge, bool &entersFrame)
        : m_observer(observer)
        , m_entersFrame(&entersFrame)
    {
        m_step.edge = edge;
    }

    WorkStage enter(WorkStage stage) const requires HearsStages<Observer>
    {
        return m_observer.enter(stage);
    }
    void primitiveBegun(const SymmetricSetUpOf<Integer> &setUp) { m_step.line = setUp; }
    void primitiveRejected(const Rejection &) { }
    void spanEntered(const SymmetricStepOf<Integer> &step)
    {
        *m_entersFrame = true;
        static_cast<SymmetricStepOf<Integer> &>(m_step) = step;
        m_observer.spanEntered(m_step);
    }
    template <class Sample>
    void sampleRejected(std::int64_t x, std::int64_t y, QRgb pixel, const Sample &sample)
    {
        m_observer.sampleRejected(x, y, pixel, sample);
    }
    template <class Sample>
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb before, QRgb after, const Sample &sample)
    {
        m_observer.pixelWritten(x, y, before, after, sample);
    }

private:
    Observer m_observer;
    bool *m_entersFrame;
    PolygonOutlineStepOf<Integer> m_step;
};

template <class Integer, ScanObserver<PolygonOutlineNumbersOf<Integer>> Observer>
void scanPolygonOutline(const Contours &contours, ByteRounding rounding, FrameView frame,
                        Observer observer)
{
    observer.primitiveBegun(PolygonOutlineSetUp{contours.count, contours.edges.size()});
    bool entersFrame = false;
    Shape line;
    for (std::size_t index = 0; index < contours.edges.size(); ++index) {
        const ContourEdge &edge = contours.edges[index];
        line.vertices = {{edge.from, contours.colour}, {edge.to, contours.colour}};
        scanLineSymmetrically<Integer>(
            line, rounding, frame, EdgeListener<Integer, Observer>(observer, index, entersFrame));
    }
    if (!entersFrame)
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
}

} // namespace pixelplumb
