// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/flatpixel.h"
#include "core/scan/linebresenham.h"

/// A quadratic or cubic Bézier curve by recursive subdivision: de Casteljau's algorithm cuts the
/// curve in its middle, again and again, until a piece is as good as straight; then a line is drawn
/// between its ends. The curve is one of the seeds' "other curves & free form surfaces" (seed 002,
/// "Output Primitives"; seed 003, "Splines, mathematical functions").
namespace pixelplumb {

/// The control points of a piece in units of 1/(256·2^(degree·depth)) px: each cut is exact.
struct BezierPiece {
    std::array<Int128, 4> x = {};
    std::array<Int128, 4> y = {};
    std::size_t count = 3; ///< control points: 3 or 4
    int depth = 0; ///< cuts that led here

    int degree() const { return int(count) - 1; }
    /// What 1 px is in the units of the control points.
    Int128 pixel() const { return Int128(unitsPerPixel) << (degree() * depth); }
};

struct BezierSetUp {
    std::size_t count = 3; ///< control points
};

/// One piece that was looked at.
struct BezierStep {
    std::int64_t number = 0;
    BezierPiece piece;
    /// No point of the piece is farther from its chord: n·(n − 1)/8 times the largest second
    /// difference of control points, 8ths of the piece's units.
    Int128 flatness = 0;
    bool isFlat = false;
    LatticePoint from, to; ///< px: the ends of the line that a flat piece is drawn as
};

struct BezierNumbers {
    using SetUp = BezierSetUp;
    using Span = BezierStep;
    using Sample = FlatSample;
};

/// The bound on the distance from the chord, in 8ths of the piece's units.
inline Int128 flatnessOf(const BezierPiece &piece)
{
    Int128 largest = 0;
    for (std::size_t i = 0; i + 2 < piece.count; ++i) {
        for (const auto &c : {piece.x, piece.y})
            largest = std::max(largest, absolute(c[i] - 2 * c[i + 1] + c[i + 2]));
    }
    return largest * piece.degree() * (piece.degree() - 1);
}

/// The two halves of one coordinate's control points, both scaled by 2^degree.
inline void halve(const std::array<Int128, 4> &whole, std::size_t count,
                  std::array<Int128, 4> &left, std::array<Int128, 4> &right)
{
    std::array<Int128, 4> sums = whole; // sums[i]: of level + 1 neighbours, binomially weighted
    for (std::size_t level = 0; level < count; ++level) {
        const Int128 scale = Int128(1) << (count - 1 - level);
        left[level] = sums[0] * scale;
        right[count - 1 - level] = sums[count - 1 - level] * scale;
        for (std::size_t i = 0; i + level + 1 < count; ++i)
            sums[i] += sums[i + 1];
    }
}

template <ScanObserver<BezierNumbers> Observer>
class BezierScan {
public:
    /// A piece is flat that lies within 1/4 px of its chord.
    static constexpr int flatParts = 4;

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
        m_observer.primitiveBegun(BezierSetUp{whole.count});
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
        BezierStep step;
        step.number = m_steps++;
        step.piece = piece;
        step.flatness = flatnessOf(piece);
        step.isFlat = step.flatness * flatParts <= 8 * piece.pixel();
        step.from = pixelAt(piece, 0);
        step.to = pixelAt(piece, piece.count - 1);
        m_observer.spanEntered(step);
        if (step.isFlat) {
            drawLine(step.from, step.to);
            return;
        }
        BezierPiece left = piece;
        left.depth = piece.depth + 1;
        BezierPiece right = left;
        halve(piece.x, piece.count, left.x, right.x);
        halve(piece.y, piece.count, left.y, right.y);
        scan(left);
        scan(right);
    }

    /// A curve lies within the bounding box of its control points.
    bool mayTouchFrame(const BezierPiece &piece) const
    {
        const Int128 pixel = piece.pixel();
        const auto meets
            = [&](const std::array<Int128, 4> &c, std::int64_t first, std::int64_t end) {
                  const auto [low, high]
                      = std::minmax_element(c.begin(), c.begin() + std::ptrdiff_t(piece.count));
                  return *high >= (first - 1) * pixel && *low <= end * pixel;
              };
        return meets(piece.x, m_frame.firstColumn, m_frame.endColumn())
            && meets(piece.y, m_frame.firstRow, m_frame.endRow());
    }
    static LatticePoint pixelAt(const BezierPiece &piece, std::size_t control)
    {
        const Int128 pixel = piece.pixel();
        const auto nearest = [&](Int128 coordinate) {
            return std::int64_t(floorDivide<Int128>(coordinate + pixel / 2, pixel));
        };
        return {nearest(piece.x[control]), nearest(piece.y[control])};
    }
    void drawLine(const LatticePoint &from, const LatticePoint &to)
    {
        const BresenhamSetUp line = bresenhamSetUp(from, to);
        const StepRange pixels = bresenhamPixelsIn(line, m_frame);
        if (pixels.isEmpty())
            return;
        BresenhamStep step = bresenhamStepAt(line, pixels.first);
        for (std::int64_t pixel = pixels.first; pixel < pixels.end; ++pixel) {
            writeFlat(step.place.x(), step.place.y(), m_curve.vertices[0].colour, m_frame,
                      m_observer);
            advance(line, step);
        }
    }

    const Shape &m_curve;
    FrameView m_frame;
    Observer m_observer;
    std::int64_t m_steps = 0;
};

} // namespace pixelplumb
