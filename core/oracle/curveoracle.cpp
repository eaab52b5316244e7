// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/curveoracle.h"

#include "core/oracle/curvecells.h"
#include "core/oracle/lineoracle.h"
#include "core/oracle/truepixel.h"

namespace pixelplumb::oracle {

namespace {

using Integer = CurveExtent::Integer;

/// The window of requested pixels. Pixels are counted from its first one.
struct Window {
    std::int64_t firstColumn = 0;
    std::int64_t firstRow = 0;
    std::int64_t columns = 0;
    std::int64_t rows = 0;
};

/// A piece of the curve in a = x + y and b = y − x, moved by ½ px so that the squares begin at
/// whole pixels.
struct Piece {
    CurveControls a, b;
    int depth = 0; ///< halvings

    Integer pixel() const { return Integer(unitsPerPixel) << (a.degree() * std::size_t(depth)); }
    Piece leftHalf() const { return {a.leftHalf(), b.leftHalf(), depth + 1}; }
    Piece rightHalf() const { return {a.rightHalf(), b.rightHalf(), depth + 1}; }
};

/// The number of halvings after which parameter values that look equal are equal. Counted from any
/// border that a coordinate meets, the power coefficients are at most 8 times its extent in all
/// (their norm bounds M), the product of two has n ≤ 6, and 6^4/√3 < 2^10.
int deepest(const CurveControls &a, const CurveControls &b)
{
    const auto bits = [](const CurveControls &controls) {
        const Integer extent = controls.highest() - controls.lowest();
        return 3 + 1 + (extent > 0 ? int(msb(extent)) : 0);
    };
    return 10 + 5 * (bits(a) + bits(b));
}

/// Calls a function with every pixel of the curve in a window, some of them twice.
template <class Function>
class CurveWalk {
public:
    CurveWalk(const Piece &whole, const Window &window, const Function &function)
        : m_window(window)
        , m_deepest(deepest(whole.a, whole.b))
        , m_function(function)
    {
    }

    void walk(const Piece &piece) const
    {
        const Integer pixel = piece.pixel();
        const CurveExtent a(piece.a, pixel);
        const CurveExtent b(piece.b, pixel);
        if (isFar(a.cells(), b.cells()))
            return;
        if (piece.depth == m_deepest || meetAtOnce(piece, a, b)) {
            tellEnds(a, b);
            tell(a.cells().last, b.cells().last, a.meetsBorder() && b.meetsBorder());
        } else if (isSimple(piece.a, a, b) || isSimple(piece.b, b, a)) {
            tellEnds(a, b);
            for (std::int64_t i = a.cells().first; i <= a.cells().last; ++i) {
                for (std::int64_t j = b.cells().first; j <= b.cells().last; ++j)
                    tell(i, j, false);
            }
        } else {
            walk(piece.leftHalf());
            walk(piece.rightHalf());
        }
    }
    /// Reports the pixel if it is in the window, whose first one it is counted from.
    void tellPixel(std::int64_t right, std::int64_t up) const
    {
        if (right >= 0 && right < m_window.columns && up >= 0 && up < m_window.rows)
            m_function(m_window.firstColumn + right, m_window.firstRow + up);
    }

private:
    /// x = (a − b)/2 and y = (a + b)/2; a corner may report a pixel one further.
    bool isFar(const CellRange &a, const CellRange &b) const
    {
        return a.last - b.first < -2 || a.first - b.last > 2 * m_window.columns
            || a.last + b.last < -2 || a.first + b.first > 2 * m_window.rows;
    }

    /// One coordinate moves through its cells while the other stays in one: with the other clear of
    /// its border, there is no corner on the way except at the ends.
    static bool isSimple(const CurveControls &moving, const CurveExtent &across,
                         const CurveExtent &other)
    {
        return other.cells().isOne()
            && (across.cells().isOne() || (moving.isMonotone() && other.isClearOfLowBorder()));
    }
    /// Both cross their first border, and are equally far from it all the time.
    static bool meetAtOnce(const Piece &piece, const CurveExtent &a, const CurveExtent &b)
    {
        const auto crossesOne = [](const CurveExtent &extent) {
            return extent.cells().last == extent.cells().first + 1;
        };
        return crossesOne(a) && crossesOne(b) && piece.a.isMonotone() && piece.a.runsAlike(piece.b)
            && borderDistance(piece.a, a, piece) == borderDistance(piece.b, b, piece);
    }
    static Integer borderDistance(const CurveControls &controls, const CurveExtent &extent,
                                  const Piece &piece)
    {
        return abs(controls.first() - extent.cells().last * piece.pixel());
    }

    void tellEnds(const CurveExtent &a, const CurveExtent &b) const
    {
        tell(a.atFirst(), b.atFirst(), a.isFirstOnBorder() && b.isFirstOnBorder());
        tell(a.atLast(), b.atLast(), a.isLastOnBorder() && b.isLastOnBorder());
    }
    /// Reports a square that the curve visits, perhaps at its lowest corner, which is the left
    /// corner of the square below in b. Every second square is a pixel's, the others lie between
    /// four pixels.
    void tell(std::int64_t a, std::int64_t b, bool isAtCorner) const
    {
        if ((a + b) % 2 == 0)
            tellPixel((a - b) / 2, (a + b) / 2);
        else if (isAtCorner)
            tellPixel((a - b + 1) / 2, (a + b - 1) / 2);
    }

    Window m_window;
    int m_deepest;
    const Function &m_function;
};

template <class Function>
void forEachPixel(const Shape &curve, const Window &window, const Function &function)
{
    const std::size_t count = std::min<std::size_t>(curve.vertices.size(), 4);
    std::array<Integer, 4> a, b;
    for (std::size_t i = 0; i < count; ++i) {
        const Lattice x = curve.vertices[i].position.x - window.firstColumn * unitsPerPixel;
        const Lattice y = curve.vertices[i].position.y - window.firstRow * unitsPerPixel;
        a[i] = x + y + unitsPerPixel / 2;
        b[i] = y - x + unitsPerPixel / 2;
    }
    const Piece whole{CurveControls(a, count), CurveControls(b, count)};
    const CurveWalk walk(whole, window, function);
    walk.walk(whole);
    for (const std::size_t end : {std::size_t(0), count - 1}) {
        const LatticePoint pixel = nearestPixel(curve.vertices[end].position);
        walk.tellPixel(pixel.x - window.firstColumn, pixel.y - window.firstRow);
    }
}

} // namespace

bool curveCovers(const Shape &curve, std::int64_t x, std::int64_t y)
{
    bool covered = false;
    forEachPixel(curve, {x, y, 1, 1}, [&](std::int64_t, std::int64_t) { covered = true; });
    return covered;
}

void drawCurve(const Shape &curve, FrameView frame)
{
    forEachPixel(curve, {frame.firstColumn, frame.firstRow, frame.width, frame.height},
                 [&](std::int64_t x, std::int64_t y) {
                     writeTruePixel(frame, x, y, curve.vertices[0].colour);
                 });
}

} // namespace pixelplumb::oracle
