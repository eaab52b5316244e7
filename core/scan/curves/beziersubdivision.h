// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scan/curves/bezierdiamonds.h"
#include "core/scan/curves/flatpixel.h"
#include "core/scan/scanobserver.h"

/// A quadratic or cubic Bézier curve by recursive subdivision: de Casteljau's algorithm halves the
/// curve again and again, until a piece's pixels are decided: only those of its two ends. The curve
/// is one of the "other curves" (Rasterization slides, "Output Primitives") and of the splines
/// (Scan Conversion slides, "Polygons"). All numbers are exact, so that no rounding of a piece's
/// ends moves the curve.
namespace pixelplumb {

struct BezierSetUp {
    std::size_t count = 3; ///< control points
    int deepest = 0; ///< the most cuts that lead to a piece
};

/// One piece that was looked at.
struct BezierStep {
    std::int64_t number = 0;
    BezierPiece piece;
    BezierVerdict verdict = BezierVerdict::Undecided;
    /// The pixels of a decided piece's two ends, if they have any, px.
    std::optional<LatticePoint> from, to;
    std::optional<LatticePoint> corner; ///< if the piece passes through a corner
};

struct BezierNumbers {
    using SetUp = BezierSetUp;
    using Span = BezierStep;
    using Sample = FlatSample;
};

/// After this many cuts a piece meets borders at one parameter only (resources/numerics.md, 3.6).
inline int deepestCut(const BezierPiece &whole)
{
    const auto bits = [&](int sign) {
        BezierControls sums;
        for (std::size_t i = 0; i < whole.count; ++i)
            sums[i] = whole.y[i] + sign * whole.x[i];
        const auto [low, high]
            = std::minmax_element(sums.begin(), sums.begin() + std::ptrdiff_t(whole.count));
        const BigInteger extent = *high - *low;
        return extent > 0 ? 4 + int(msb(extent)) : 4;
    };
    return 10 + 5 * (bits(1) + bits(-1));
}

template <ScanObserver<BezierNumbers> Observer>
class BezierScan {
public:
    BezierScan(const Shape &curve, FrameView frame, Observer observer)
        : m_curve(curve)
        , m_frame(frame)
        , m_observer(observer)
    {
    }

    void run()
    {
        BezierPiece whole;
        whole.count = m_curve.vertices.size();
        for (std::size_t i = 0; i < whole.count; ++i) {
            whole.x[i] = m_curve.vertices[i].position.x;
            whole.y[i] = m_curve.vertices[i].position.y;
        }
        m_deepest = deepestCut(whole);
        m_observer.primitiveBegun(BezierSetUp{whole.count, m_deepest});
        if (!mayTouchFrame(whole)) {
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
            return;
        }
        scan(whole);
    }

private:
    void scan(const BezierPiece &piece)
    {
        if (!mayTouchFrame(piece))
            return;
        const BezierStep step = stepFor(piece);
        m_observer.spanEntered(step);
        if (step.verdict == BezierVerdict::Undecided) {
            for (const BezierPiece &half : halvesOf(piece))
                scan(half);
            return;
        }
        for (const auto &pixel : {step.from, step.corner, step.to}) {
            if (pixel && pixel != m_last)
                writeFlat(pixel->x, pixel->y, m_curve.vertices[0].colour, m_frame, m_observer);
            if (pixel)
                m_last = pixel;
        }
    }

    BezierStep stepFor(const BezierPiece &piece)
    {
        const BezierDiamonds diamonds(piece);
        BezierStep step;
        step.number = m_steps++;
        step.piece = piece;
        step.verdict = diamonds.verdict(piece);
        if (step.verdict == BezierVerdict::Undecided && piece.depth == m_deepest)
            step.verdict = BezierVerdict::ThroughCorner;
        if (step.verdict == BezierVerdict::Undecided)
            return step;
        // An end of the curve gets its nearest pixel even in a gap.
        step.from = piece.isFirst() ? nearest(m_curve.vertices.front()) : diamonds.firstPixel();
        step.to = piece.isLast() ? nearest(m_curve.vertices.back()) : diamonds.lastPixel();
        if (step.verdict == BezierVerdict::ThroughCorner)
            step.corner = diamonds.cornerPixel();
        return step;
    }

    /// A curve lies within the bounding box of its control points.
    bool mayTouchFrame(const BezierPiece &piece) const
    {
        const BigInteger pixel = piece.pixel();
        const auto meets = [&](const BezierControls &c, std::int64_t first, std::int64_t end) {
            const auto [low, high]
                = std::minmax_element(c.begin(), c.begin() + std::ptrdiff_t(piece.count));
            return *high >= (first - 1) * pixel && *low <= end * pixel;
        };
        return meets(piece.x, m_frame.firstColumn, m_frame.endColumn())
            && meets(piece.y, m_frame.firstRow, m_frame.endRow());
    }
    static LatticePoint nearest(const Vertex &vertex)
    {
        return {floorPixel(vertex.position.x + halfPixel),
                floorPixel(vertex.position.y + halfPixel)};
    }

    const Shape &m_curve;
    FrameView m_frame;
    Observer m_observer;
    std::int64_t m_steps = 0;
    int m_deepest = 0;
    std::optional<LatticePoint> m_last; ///< so that the pixel where two pieces meet is written once
};

} // namespace pixelplumb
