// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/curvechords.h"

#include "core/polygons/glyphpen.h"

namespace pixelplumb {

std::size_t pieceCount(const Shape &path) { return path.laterContours.size() + 1; }

Shape chordsOf(const Shape &path)
{
    Shape polygon;
    polygon.kind = PrimitiveKind::Polygon;
    polygon.fill = path.fill;
    // A pen whose font units are lattice units.
    GlyphPen pen({{0, 0}, 1, 1}, {{}, path.vertices.front().colour}, polygon);
    const auto point = [&](std::size_t index) {
        const LatticePoint &position = path.vertices[index].position;
        return FontPoint{position.x, position.y};
    };
    std::size_t first = 0;
    for (std::size_t piece = 0; piece < pieceCount(path); ++piece) {
        const std::size_t end
            = piece + 1 < pieceCount(path) ? path.laterContours[piece] : path.vertices.size();
        if (first == 0)
            pen.moveTo(point(0));
        else if (path.vertices[first].position != path.vertices[first - 1].position)
            pen.lineTo(point(first));
        if (end - first == 3)
            pen.quadraticTo(point(first + 1), point(first + 2));
        else
            pen.cubicTo(point(first + 1), point(first + 2), point(first + 3));
        first = end;
    }
    return polygon;
}

} // namespace pixelplumb
