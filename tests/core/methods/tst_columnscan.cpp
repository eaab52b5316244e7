// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "tests/support/numbernamed.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/plaincolumnscan.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QTest>

#include <random>

namespace tst_columnscan {

using namespace pixelplumb;

namespace {

Triangle randomTriangleIn(std::int64_t side, QRandomGenerator &random)
{
    Triangle triangle;
    for (Vertex &vertex : triangle.vertices) {
        vertex.position = latticePixel(random.bounded(int(side)), random.bounded(int(side)));
        for (auto &channel : vertex.colour.channels)
            channel = std::remove_reference_t<decltype(channel)>(random.bounded(256));
    }
    return triangle;
}

plain::Vertex plainVertex(const Vertex &vertex)
{
    const auto &[red, green, blue] = vertex.colour.channels;
    return {float(vertex.position.x / unitsPerPixel),
            {float(vertex.position.y / unitsPerPixel), float(red), float(green), float(blue)}};
}

} // namespace

/// Each rule of the assignment, and what the assignment leaves open.
class TestColumnScan : public QObject {
    Q_OBJECT

private slots:
    void coversExactlyTheExpectedPixels_data()
    {
        QTest::addColumn<Triangle>("triangle");
        QTest::addColumn<QString>("closed");
        QTest::addColumn<QString>("halfOpen");

        QTest::newRow("long edge above, x0 < x1 < x2")
            << triangleAt(0, 3, 2, 0, 4, 4) << "....#\n####.\n.###.\n..#..\n..#..\n"
            << ".....\n.###.\n.###.\n..#..\n..#..\n";
        QTest::newRow("long edge below")
            << triangleAt(0, 1, 2, 4, 4, 0) << "..#..\n..#..\n.###.\n####.\n....#\n"
            << ".....\n..#..\n.##..\n.###.\n.....\n";
        QTest::newRow("x0 = x1: the first half is skipped")
            << triangleAt(0, 0, 0, 4, 4, 0) << "#....\n##...\n###..\n####.\n#####\n"
            << ".....\n#....\n##...\n###..\n####.\n";
        QTest::newRow("x1 = x2: the second half is one column")
            << triangleAt(0, 0, 4, 0, 4, 4) << "....#\n...##\n..###\n.####\n#####\n"
            << ".....\n.....\n...#.\n..##.\n.###.\n";
        QTest::newRow("all columns equal: a vertical segment")
            << triangleAt(2, 1, 2, 3, 2, 2) << ".....\n..#..\n..#..\n..#..\n.....\n"
            << ".....\n.....\n.....\n.....\n.....\n";
        QTest::newRow("collinear vertices: the samples on the segment")
            << triangleAt(0, 0, 4, 2, 2, 1) << ".....\n.....\n....#\n..#..\n#....\n"
            << ".....\n.....\n.....\n.....\n.....\n";
        QTest::newRow("coincident vertices: one sample")
            << triangleAt(3, 1, 3, 1, 3, 1) << ".....\n.....\n.....\n...#.\n.....\n"
            << ".....\n.....\n.....\n.....\n.....\n";
        QTest::newRow("between the samples: nothing")
            << triangleAtUnits({300, 300}, {400, 310}, {350, 400})
            << ".....\n.....\n.....\n.....\n.....\n"
            << ".....\n.....\n.....\n.....\n.....\n";
        QTest::newRow("fractional vertices: columns from the next sample on")
            << triangleAtUnits({128, 128}, {896, 128}, {128, 896})
            << ".....\n.#...\n.##..\n.###.\n.....\n"
            << ".....\n.....\n.#...\n.##..\n.....\n";
    }
    void coversExactlyTheExpectedPixels()
    {
        QFETCH(Triangle, triangle);
        QFETCH(QString, closed);
        QFETCH(QString, halfOpen);
        for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Float64}) {
            ScanSettings settings{arithmetic, FillRule::Closed, ByteRounding::Nearest};
            QCOMPARE(coverageText(triangle, frameOf(5, 5), settings), closed);
            settings.fillRule = FillRule::HalfOpenColumn;
            QCOMPARE(coverageText(triangle, frameOf(5, 5), settings), halfOpen);
        }
    }

    void paintsTheTipWhereRoundedEdgesPassEachOther()
    {
        // In float64 L₁₂ falls to a little below y₂ = 4, and L₀₂ rises to a little above.
        ScanPicture drawing(frameOf(48, 40));
        drawing.draw(columnScan(), triangleAt(24, 0, 42, 4, 10, 37),
                     {Arithmetic::Float64, FillRule::Closed, ByteRounding::Nearest});
        QVERIFY(drawing.at(42, 4) != 0);
    }

    void takesTheSmallerBoundOfEachColumnAsYBottom_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *method : {"column-scan", "row-walk", "column-scan-constant-rate"}) {
            for (const Arithmetic arithmetic : {Arithmetic::Float32, Arithmetic::Float64})
                QTest::addRow("%s, %s", method, nameOf(arithmetic).data()) << method << arithmetic;
        }
    }
    void takesTheSmallerBoundOfEachColumnAsYBottom()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        std::mt19937 random(5);
        const auto coordinate
            = [&] { return std::uniform_int_distribution<std::int64_t>(0, 46)(random); };
        int crossed = 0;
        for (int i = 0; i < 200; ++i) {
            Scene scene;
            scene.frame = frameOf(47, 47);
            scene.method = method.toStdString();
            scene.settings.arithmetic = arithmetic;
            scene.triangles = {triangleAt(coordinate(), coordinate(), coordinate(), coordinate(),
                                          coordinate(), coordinate())};
            const auto traced = traceScene(scene);
            const ScanTrace &trace = *traced->trace;
            for (std::size_t index = 0; index < trace.spanCount(); ++index) {
                const SpanRecord span = trace.span(index);
                QVERIFY(span.lower.toDouble() <= span.upper.toDouble());
                crossed += int(span.longEdge != trace.setUp(0).longEdge);
            }
        }
        QVERIFY(crossed > 0);
    }

    void drawsTheSamePictureForEveryOrderOfTheVertices()
    {
        const Triangle triangle = triangleAt(2, 1, 29, 11, 13, 27);
        ScanPicture expected(frameOf(32, 32));
        expected.draw(columnScan(), triangle, {});
        std::array<std::size_t, 3> order = {0, 1, 2};
        do {
            const Triangle permuted = {{triangle.vertices[order[0]], triangle.vertices[order[1]],
                                        triangle.vertices[order[2]]}};
            ScanPicture drawing(frameOf(32, 32));
            drawing.draw(columnScan(), permuted, {});
            QVERIFY(drawing == expected);
        } while (std::ranges::next_permutation(order).found);
    }

    void drawsInFloat32WhatTheAssignmentsPlainLoopDraws()
    {
        QRandomGenerator random(20261122);
        const FrameSpec spec = frameOf(64, 64);
        std::int64_t pixels = 0;
        for (int repeat = 0; repeat < 2000; ++repeat) {
            const Triangle triangle = randomTriangleIn(64, random);
            const auto &v = triangle.vertices;
            if (doubledArea(v[0].position, v[1].position, v[2].position) == 0)
                continue; // the plain loop does not know which of three collinear points is last
            ScanPicture drawing(spec);
            drawing.draw(columnScan(), triangle,
                         {Arithmetic::Float32, FillRule::Closed, ByteRounding::Nearest});
            ScanPicture expected(spec);
            expected.draw([&](FrameView frame) {
                plain::drawTriangle({plainVertex(v[0]), plainVertex(v[1]), plainVertex(v[2])},
                                    frame);
            });
            pixels += expected.count();
            QVERIFY2(drawing == expected, qPrintable(QString::number(repeat)));
        }
        QVERIFY(pixels > 500000);
    }

    void leavesTheCallersTriangleAsItIs()
    {
        const Triangle before = triangleAt(9, 1, 2, 3, 5, 8);
        const Triangle triangle = before;
        coverageText(triangle, frameOf(16, 16));
        QCOMPARE(triangle, before);
    }

    void takesTheVertexColoursAtTheVertices()
    {
        for (const Arithmetic arithmetic : allArithmetics) {
            ScanPicture drawing(frameOf(32, 32));
            drawing.draw(columnScan(), triangleAt(2, 1, 29, 11, 13, 27),
                         {arithmetic, FillRule::Closed, ByteRounding::Nearest});
            QCOMPARE(drawing.at(2, 1), packed(red));
            if (arithmetic == Arithmetic::Exact) {
                QCOMPARE(drawing.at(29, 11), packed(green));
                QCOMPARE(drawing.at(13, 27), packed(blue));
            }
        }
    }

    void startsOutsideTheFrameByAJumpWithTheSameNumbers()
    {
        // The same triangle in a frame that shows all of it and in a window far inside.
        const Triangle triangle = triangleAtUnits({-5000, 311}, {39000, 7001}, {9111, 27777});
        ScanPicture whole(frameOf(200, 128, -32, -8));
        whole.draw(columnScan(), triangle, {});
        ScanPicture window(frameOf(17, 13, 40, 30));
        window.draw(columnScan(), triangle, {});
        for (std::int64_t y = 30; y < 43; ++y) {
            for (std::int64_t x = 40; x < 57; ++x)
                QCOMPARE(window.at(x, y), whole.at(x, y));
        }
    }

    void entersOnlyTheFramesColumnsHoweverFarTheTriangleReaches()
    {
        Scene scene;
        scene.frame = frameOf(16, 16);
        for (const Arithmetic arithmetic : allArithmetics) {
            if (arithmetic == Arithmetic::Fixed16)
                continue; // it cannot hold the vertices
            scene.settings.arithmetic = arithmetic;
            scene.triangles
                = {triangleAt(-largestPixel, -largestPixel, largestPixel, -7, 0, largestPixel)};
            const auto traced = traceScene(scene);
            QCOMPARE(traced->trace->spanCount(), std::size_t(16));
        }
    }

    void refusesInFixed16WhatDoesNotFitAndSaysSo()
    {
        Scene scene;
        scene.settings.arithmetic = Arithmetic::Fixed16;
        scene.triangles = {triangleAt(-40000, 0, 40, 3, 3, 40)};
        const auto traced = traceScene(scene);
        QCOMPARE(traced->trace->setUp(0).rejection, PrimitiveRejection::NotRepresentable);
        QVERIFY(explainStep(*traced, 0).sentence.contains(u"more than these settings hold"));
    }

    void chooses128BitsOnlyBeyondTheProvedDomain()
    {
        QCOMPARE(integerWidthFor(triangleAt(-32768, 32768, 0, 0, 5, 5)), IntegerWidth::Bits64);
        QCOMPARE(integerWidthFor(triangleAt(-32769, 0, 0, 0, 5, 5)), IntegerWidth::Bits128);
    }

    void truncationLosesALevelWhereRoundingDoesNot()
    {
        Triangle triangle = triangleAt(0, 0, 3, 0, 0, 3);
        for (Vertex &vertex : triangle.vertices)
            vertex.colour = {{0, 0, 0}};
        triangle.vertices[1].colour = {{2, 0, 0}}; // 2/3 level per column
        ScanPicture nearest(frameOf(4, 4));
        nearest.draw(columnScan(), triangle, {});
        ScanPicture truncated(frameOf(4, 4));
        truncated.draw(columnScan(), triangle,
                       {Arithmetic::Exact, FillRule::Closed, ByteRounding::Truncate});
        QCOMPARE(qRed(nearest.at(1, 0)), 1);
        QCOMPARE(qRed(truncated.at(1, 0)), 0);
    }

    void exactStartOfRedIsTheAssignmentsFormula()
    {
        // R_B + (⌈y_B⌉ − y_B)·Δ_R, computed here in doubles from the exact values, is what the scan
        // used.
        Scene scene;
        scene.triangles = {triangleAtUnits({1024, 1280}, {14848, 3072}, {6784, 11264})};
        const auto traced = traceScene(scene);
        for (std::size_t i = 0; i < traced->trace->spanCount(); ++i) {
            const SpanRecord column = traced->trace->span(i);
            if (column.drawnSamples() == 0)
                continue;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const QString letter = channelLetters[channel];
                const double expected = spanNumber(*traced, i, letter + u"_B"_s).toDouble()
                    + (double(column.firstSample) - column.lower.toDouble())
                        * spanNumber(*traced, i, u"delta_"_s + letter).toDouble();
                QVERIFY(qAbs(spanNumber(*traced, i, u"first_"_s + letter).toDouble() - expected)
                        < 1e-9);
            }
        }
    }

    void writesTheSameBytesThroughANegativeAndAPositiveStride()
    {
        const Triangle triangle = triangleAt(2, 1, 29, 11, 13, 27);
        FrameSpec upward = frameOf(31, 29);
        FrameSpec downward = upward;
        downward.origin = FrameOrigin::TopLeft;
        FrameBuffer a(upward);
        FrameBuffer b(downward);
        QVERIFY(a.view().stride < 0);
        QVERIFY(b.view().stride > 0);
        Run(&columnScan(), {{triangle}, {}}, {}, a.view(), Kernels::Plain).draw(a.view());
        Run(&columnScan(), {{triangle}, {}}, {}, b.view(), Kernels::Plain).draw(b.view());
        QCOMPARE(a.copy().mirrored(), b.copy());
    }
};

PIXELPLUMB_TEST(TestColumnScan)

} // namespace tst_columnscan

#include "tst_columnscan.moc"
