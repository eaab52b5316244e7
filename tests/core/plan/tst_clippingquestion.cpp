// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/shade/edgepixels.h"
#include "tests/support/scenes/effectchanges.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_clippingquestion {

using namespace pixelplumb;

/// What lies inside the frame, and what beyond it.
class TestClippingQuestion : public QObject {
    Q_OBJECT

private slots:
    /// Checked against every sample in and around the frame, by products of whole numbers.
    void clippingIsDecidedBySamples_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::newRow("1") << Antialiasing::None;
        QTest::newRow("4") << Antialiasing::Samples4;
        QTest::newRow("16") << Antialiasing::Samples16;
    }
    void clippingIsDecidedBySamples()
    {
        QFETCH(Antialiasing, antialiasing);
        constexpr std::array<LatticePoint, 1> own = {};
        const std::span<const LatticePoint> pattern = samplePattern(antialiasing);
        const std::span<const LatticePoint> samples
            = pattern.empty() ? std::span<const LatticePoint>(own) : pattern;
        SeededRandom random(27);
        int crossing = 0;
        for (int i = 0; i < 400; ++i) {
            // Around the frame's upper right corner, in quarters of a pixel.
            Triangle triangle = plain().triangles[0];
            for (Vertex &vertex : triangle.vertices)
                vertex.position = {random.between(29 * 4, 34 * 4) * unitsPerPixel / 4,
                                   random.between(21 * 4, 26 * 4) * unitsPerPixel / 4};
            if (doubledArea(triangle) == 0)
                continue;
            bool isIn = false, isBeyond = false;
            for (std::int64_t x = 28; x < 36; ++x) {
                for (std::int64_t y = 20; y < 28; ++y) {
                    for (const LatticePoint &sample : samples) {
                        const LatticePoint at
                            = {x * unitsPerPixel + sample.x, y * unitsPerPixel + sample.y};
                        int left = 0, right = 0;
                        for (std::size_t edge = 0; edge < 3; ++edge) {
                            const LatticePoint &a = triangle.vertices[edge].position;
                            const LatticePoint &b = triangle.vertices[(edge + 1) % 3].position;
                            const Lattice side
                                = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
                            left += side >= 0 ? 1 : 0;
                            right += side <= 0 ? 1 : 0;
                        }
                        if (left == 3 || right == 3)
                            (x < 32 && y < 24 ? isIn : isBeyond) = true;
                    }
                }
            }
            Primitives primitives;
            primitives.triangles = {triangle};
            primitives.appearance.antialiasing = antialiasing;
            const Verdict verdict = verdictsOf(primitives)[Effect::Clipping].verdict;
            QVERIFY2((verdict == Verdict::CalledFor) == (isIn && isBeyond),
                     qPrintable(QString::number(i)));
            crossing += isIn && isBeyond ? 1 : 0;
        }
        QVERIFY(crossing > 50 && crossing < 350);
    }

    /// A stroke is ½ px wide to each side, and the frame ends ½ px beyond its samples.
    void aStrokeOutsideTheFrameNeedsNothing()
    {
        for (const Antialiasing antialiasing :
             {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area}) {
            Primitives primitives;
            primitives.shapes = {smoothLine()};
            primitives.appearance.antialiasing = antialiasing;
            for (const int y : {-1, -2, 24, 26}) {
                for (Vertex &vertex : primitives.shapes[0].vertices)
                    vertex.position.y = y * unitsPerPixel;
                QCOMPARE(verdictsOf(primitives)[Effect::SmoothColour].reason,
                         QStringLiteral("nothing is drawn in the frame"));
            }
            for (Vertex &vertex : primitives.shapes[0].vertices)
                vertex.position.y = -unitsPerPixel * 3 / 4;
            QCOMPARE(verdictsOf(primitives)[Effect::SmoothColour].verdict, Verdict::CalledFor);
        }
    }

    /// The midpoint circle rounds its centre and its radius: centre (−2.5, 2), radius 1.5 reaches
    /// column 0.
    void aCircleIsInTheFrameWhereItsRoundedOneIs()
    {
        Primitives primitives;
        Shape circle = smoothLine();
        circle.kind = PrimitiveKind::Circle;
        for (Vertex &vertex : circle.vertices)
            vertex.colour = {};
        circle.vertices[0].position = {-5 * halfPixel, latticePixel(0, 2).y};
        circle.vertices[1].position = {-2 * halfPixel, latticePixel(0, 2).y + 3 * halfPixel};
        primitives.shapes = {circle};
        QVERIFY(verdictsOf(primitives)[Effect::Clipping].verdict != Verdict::NotCalledFor);
        primitives.shapes[0].vertices[0].position.x -= 8 * unitsPerPixel;
        primitives.shapes[0].vertices[1].position.x -= 8 * unitsPerPixel;
        QCOMPARE(verdictsOf(primitives)[Effect::Clipping].reason,
                 QStringLiteral("nothing is drawn in the frame"));
    }

    /// The frame begins half a pixel before its first sample.
    void whatStaysInTheFramesPixelsIsNotClipped_data()
    {
        QTest::addColumn<PrimitiveKind>("kind");
        QTest::addColumn<ShapeFill>("fill");
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::newRow("line") << PrimitiveKind::Line << ShapeFill::Outline << Antialiasing::None;
        QTest::newRow("line, 4") << PrimitiveKind::Line << ShapeFill::Outline
                                 << Antialiasing::Samples4;
        QTest::newRow("line, area")
            << PrimitiveKind::Line << ShapeFill::Outline << Antialiasing::Area;
        QTest::newRow("points") << PrimitiveKind::Point << ShapeFill::Outline << Antialiasing::None;
        QTest::newRow("outline") << PrimitiveKind::Polygon << ShapeFill::Outline
                                 << Antialiasing::None;
        QTest::newRow("polygon") << PrimitiveKind::Polygon << ShapeFill::EvenOdd
                                 << Antialiasing::None;
    }
    void whatStaysInTheFramesPixelsIsNotClipped()
    {
        QFETCH(PrimitiveKind, kind);
        QFETCH(ShapeFill, fill);
        QFETCH(Antialiasing, antialiasing);
        Primitives primitives;
        Shape shape;
        shape.kind = kind;
        shape.fill = fill;
        shape.vertices = {{{unitsPerPixel, -unitsPerPixel / 4}, {}}, {latticePixel(1, 2), {}}};
        if (kind == PrimitiveKind::Polygon)
            shape.vertices.push_back({latticePixel(3, 3), {}});
        primitives.shapes = {shape};
        primitives.appearance.antialiasing = antialiasing;
        QCOMPARE(verdictsOf(primitives)[Effect::Clipping].reason,
                 QStringLiteral("what is drawn lies within the frame"));
        primitives.shapes[0].vertices[0].position.y = -3 * unitsPerPixel;
        QCOMPARE(verdictsOf(primitives)[Effect::Clipping].verdict,
                 fill == ShapeFill::EvenOdd ? Verdict::NotRuledOut : Verdict::CalledFor);
    }
};

PIXELPLUMB_TEST(TestClippingQuestion)

} // namespace tst_clippingquestion

#include "tst_clippingquestion.moc"
