// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/scenefields.h"
#include "core/scene/files/scenelimits.h"
#include "core/scene/shapenames.h"

#include <span>

/// The names of primitives' fields in files: one list for each kind, like those of scenefields.h.
/// A primitive whose list is visited has the vertices or corners that all of its kind have.
namespace pixelplumb {

template <class Values>
using ElementOf = std::remove_reference_t<decltype(std::declval<Values>()[0])>;

/// A number above 0; `what` names it in messages: "a radius".
template <class Number>
struct AboveZero {
    Number &number;
    const char *what;
};
template <class Number>
AboveZero(Number &, const char *) -> AboveZero<Number>;

/// An array of one value of each vertex; written where any is not the default, or required.
template <class Vertex, class Value>
struct OfEach {
    std::span<Vertex> vertices;
    Value std::remove_const_t<Vertex>::*value;
};
template <class Vertices, class Vertex, class Value>
OfEach(Vertices &&, Value Vertex::*) -> OfEach<ElementOf<Vertices>, Value>;

/// An array of each vertex's colour and opacity; written where they differ, or required.
template <class Vertex, class Blended>
struct BlendedColours {
    std::span<Vertex> vertices;
    std::span<Blended> opacities;
};
template <class Vertices, class Opacities>
BlendedColours(Vertices &&, Opacities &&)
    -> BlendedColours<ElementOf<Vertices>, ElementOf<Opacities>>;

/// The colour that all of them have, and their opacity where they have one.
template <class Vertex>
struct ColourOfAll {
    std::span<Vertex> vertices;
};
template <class Vertices>
ColourOfAll(Vertices &&) -> ColourOfAll<ElementOf<Vertices>>;

/// How many points an array may have.
struct PointCount {
    static constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

    std::size_t least = 1;
    std::size_t most = 1;
};

/// The points of a shape, or under a key several arrays of them; `noParts` is the error where there
/// is none.
template <class Shape>
struct PointsOf {
    Shape &shape;
    PointCount count;
    const char *partsKey = nullptr;
    const char *noParts = nullptr;
};
template <class Shape, class... Parts>
PointsOf(Shape &, PointCount, Parts...) -> PointsOf<Shape>;

/// The centre and radii of a circle or an ellipse.
template <class Shape>
struct RoundOf {
    Shape &shape;
};
template <class Shape>
RoundOf(Shape &) -> RoundOf<Shape>;

/// One of fillNamesOf() the shape's kind.
template <class Shape>
struct FillOf {
    Shape &shape;
};
template <class Shape>
FillOf(Shape &) -> FillOf<Shape>;

/// The name of one of the scene's materials.
template <class Index>
struct MaterialOf {
    Index &index;
};
template <class Index>
MaterialOf(Index &) -> MaterialOf<Index>;

/// What a triangle may carry besides positions and colours.
template <PartOf<TriangleAttributes> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("z", OfEach{self.vertices, &VertexAttributes::z});
    visit("w", OfEach{self.vertices, &VertexAttributes::w});
    visit("uv", OfEach{self.vertices, &VertexAttributes::texture});
    visit("normals", OfEach{self.vertices, &VertexAttributes::normal});
    visit("material", MaterialOf{self.material});
}

/// Of any triangle in the frame.
template <PartOf<HiddenTriangle> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("triangle", Required{OfEach{self.triangle.vertices, &Vertex::position}});
    visit("colors", Required{BlendedColours{self.triangle.vertices, self.attributes.vertices}});
    eachField(self.attributes, visit);
}

/// A circle or an ellipse as files give it.
struct RoundFields {
    PrimitiveKind kind;
    LatticePoint centre = {};
    LatticePoint radii = {};
};
template <PartOf<RoundFields> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    visit("centre", Required{self.centre});
    const AboveZero x = {self.radii.x, "a radius"};
    if (self.kind == PrimitiveKind::Circle)
        visit("radius", Required{x});
    else
        visit("radii", Required{std::array{x, AboveZero{self.radii.y, "a radius"}}});
}

template <PartOf<Shape> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    const QByteArray name = keyOf(self.kind).toLatin1();
    const char *key = name.constData();
    switch (self.kind) {
    case PrimitiveKind::Triangle: // never a shape
        break;
    case PrimitiveKind::Point:
    case PrimitiveKind::Line:
        visit(
            key,
            Required{PointsOf{self,
                              self.kind == PrimitiveKind::Line ? PointCount{2, 2}
                                                               : PointCount{1, PointCount::any}}});
        visit("colors", Required{OfEach{self.vertices, &Vertex::colour}});
        return;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        visit(key, Required{RoundOf{self}});
        break;
    case PrimitiveKind::Bezier:
        visit(key, Required{PointsOf{self, PointCount{3, 4}, "path", "no piece"}});
        break;
    case PrimitiveKind::Polygon:
        visit(key,
              Required{PointsOf{self, PointCount{3, PointCount::any}, "contours", "no contour"}});
        break;
    case PrimitiveKind::Text:
        visit(key, Required{self.text});
        visit("at", Required{self.vertices.front().position});
        visit("height", Required{AboveZero{self.textHeight, "a height"}});
        break;
    }
    visit("color", Required{ColourOfAll{self.vertices}});
    if (self.kind != PrimitiveKind::Text)
        visit("fill", FillOf{self});
}

template <PartOf<Solid> Self, class Visit>
void eachField(Self &self, const Visit &visit)
{
    const char *key = nameOf(self.kind).data();
    const auto visitSegments = [&](int around, int along) {
        visit("segments",
              std::array{NumberWithin{self.segments[0], around, mostSegments},
                         NumberWithin{self.segments[1], along, mostSegments}});
    };
    const auto row = [&](std::size_t index) {
        return OfEach{std::span(self.corners).subspan(4 * index, 4), &SolidCorner::position};
    };
    switch (self.kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
    case SolidKind::Plane:
        visit(key, Required{OfEach{self.corners, &SolidCorner::position}});
        break;
    case SolidKind::Sphere:
        visit(key, Required{self.corners.front().position});
        visit("radius", Required{AboveZero{self.radius, "a radius"}});
        visitSegments(3, 2);
        break;
    case SolidKind::Patch:
        visit(key, Required{std::array{row(0), row(1), row(2), row(3)}});
        visitSegments(1, 1);
        break;
    case SolidKind::Mesh:
        visit(key, Required{self.mesh});
        visit("at", self.at);
        visit("scale", AboveZero{self.scale, "a scale"});
        visit("rotate", self.rotate);
        break;
    }
    if (self.kind == SolidKind::Triangle3 || self.kind == SolidKind::Polygon3) {
        visit("color", ColourOfAll{self.corners});
        visit("colors", BlendedColours{self.corners, self.corners});
        visit("uv", OfEach{self.corners, &SolidCorner::texture});
        visit("normals", OfEach{self.corners, &SolidCorner::normal});
    } else {
        visit("color", ColourOfAll{std::span(&self, 1)});
    }
    visit("material", MaterialOf{self.material});
}

} // namespace pixelplumb
