// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/geometry/triangle.h"
#include "core/geometry/trianglesource.h"

#include <QString>

#include <string>
#include <vector>

namespace pixelplumb {

/// The kinds of primitives in a scene (Rasterization slides, "Output Primitives").
enum class PrimitiveKind : std::uint8_t {
    Triangle,
    Point,
    Line,
    Circle,
    Ellipse,
    Bezier, ///< quadratic or cubic
    Polygon,
    Text,
};

/// "triangle", "line", …: in files and in texts.
QString nameOf(PrimitiveKind kind);

/// Which part of a closed shape is painted.
enum class ShapeFill : std::uint8_t {
    Outline,
    EvenOdd, ///< inside where a ray crosses the boundary an odd number of times
    NonZero, ///< inside where the boundary winds around the sample
};

/// Any primitive but a triangle. Triangles are stored separately, without a heap block each,
/// because scenes hold millions of them.
struct Shape {
    PrimitiveKind kind = PrimitiveKind::Line;
    /// Point: one or more. Line: two. Circle, ellipse: the centre and a corner of the bounding box,
    /// so that the radii are the differences of x and of y. Bézier: three or four control points.
    /// Polygon: the contours one after another; Bézier path: the pieces. Text: the baseline's
    /// start.
    std::vector<Vertex> vertices;
    /// Indices into `vertices`: where each later contour or piece begins; the first begins at 0.
    std::vector<std::size_t> laterContours;
    ShapeFill fill = ShapeFill::Outline;
    std::string text; ///< UTF-8, of a text
    /// For a text: the font's size, lattice units; negative, for kernels, where y grows downward.
    Lattice textHeight = 0;

    friend bool operator==(const Shape &, const Shape &) = default;
};

/// What a method draws, in sample coordinates: the triangles in order, then the shapes in order.
/// Primitive indices count through both.
struct Primitives {
    std::vector<Triangle> triangles;
    std::vector<Shape> shapes;
    std::vector<TriangleAttributes> attributes = {}; ///< sparse, ascending
    Appearance appearance = {};
    /// The sources of the last triangles, those that a camera makes of solids. Their w is the view
    /// depth times 2^wExponent.
    std::vector<TriangleSource> sources = {};
    int wExponent = 0;
    /// Triangles that are pieces of a face cut by the near plane; ascending.
    std::vector<std::size_t> cutAtNear = {};
    bool isPart = false; ///< a method draws only these of the scene's primitives

    /// Where a triangle comes from; null if the scene gives it directly in the frame.
    const TriangleSource *sourceOf(std::size_t triangle) const;
    /// Null where the triangle has no attributes.
    const TriangleAttributes *attributesOf(std::size_t triangle) const;

    std::size_t size() const { return triangles.size() + shapes.size(); }
    bool isTriangle(std::size_t primitive) const { return primitive < triangles.size(); }
    const Shape &shape(std::size_t primitive) const { return shapes[primitive - triangles.size()]; }
    PrimitiveKind kindOf(std::size_t primitive) const
    {
        return isTriangle(primitive) ? PrimitiveKind::Triangle : shape(primitive).kind;
    }

    friend bool operator==(const Primitives &, const Primitives &) = default;
};

} // namespace pixelplumb
