// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/wideinteger.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>

/// The pixels of a piece of a Bézier curve. A point of the curve belongs to the pixel nearer than ½
/// px to it in the distance |Δx| + |Δy|: the pixel's diamond. In a = x + y + ½ and b = y − x + ½
/// diamonds are unit squares with whole-number corners; as on a chessboard, every second square is
/// a diamond, the others are gaps between four.
namespace pixelplumb {

/// One coordinate of a piece's control points, or a sum or difference of both.
using BezierControls = std::array<BigInteger, 4>;

/// The control points of a piece of a Bézier curve in units of 1/(256·2^(degree·depth)) px: each
/// cut is exact.
struct BezierPiece {
    BezierControls x = {};
    BezierControls y = {};
    std::size_t count = 3; ///< control points: 3 or 4
    int depth = 0; ///< cuts that led here
    BigInteger part = 0; ///< the piece runs from t = part/2^depth to (part + 1)/2^depth

    int degree() const { return int(count) - 1; }
    /// 1 px in the units of the control points.
    BigInteger pixel() const { return BigInteger(unitsPerPixel) << (degree() * depth); }
    bool isFirst() const { return part == 0; }
    bool isLast() const { return part + 1 == BigInteger(1) << depth; }
};

/// The two halves of one coordinate's control points, both scaled by 2^degree.
inline void halve(const BezierControls &whole, std::size_t count, BezierControls &left,
                  BezierControls &right)
{
    BezierControls sums = whole; // sums[i]: of level + 1 neighbours, binomially weighted
    for (std::size_t level = 0; level < count; ++level) {
        left[level] = sums[0] << (count - 1 - level);
        right[count - 1 - level] = sums[count - 1 - level] << (count - 1 - level);
        for (std::size_t i = 0; i + level + 1 < count; ++i)
            sums[i] += sums[i + 1];
    }
}

/// De Casteljau's cut in the middle.
inline std::array<BezierPiece, 2> halvesOf(const BezierPiece &piece)
{
    std::array<BezierPiece, 2> halves = {piece, piece};
    for (std::size_t half = 0; half < 2; ++half) {
        halves[half].depth = piece.depth + 1;
        halves[half].part = 2 * piece.part + half;
    }
    halve(piece.x, piece.count, halves[0].x, halves[1].x);
    halve(piece.y, piece.count, halves[0].y, halves[1].y);
    return halves;
}

/// One of the coordinates a and b of a piece's control points, in squares.
struct DiamondExtent {
    std::int64_t atFirst = 0, atLast = 0; ///< the squares of the piece's two ends
    std::int64_t lowest = 0, highest = 0; ///< of all control points
    bool firstOnBorder = false, lastOnBorder = false; ///< whether an end lies where a square begins
    bool lowOnBorder = false;
    bool isMonotone = false;
    bool isConstant = false;

    DiamondExtent(const BezierControls &controls, std::size_t count, const BigInteger &pixel)
    {
        const auto end = controls.begin() + std::ptrdiff_t(count);
        const auto [low, high] = std::minmax_element(controls.begin(), end);
        const auto squareOf
            = [&](const BigInteger &c) { return std::int64_t(floorDivide<BigInteger>(c, pixel)); };
        atFirst = squareOf(controls[0]);
        atLast = squareOf(controls[count - 1]);
        lowest = squareOf(*low);
        // A curve reaches its highest control point only at an end.
        highest = std::max({atFirst, atLast, squareOf(*high - 1)});
        firstOnBorder = controls[0] % pixel == 0;
        lastOnBorder = controls[count - 1] % pixel == 0;
        lowOnBorder = *low % pixel == 0;
        isConstant = *low == *high;
        isMonotone = std::is_sorted(controls.begin(), end)
            || std::is_sorted(controls.begin(), end, std::greater<>());
    }

    bool isWithinOne() const { return lowest == highest; }
    bool passesOneBorder() const { return highest == lowest + 1 && isMonotone; }
    /// While the other coordinate passes a border, no corner is passed.
    bool isClearOfBorders() const { return isWithinOne() && !lowOnBorder; }
    bool runsAlongBorder() const { return isConstant && lowOnBorder; }
};

/// What is known of a piece's pixels.
enum class BezierVerdict {
    Undecided, ///< it may have pixels that its ends do not have
    WithinSquare, ///< it stays within one diamond, or one gap
    AcrossBorder, ///< it passes one border of one diamond
    ThroughCorner, ///< it meets a point where four squares meet, or touches a border
};

/// Where a piece lies among the diamonds.
class BezierDiamonds {
public:
    explicit BezierDiamonds(const BezierPiece &piece)
        : BezierDiamonds(piece, piece.pixel())
    {
    }

    /// The verdict without further halving. Where the curve touches a border or meets two at once,
    /// halving may never decide; there it may be known without halving that the borders meet.
    BezierVerdict verdict(const BezierPiece &piece) const
    {
        if (m_a.isWithinOne() && m_b.isWithinOne())
            return BezierVerdict::WithinSquare;
        if ((m_a.passesOneBorder() && m_b.isClearOfBorders())
            || (m_b.passesOneBorder() && m_a.isClearOfBorders()))
            return BezierVerdict::AcrossBorder;
        if ((m_a.passesOneBorder() && m_b.runsAlongBorder())
            || (m_b.passesOneBorder() && m_a.runsAlongBorder())
            || (m_a.passesOneBorder() && m_b.passesOneBorder() && runsBetweenPixels(piece)))
            return BezierVerdict::ThroughCorner;
        return BezierVerdict::Undecided;
    }

    const DiamondExtent &alongA() const { return m_a; }
    const DiamondExtent &alongB() const { return m_b; }

    std::optional<LatticePoint> firstPixel() const
    {
        return owner(m_a.atFirst, m_b.atFirst, m_a.firstOnBorder && m_b.firstOnBorder);
    }
    std::optional<LatticePoint> lastPixel() const
    {
        return owner(m_a.atLast, m_b.atLast, m_a.lastOnBorder && m_b.lastOnBorder);
    }
    /// The pixel at the corner that a ThroughCorner piece meets, or at the border that the smallest
    /// piece touches.
    std::optional<LatticePoint> cornerPixel() const
    {
        return owner(m_a.highest, m_b.highest, meetsBorder(m_a) && meetsBorder(m_b));
    }

private:
    BezierDiamonds(const BezierPiece &piece, const BigInteger &pixel)
        : m_a(sum(piece, pixel), piece.count, pixel)
        , m_b(difference(piece, pixel), piece.count, pixel)
    {
    }

    static BezierControls sum(const BezierPiece &piece, const BigInteger &pixel)
    {
        BezierControls a;
        for (std::size_t i = 0; i < piece.count; ++i)
            a[i] = piece.x[i] + piece.y[i] + pixel / 2;
        return a;
    }
    static BezierControls difference(const BezierPiece &piece, const BigInteger &pixel)
    {
        BezierControls b;
        for (std::size_t i = 0; i < piece.count; ++i)
            b[i] = piece.y[i] - piece.x[i] + pixel / 2;
        return b;
    }

    /// Whether it is straight along x = m + ½ or y = m + ½, where a and b meet borders together.
    static bool runsBetweenPixels(const BezierPiece &piece)
    {
        const auto isHalf = [&](const BezierControls &controls) {
            const auto end = controls.begin() + std::ptrdiff_t(piece.count);
            const bool isConstant
                = std::adjacent_find(controls.begin(), end, std::not_equal_to<>()) == end;
            const BigInteger pixel = piece.pixel();
            return isConstant && (controls[0] - pixel / 2) % pixel == 0;
        };
        return isHalf(piece.x) || isHalf(piece.y);
    }
    static bool meetsBorder(const DiamondExtent &extent)
    {
        return !extent.isWithinOne() || extent.lowOnBorder;
    }

    /// The pixel whose diamond this square is or, at the lowest corner of a gap, whose diamond has
    /// that corner on its left: at exactly ½ px the upper pixel owns a point, then the right one.
    static std::optional<LatticePoint> owner(std::int64_t a, std::int64_t b, bool isAtCorner)
    {
        if ((a + b) % 2 != 0 && !isAtCorner)
            return std::nullopt;
        if ((a + b) % 2 != 0)
            --b;
        return LatticePoint{(a - b) / 2, (a + b) / 2};
    }

    DiamondExtent m_a, m_b;
};

} // namespace pixelplumb
