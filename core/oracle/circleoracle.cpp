// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/circleoracle.h"

#include "core/number/wideinteger.h"
#include "core/oracle/truepixel.h"

#include <algorithm>
#include <array>

namespace pixelplumb::oracle {

namespace {

/// Whether one product is at most the other.
template <class Wide>
bool isAtMost(const std::array<Int128, 2> &product, const std::array<Int128, 2> &other)
{
    return Wide(product[0]) * Wide(product[1]) <= Wide(other[0]) * Wide(other[1]);
}

/// The arcs along one axis: `a` is the radius along it, `b` the radius across.
struct Arcs {
    Lattice a = 0;
    Lattice b = 0;

    /// Whether height <= h, h = b·√(1 − along²/a²) >= 0.
    bool reaches(Lattice along, Lattice height) const
    {
        if (height <= 0)
            return true;
        if (a == 0)
            return height <= b;
        return isProductAtMost({Int128(a) * height, Int128(a) * height},
                               {Int128(b) * (a - along), Int128(b) * (a + along)});
    }
    /// Whether this column is among those nearest to the arcs with |slope| <= 1, which end at
    /// a²/√(a² + b²).
    bool haveColumn(Lattice along) const
    {
        if (along > a)
            return false;
        const Int128 beyond = along - halfPixel;
        return beyond <= 0
            || isProductAtMost({beyond * beyond, Int128(a) * a + Int128(b) * b},
                               {Int128(a) * a, Int128(a) * a});
    }
    /// Whether the pixel is the nearest one to the upper or lower arc on its column.
    bool hold(Lattice along, Lattice across) const
    {
        const auto isNearest = [&](Lattice height) {
            return reaches(along, height - halfPixel) && !reaches(along, height + halfPixel);
        };
        return haveColumn(along) && (isNearest(across) || isNearest(-across));
    }

private:
    /// The products have up to 156 bits; if all factors fit 62 bits, 128 hold them.
    static bool isProductAtMost(const std::array<Int128, 2> &product,
                                const std::array<Int128, 2> &other)
    {
        constexpr Int128 narrow = Int128(1) << 62;
        const bool isNarrow
            = product[0] < narrow && product[1] < narrow && other[0] < narrow && other[1] < narrow;
        return isNarrow ? isAtMost<Int128>(product, other) : isAtMost<Int256>(product, other);
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

void drawEllipse(const Shape &shape, FrameView frame)
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
                writeTruePixel(frame, x, y, shape.vertices[0].colour);
        }
    }
}

} // namespace pixelplumb::oracle
