// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <array>

namespace pixelplumb {

/// A point of a font's outline, in the font's units, y upward.
struct FontPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// Maps a font's units to lattice units: the start of the baseline, and the em's size.
struct FontScale {
    LatticePoint start;
    Lattice height = 0; ///< of one em; negative where y grows downward
    std::int64_t unitsPerEm = 1;
};

/// Draws outlines: takes a glyph's curves in font units and appends contours of lattice points to a
/// polygon.
class GlyphPen {
public:
    GlyphPen(const FontScale &scale, const Vertex &pattern, Shape &polygon)
        : m_scale(scale)
        , m_pattern(pattern)
        , m_polygon(&polygon)
    {
    }

    /// Sets the next glyph's origin, in font units from the start of the baseline.
    void setOrigin(std::int64_t x) { m_origin = x; }

    void moveTo(const FontPoint &point);
    void lineTo(const FontPoint &point);
    void quadraticTo(const FontPoint &control, const FontPoint &end);
    void cubicTo(const FontPoint &control1, const FontPoint &control2, const FontPoint &end);

    /// False once a point has left the lattice's range; it and all later ones are dropped.
    bool isWithinRange() const { return m_isWithinRange; }

private:
    /// Appends the chords of a Bézier curve of degree Count − 1 that begins at the pen.
    template <std::size_t Count>
    void curveTo(const std::array<FontPoint, Count> &points);
    /// Appends the lattice point nearest to numerator / denominator in font units; ties go to the
    /// greater.
    void append(Int128 x, Int128 y, Int128 denominator);

    FontScale m_scale;
    Vertex m_pattern;
    Shape *m_polygon;
    FontPoint m_pen;
    std::int64_t m_origin = 0;
    bool m_isWithinRange = true;
};

} // namespace pixelplumb
