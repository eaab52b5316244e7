// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/randomscenes.h"

#include "tests/support/scenes/shapes.h"

#include <array>
#include <random>

namespace pixelplumb {

namespace {

constexpr int frameSide = 20; // px, of the frame

/// Points in and around the frame, on ever finer lattices: whole pixels, halves, 1/256 px.
class RandomScenes {
public:
    Scene next()
    {
        m_step = std::array<Lattice, 3>{256, 128, 1}[below(3)];
        Scene scene;
        scene.frame = frameOf(frameSide, frameSide);
        scene.frame.origin = m_count % 2 == 0 ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
        scene.frame.pixelCentre = m_count / 2 % 2 == 0 ? PixelCentre::Integer : PixelCentre::Half;
        scene.triangles = {{{vertex(), vertex(), vertex()}}};
        scene.shapes = {shape(PrimitiveKind::Point, 6),
                        shape(PrimitiveKind::Line, 2),
                        shape(PrimitiveKind::Bezier, 3 + below(2)),
                        filledCurve(),
                        filledPolygon(),
                        shape(PrimitiveKind::Polygon, 3 + below(4)),
                        text()};
        for (const ShapeFill fill : {ShapeFill::Outline, ShapeFill::NonZero}) {
            scene.shapes.push_back(circleAt(std::int64_t(below(frameSide)),
                                            std::int64_t(below(frameSide)),
                                            std::int64_t(1 + below(12)), fill));
            scene.shapes.push_back(
                ellipseAtUnits(point(), 1 + Lattice(below(3000)), 1 + Lattice(below(3000)), fill));
        }
        ++m_count;
        return scene;
    }

private:
    std::size_t below(std::size_t end) { return m_random() % end; }
    LatticePoint point()
    {
        const auto coordinate = [this] {
            return (Lattice(below((frameSide + 16) * unitsPerPixel)) / m_step
                    - 8 * unitsPerPixel / m_step)
                * m_step;
        };
        const Lattice x = coordinate();
        return {x, coordinate()};
    }
    Vertex vertex()
    {
        const auto byte = [this] { return std::uint8_t(below(256)); };
        const LatticePoint position = point();
        const std::uint8_t red = byte();
        const std::uint8_t green = byte();
        return {position, {{red, green, byte()}}};
    }
    ShapeFill fill() { return below(2) == 0 ? ShapeFill::EvenOdd : ShapeFill::NonZero; }
    Shape shape(PrimitiveKind kind, std::size_t vertices)
    {
        Shape shape;
        shape.kind = kind;
        for (std::size_t i = 0; i < vertices; ++i)
            shape.vertices.push_back(vertex());
        return shape;
    }
    Shape filledCurve()
    {
        Shape curve = shape(PrimitiveKind::Bezier, 3);
        curve.fill = fill();
        return curve;
    }
    /// A filled polygon; in the first four scenes it has three vertices, so that every polygon
    /// method draws it.
    Shape filledPolygon()
    {
        Shape polygon = shape(PrimitiveKind::Polygon, m_count < 4 ? 3 : 3 + below(4));
        polygon.fill = fill();
        return polygon;
    }
    Shape text()
    {
        Shape text = shape(PrimitiveKind::Text, 1);
        text.vertices.front().position = {Lattice(below(2000)), Lattice(1000 + below(2000))};
        text.text = "g8";
        text.textHeight = Lattice(1000 + below(4000));
        return text;
    }

    std::mt19937 m_random{8};
    Lattice m_step = unitsPerPixel;
    int m_count = 0;
};

} // namespace

std::vector<NamedScene> randomScenes(int count)
{
    std::vector<NamedScene> scenes;
    RandomScenes random;
    for (int i = 0; i < count; ++i)
        scenes.push_back({u"random %1"_s.arg(i), random.next()});
    return scenes;
}

} // namespace pixelplumb
