// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

#include <optional>

/// The truth of points and lines, by one division for each pixel.
namespace pixelplumb::oracle {

/// The pixel nearest to a lattice point; the upper, the right one of two that are equally near.
LatticePoint nearestPixel(const LatticePoint &position);

/// A line as one equation. A line is steep where |Δy| ≥ |Δx| (Rasterization slides, "DDA
/// Line-Drawing Algorithm": iterate along x if |m| < 1, otherwise along y). It has one pixel for
/// each column, each row where it is steep, that lies between its end points, both included: the
/// pixel nearest to it there, the upper (the right) one of two that are equally near. Its colour
/// changes evenly along that axis from end to end. Nothing depends on which end is named first.
class TrueLine {
public:
    TrueLine(const Vertex &a, const Vertex &b);

    bool isSteep() const { return m_isSteep; }
    /// The first column (row where it is steep) of the line and one past the last.
    std::int64_t first() const { return ceilPixel(m_a.position.x); }
    std::int64_t end() const { return floorPixel(m_b.position.x) + 1; }
    /// The row (column where it is steep) of its pixel; `along` within [first, end).
    std::int64_t nearestAt(std::int64_t along) const;
    /// Whether the line lies midway between two pixels there, of which that is the greater.
    bool isMidwayAt(std::int64_t along) const;
    Colour colourAt(std::int64_t along, ByteRounding rounding) const;

private:
    /// 2·ΔX·S·(y + ½) there.
    Int128 scaledAt(std::int64_t along) const;

    bool m_isSteep = false;
    Vertex m_a, m_b; ///< x and y exchanged where the line is steep; m_a.position.x the smaller
};

bool lineCovers(const Shape &line, std::int64_t x, std::int64_t y);
void drawLine(const Shape &line, ByteRounding rounding, FrameView frame);

bool pointsCover(const Shape &points, std::int64_t x, std::int64_t y);
void drawPoints(const Shape &points, FrameView frame);

} // namespace pixelplumb::oracle
