// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/rejectiontext.h"
#include "core/polygons/contours.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>

namespace tst_polygons {

using namespace pixelplumb;

namespace {

Shape anyPolygon(SeededRandom &dice, std::int64_t side, Lattice grid)
{
    std::vector<Contour> contours;
    const std::int64_t count = dice.between(1, 3);
    for (std::int64_t i = 0; i < count; ++i)
        contours.push_back(anyContour(dice, side, grid));
    return polygonOf(contours, fills[std::size_t(dice.between(0, 1))]);
}

/// Whether the line between two points has a pixel, tested by inequalities alone: it is the one
/// pixel of its column (its row if the line is steep) that is at most ½ px above the line and less
/// than ½ px below it.
bool lineHas(LatticePoint a, LatticePoint b, std::int64_t column, std::int64_t row)
{
    LatticePoint pixel = latticePixel(column, row);
    if (std::abs(b.y - a.y) >= std::abs(b.x - a.x)) {
        std::swap(a.x, a.y);
        std::swap(b.x, b.y);
        std::swap(pixel.x, pixel.y);
    }
    if (b.x < a.x)
        std::swap(a, b);
    const Lattice width = b.x - a.x;
    const Lattice above = 2 * ((pixel.y - a.y) * width - (pixel.x - a.x) * (b.y - a.y));
    return width > 0 && pixel.x >= a.x && pixel.x <= b.x && above <= 256 * width
        && above > -256 * width;
}

} // namespace

/// Filled polygons (Scan Conversion slides, "Scan Conversion: A General Algorithm"): parity and
/// winding against the truth.
class TestPolygons : public QObject {
    Q_OBJECT

private slots:
    void fillsByParityOrByWinding_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<QString>("expected");
        const auto outer = pixels({{0, 0}, {6, 0}, {6, 5}, {0, 5}});
        const auto hole = pixels({{2, 2}, {4, 2}, {4, 4}, {2, 4}});
        QTest::newRow("a rectangle owns its left and top edges")
            << polygonOf({pixels({{1, 1}, {4, 1}, {4, 3}, {1, 3}})})
            << ".......\n.......\n.......\n.###...\n.###...\n.......\n.......\n";
        QTest::newRow("a hole by parity")
            << polygonOf({outer, hole})
            << ".......\n######.\n##..##.\n##..##.\n######.\n######.\n.......\n";
        QTest::newRow("the same way round twice: no hole by winding")
            << polygonOf({outer, hole}, ShapeFill::NonZero)
            << ".......\n######.\n######.\n######.\n######.\n######.\n.......\n";
        QTest::newRow("a bow tie: both wings, the sample where they meet too")
            << polygonOf({pixels({{0, 0}, {6, 6}, {6, 0}, {0, 6}})})
            << ".......\n#....#.\n##..##.\n######.\n##..##.\n#....#.\n.......\n";
    }
    void fillsByParityOrByWinding()
    {
        QFETCH(Shape, shape);
        QFETCH(QString, expected);
        const Scene scene = sceneOf({shape}, frameOf(7, 7), "polygon-parity");
        QCOMPARE(truthOf(scene), drawn(scene));
        QCOMPARE(drawn(scene), expected);
    }

    void aPentagramHasAHoleByParityAndNoneByWinding()
    {
        const auto middleOf = [](ShapeFill fill) {
            return oracle::polygonCovers(pentagram(fill), FrameOrigin::BottomLeft, 8, 6);
        };
        QVERIFY(!middleOf(ShapeFill::EvenOdd));
        QVERIFY(middleOf(ShapeFill::NonZero));
        for (const ShapeFill fill : fills) {
            const Scene scene = sceneOf({pentagram(fill)}, frameOf(17, 16), "polygon-parity");
            QCOMPARE(drawn(scene), truthOf(scene));
        }
    }

    void exactRowsAreTheTruthForAnyContours()
    {
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(3000)); ++seed) {
            SeededRandom dice(seed);
            constexpr std::array<Lattice, 4> grids = {256, 128, 16, 1};
            const Lattice grid = grids[std::size_t(dice.between(0, 3))];
            const Shape shape = anyPolygon(dice, 24 * 256 / grid, grid);
            const Scene scene = sceneOf({shape}, frameOf(24, 24), "polygon-parity");
            if (drawn(scene) != truthOf(scene))
                QFAIL(qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
        }
    }

    void farAwayTheRowsAreStillTheTruth()
    {
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(300)); ++seed) {
            SeededRandom dice(seed);
            const std::int32_t far = std::int32_t(dice.between(-1, 1) * (largestPixel - 40));
            const Shape shape
                = moved(anyPolygon(dice, 24 * 256, 1), latticePixel(far, -std::int64_t(far)));
            const Scene scene = sceneOf({shape}, frameOf(24, 24, far, -far), "polygon-parity");
            if (drawn(scene) != truthOf(scene))
                QFAIL(qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
        }
    }

    void edgesAcrossTheWholeRangeAreExact()
    {
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(300)); ++seed) {
            SeededRandom dice(seed);
            Contour contour;
            for (int i = 0; i < 7; ++i)
                contour.push_back({dice.between(-largestCoordinate, largestCoordinate),
                                   dice.between(-largestCoordinate, largestCoordinate)});
            const Shape shape = polygonOf({contour}, fills[seed % 2]);
            const Scene scene = sceneOf({shape}, frameOf(20, 20, -10, -10), "polygon-parity");
            if (drawn(scene) != truthOf(scene))
                QFAIL(qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
        }
    }

    void roundingFormsMissATieThatExactRowsKeep()
    {
        // The left edge gains 1/10 px per row. On every tenth row it meets a sample, which the sum
        // of rounded tenths misses.
        const Shape shape = polygonOf({pixels({{0, 0}, {20, 0}, {23, 30}, {3, 30}})});
        const FrameSpec frame = frameOf(32, 32);
        const Scene exact = sceneOf({shape}, frame, "polygon-parity");
        QCOMPARE(drawn(exact), truthOf(exact));
        for (const Arithmetic rounding : {Arithmetic::Float32, Arithmetic::Float64}) {
            const auto traced = traceScene(sceneOf({shape}, frame, "polygon-parity", rounding));
            QVERIFY(traced->differences.total() > 0);
            QVERIFY(traced->exactTrace);
        }
    }

    void polygonsThatShareEdgesCoverEachSampleOnce()
    {
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(400)); ++seed) {
            SeededRandom dice(seed);
            // A square cut in two by a random chain from its left to its right side.
            const Lattice side = 20 * 256;
            const Lattice grid = seed % 2 == 0 ? 256 : 1;
            Contour cut = {{0, dice.between(0, side / grid) * grid}};
            for (int i = 0; i < 6; ++i)
                cut.push_back(
                    {dice.between(0, side / grid) * grid, dice.between(0, side / grid) * grid});
            cut.push_back({side, dice.between(0, side / grid) * grid});
            Contour below = {{side, 0}, {0, 0}};
            below.insert(below.end(), cut.begin(), cut.end());
            Contour above = {{0, side}, {side, side}};
            above.insert(above.end(), cut.rbegin(), cut.rend());
            const FrameOrigin origin
                = seed % 4 < 2 ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
            const std::int64_t firstRow = origin == FrameOrigin::BottomLeft ? 1 : 0;
            // The chain may intersect itself: then only the parities of the two parts add up to
            // one.
            for (std::int64_t y = -1; y <= 21; ++y) {
                for (std::int64_t x = -1; x <= 21; ++x) {
                    const bool inSquare = x >= 0 && x < 20 && y >= firstRow && y < firstRow + 20;
                    const int owners = int(oracle::polygonCovers(polygonOf({below}), origin, x, y))
                        + int(oracle::polygonCovers(polygonOf({above}), origin, x, y));
                    if (owners % 2 != int(inSquare))
                        QFAIL(qPrintable(u"seed %1 at (%2, %3)"_s.arg(seed).arg(x).arg(y)));
                }
            }
        }
    }

    void eachCrossingIsItsBasePlusItsRiseTimesItsSlope()
    {
        const auto traced = traceScene(
            sceneOf({pentagram(ShapeFill::EvenOdd)}, frameOf(17, 16), "polygon-parity"));
        const ScanTrace &trace = *traced->trace;
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            const SpanRecord row = trace.span(span);
            const double x = row.cells[3].toDouble();
            const double base = row.cells[5].toDouble();
            const double rise = row.cells[6].toDouble();
            const double slope = row.cells[7].toDouble();
            QVERIFY(std::abs(x - (base + rise * slope)) < 1e-9);
        }
        QVERIFY(trace.spanCount() == 15);
    }

    void anOutlineIsTheLinesOfItsEdges()
    {
        for (std::uint32_t seed = 0; seed < std::uint32_t(fewerIfSanitized(400)); ++seed) {
            SeededRandom dice(seed);
            const Lattice grid = seed % 2 == 0 ? 256 : 1;
            Shape shape = anyPolygon(dice, 24 * 256 / grid, grid);
            shape.fill = ShapeFill::Outline;
            const std::vector<ContourEdge> edges = contoursOf(shape).edges;
            QString expected;
            for (std::int64_t y = 23; y >= 0; --y, expected += u'\n') {
                for (std::int64_t x = 0; x < 24; ++x) {
                    const bool isOutline = std::ranges::any_of(edges, [&](const ContourEdge &edge) {
                        return lineHas(edge.from, edge.to, x, y);
                    });
                    // An edge of length 0 on a pixel has that pixel.
                    const bool isPoint = std::ranges::any_of(edges, [&](const ContourEdge &edge) {
                        return edge.from == edge.to && edge.from == latticePixel(x, y);
                    });
                    expected += isOutline || isPoint ? u'#' : u'.';
                }
            }
            const Scene scene = sceneOf({shape}, frameOf(24, 24), "polygon-outline");
            QVERIFY2(drawn(scene) == expected, qPrintable(contoursText(shape)));
            QVERIFY2(truthOf(scene) == expected, qPrintable(contoursText(shape)));
        }
    }

    void eachStepOfAnOutlineHasTheNumbersOfItsEdge()
    {
        const Shape shape = pentagram(ShapeFill::Outline);
        const auto traced = traceScene(sceneOf({shape}, frameOf(17, 16), "polygon-outline"));
        const ScanTrace &trace = *traced->trace;
        const std::vector<ContourEdge> edges = contoursOf(shape).edges;
        const auto column = [&](const char *id) {
            return std::ranges::find(trace.numbers().span, QString::fromLatin1(id),
                                     &NumberDescription::id)
                - trace.numbers().span.begin();
        };
        std::size_t parts = 0;
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            const SpanRecord step = trace.span(span);
            const ContourEdge &edge = edges[std::size_t(step.place.part)];
            const Lattice across
                = std::min(std::abs(edge.to.x - edge.from.x), std::abs(edge.to.y - edge.from.y));
            QCOMPARE(step.cells[std::size_t(column("edge"))].toDouble(), step.place.part);
            QCOMPARE(step.cells[std::size_t(column("delta_y"))].toDouble(), double(across) / 256);
            parts += trace.beginsPart(span) ? 1 : 0;
        }
        QCOMPARE(parts, edges.size());
    }

    void anOutlineIsNoFilledPolygonAndNoneIsAnOutline()
    {
        for (const char *method : {"polygon-parity", "polygon-fan", "polygon-delaunay"})
            QCOMPARE(rejectionOf(pentagram(ShapeFill::Outline), method),
                     PrimitiveRejection::NotOfThisMethod);
        QCOMPARE(rejectionOf(pentagram(ShapeFill::NonZero), "polygon-outline"),
                 PrimitiveRejection::NotOfThisMethod);
        QCOMPARE(rejectionOf(moved(pentagram(ShapeFill::Outline), latticePixel(40, 40)),
                             "polygon-outline"),
                 PrimitiveRejection::OutsideFrame);
    }

    void shapesWithoutAreaOrOutsideTheFrameDrawNothing()
    {
        QCOMPARE(rejectionOf(polygonOf({pixels({{1, 4}, {7, 4}, {3, 4}})}), "polygon-parity"),
                 PrimitiveRejection::ZeroArea);
        QCOMPARE(rejectionOf(polygonOf({pixels({{30, 4}, {37, 4}, {33, 9}})}), "polygon-parity"),
                 PrimitiveRejection::OutsideFrame);
        QCOMPARE(rejectionOf(polygonOf({}), "polygon-parity"), PrimitiveRejection::ZeroArea);
    }

    /// These methods have no rule by which a polygon without area would be drawn.
    void noRuleIsSaidToPaintAPolygonWithoutArea()
    {
        for (const char *method :
             {"polygon-parity", "polygon-fan", "polygon-delaunay", "polygon-tessellation"}) {
            const auto rejection
                = rejectionOf(polygonOf({pixels({{1, 4}, {7, 4}, {3, 4}})}), method);
            QVERIFY(rejection.has_value());
            const QString text = rejectionText(*rejection);
            QVERIFY2(text.contains(u"only a triangle under the closed rule"), qPrintable(text));
        }
    }
};

PIXELPLUMB_TEST(TestPolygons)

} // namespace tst_polygons

#include "tst_polygons.moc"
