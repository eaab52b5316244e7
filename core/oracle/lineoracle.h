// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

#include <optional>

/// The truth of points and lines, by one division per pixel.
namespace pixelplumb::oracle {

/// The pixel nearest to a lattice point; in a tie the upper or right one.
LatticePoint nearestPixel(const LatticePoint &position);

/// A line as one equation. It is steep where |Δy| ≥ |Δx| (Rasterization slides, "DDA Line-Drawing
/// Algorithm": iterate along x if |m| < 1, otherwise along y). It has one pixel for each column
/// (row where it is steep) between its end points, both included: the nearest one there, and in a
/// tie the upper (right) one. Its colour changes evenly along that axis from end to end. The order
/// of the ends makes no difference.
class TrueLine {
public:
    TrueLine(const Vertex &a, const Vertex &b);

    bool isSteep() const { return m_isSteep; }
    /// The first column (row where it is steep) of the line and one past the last.
    std::int64_t first() const { return ceilPixel(m_a.position.x); }
    std::int64_t end() const { return floorPixel(m_b.position.x) + 1; }
    /// The row (column where it is steep) of the line's pixel; `along` within [first, end).
    std::int64_t nearestAt(std::int64_t along) const;
    /// Whether the line lies midway between two pixels at `along`; nearestAt() is the greater.
    bool isMidwayAt(std::int64_t along) const;
    Colour colourAt(std::int64_t along, ByteRounding rounding) const;

private:
    /// 2·ΔX·S·(y + ½) at `along`.
    Int128 scaledAt(std::int64_t along) const;

    bool m_isSteep = false;
    Vertex m_a, m_b; ///< x and y exchanged where the line is steep; m_a.position.x the smaller
};

bool lineCovers(const Shape &line, std::int64_t x, std::int64_t y);
void drawLine(const Shape &line, ByteRounding rounding, FrameView frame);

bool pointsCover(const Shape &points, std::int64_t x, std::int64_t y);
void drawPoints(const Shape &points, FrameView frame);

} // namespace pixelplumb::oracle
