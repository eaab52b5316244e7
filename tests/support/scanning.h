// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"
#include "tests/support/colours.h"
#include "tests/support/scanpicture.h"

#include <ostream>

/// Shared helpers of the kernel tests: triangles in short, frames as text.
namespace pixelplumb {

/// A red, green and blue triangle in whole-pixel coordinates.
inline Triangle triangleAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                           std::int64_t x2, std::int64_t y2)
{
    return {{{{latticePixel(x0, y0), red},
              {latticePixel(x1, y1), green},
              {latticePixel(x2, y2), blue}}}};
}

/// A red, green and blue triangle in units of 1/256 px.
inline Triangle triangleAtUnits(LatticePoint a, LatticePoint b, LatticePoint c)
{
    return {{{{a, red}, {b, green}, {c, blue}}}};
}

inline const Method &columnScan() { return *methodNamed(u"column-scan"); }

inline QString coverageText(const Triangle &triangle, const FrameSpec &spec,
                            const ScanSettings &settings = {})
{
    ScanPicture drawing(spec);
    drawing.draw(columnScan(), triangle, settings);
    return drawing.text();
}

/// A triangle in lattice units and colours, for RapidCheck and failure messages.
inline std::ostream &operator<<(std::ostream &stream, const Triangle &triangle)
{
    stream << "units of 1/256 px:";
    for (const Vertex &vertex : triangle.vertices)
        stream << " (" << vertex.position.x << ", " << vertex.position.y << ") #" << std::hex
               << (packed(vertex.colour) & 0xffffffU) << std::dec;
    return stream;
}

} // namespace pixelplumb
