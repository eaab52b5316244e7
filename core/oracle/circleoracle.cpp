// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/circleoracle.h"

#include "core/number/wideproduct.h"
#include "core/oracle/truepixel.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

constexpr Lattice halfPixel = unitsPerPixel / 2;

/// The arcs along one axis: `a` is the radius along it, `b` the one across.
struct Arcs {
    Lattice a = 0;
    Lattice b = 0;

    /// Whether height <= h, h = b·√(1 − along²/a²) >= 0: squares of products, because a²·b² has up
    /// to 152 bits.
    bool reaches(Lattice along, Lattice height) const
    {
        if (height <= 0)
            return true;
        if (a == 0)
            return height <= b;
        return wideSquare(Int128(a) * height)
            <= wideProduct(UInt128(Int128(b) * (a - along)), UInt128(Int128(b) * (a + along)));
    }
    /// Whether the arcs with |slope| <= 1, which end at a²/√(a² + b²), come nearest to this column.
    bool haveColumn(Lattice along) const
    {
        if (along > a)
            return false;
        const Int128 beyond = along - halfPixel;
        return beyond <= 0
            || wideProduct(UInt128(beyond * beyond), UInt128(Int128(a) * a + Int128(b) * b))
            <= wideSquare(Int128(a) * a);
    }
    /// Whether the pixel is the one nearest to the upper or to the lower arc on its column.
    bool hold(Lattice along, Lattice across) const
    {
        const auto isNearest = [&](Lattice height) {
            return reaches(along, height - halfPixel) && !reaches(along, height + halfPixel);
        };
        return haveColumn(along) && (isNearest(across) || isNearest(-across));
    }
};

} // namespace

TrueEllipse::TrueEllipse(const Shape &shape)
    : m_centreX(shape.vertices[0].position.x)
    , m_centreY(shape.vertices[0].position.y)
    , m_a(shape.vertices[1].position.x - m_centreX)
    , m_b(shape.vertices[1].position.y - m_centreY)
{
}

bool TrueEllipse::outlineHolds(std::int64_t x, std::int64_t y) const
{
    const Lattice right = x * unitsPerPixel - m_centreX;
    const Lattice up = y * unitsPerPixel - m_centreY;
    return Arcs{m_a, m_b}.hold(absolute(right), up) || Arcs{m_b, m_a}.hold(absolute(up), right);
}

bool TrueEllipse::contains(std::int64_t x, std::int64_t y) const
{
    const Lattice right = absolute(x * unitsPerPixel - m_centreX);
    const Lattice up = absolute(y * unitsPerPixel - m_centreY);
    return right <= m_a && Arcs{m_a, m_b}.reaches(right, up);
}

bool ellipseCovers(const Shape &shape, std::int64_t x, std::int64_t y)
{
    const TrueEllipse truth(shape);
    return shape.fill == ShapeFill::Outline ? truth.outlineHolds(x, y) : truth.contains(x, y);
}

void drawEllipse(const Shape &shape, FrameView frame, CoverageMask &coverage)
{
    const TrueEllipse truth(shape);
    const LatticePoint centre = shape.vertices[0].position;
    const LatticePoint corner = shape.vertices[1].position;
    // The pixels of the bounding box and one around it.
    const auto first = [](Lattice low, Lattice high) { return floorPixel(2 * low - high) - 1; };
    const std::int64_t firstX
        = std::max<std::int64_t>(first(centre.x, corner.x), frame.firstColumn);
    const std::int64_t firstY = std::max<std::int64_t>(first(centre.y, corner.y), frame.firstRow);
    const std::int64_t endX = std::min(ceilPixel(corner.x) + 2, frame.endColumn());
    const std::int64_t endY = std::min(ceilPixel(corner.y) + 2, frame.endRow());
    for (std::int64_t y = firstY; y < endY; ++y) {
        for (std::int64_t x = firstX; x < endX; ++x) {
            const bool covered = shape.fill == ShapeFill::Outline ? truth.outlineHolds(x, y)
                                                                  : truth.contains(x, y);
            if (covered)
                writeTruePixel(frame, coverage, x, y, shape.vertices[0].colour);
        }
    }
}

} // namespace pixelplumb::oracle
