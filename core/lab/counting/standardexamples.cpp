// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/standardexamples.h"

#include "core/frame/framebuffer.h"

namespace pixelplumb {

namespace {

constexpr Colour exampleRed = {{255, 0, 0}};
constexpr Colour exampleGreen = {{0, 255, 0}};
constexpr Colour exampleBlue = {{0, 0, 255}};

Triangle exampleTriangle(const LatticePoint &a, const LatticePoint &b, const LatticePoint &c)
{
    return {{{{a, exampleRed}, {b, exampleGreen}, {c, exampleBlue}}}};
}

Shape exampleShape(const Method &method)
{
    Shape shape;
    shape.kind = method.kinds.front();
    shape.fill = method.fills.empty() ? ShapeFill::Outline : method.fills.front();
    const auto add = [&](std::int64_t x, std::int64_t y) {
        shape.vertices.push_back({latticePixel(x, y), exampleRed});
    };
    switch (shape.kind) {
    case PrimitiveKind::Triangle:
        break;
    case PrimitiveKind::Line:
        add(4, 5);
        add(58, 30);
        shape.vertices.back().colour = exampleBlue;
        break;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        add(32, 24);
        add(50, 42);
        break;
    case PrimitiveKind::Bezier:
        add(4, 5);
        add(30, 44);
        add(58, 12);
        break;
    case PrimitiveKind::Polygon:
        add(20, 4);
        add(44, 4);
        add(58, 16);
        add(58, 32);
        add(44, 44);
        add(20, 44);
        add(6, 32);
        add(6, 16);
        break;
    case PrimitiveKind::Point:
        add(32, 24);
        break;
    case PrimitiveKind::Text:
        shape.fill = ShapeFill::NonZero;
        shape.text = "Ag";
        shape.textHeight = 32 * unitsPerPixel;
        add(6, 14);
        break;
    }
    return shape;
}

QString exampleShapeName(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        break;
    case PrimitiveKind::Line:
        return u"the line from (4, 5) to (58, 30)"_s;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return u"the circle of radius 18 about (32, 24)"_s;
    case PrimitiveKind::Bezier:
        return u"the curve (4, 5) (30, 44) (58, 12)"_s;
    case PrimitiveKind::Polygon:
        return u"an octagon of 52 × 40"_s;
    case PrimitiveKind::Point:
        return u"the point (32, 24)"_s;
    case PrimitiveKind::Text:
        return u"the letters Ag, 32 high"_s;
    }
    return {};
}

} // namespace

std::vector<StandardExample> standardExamplesFor(const Method &method)
{
    const auto inFrame = [](const QString &name) { return name + u" in a frame of 64 × 48"_s; };
    if (method.kinds.front() != PrimitiveKind::Triangle)
        return {{inFrame(exampleShapeName(method.kinds.front())), {{}, {exampleShape(method)}}}};
    const LatticePoint highest = {53 * unitsPerPixel / 2, 44 * unitsPerPixel};
    return {{inFrame("the triangle (4, 5) (58, 12) (53/2, 44)"),
             {{exampleTriangle(latticePixel(4, 5), latticePixel(58, 12), highest)}, {}}},
            {inFrame("the triangle (4, 5) (8, 6) (5, 8)"),
             {{exampleTriangle(latticePixel(4, 5), latticePixel(8, 6), latticePixel(5, 8))}, {}}}};
}

std::optional<OperationCounts> countOperations(const Method &method, Arithmetic arithmetic,
                                               const StandardExample &example)
{
    FrameBuffer frame{FrameSpec{}};
    ScanSettings settings = method.adapted({});
    settings.arithmetic = arithmetic;
    return countOperations(method, settings, example.primitives, frame.view());
}

} // namespace pixelplumb
