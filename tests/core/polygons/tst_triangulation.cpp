// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/triangulation.h"
#include "core/runs/explain/pixelhistory.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>

namespace tst_triangulation {

using namespace pixelplumb;

namespace {

/// A contour around the centre of a square, its vertices ordered by direction: concave, and simple
/// unless they leave a gap of half a turn.
Contour starContour(SeededRandom &dice, Lattice side, std::int64_t count)
{
    Contour contour;
    for (std::int64_t i = 0; i < count; ++i)
        contour.push_back({dice.between(0, side), dice.between(0, side)});
    std::ranges::sort(contour, {}, [side](const LatticePoint &point) {
        return std::atan2(double(2 * point.y - side), double(2 * point.x - side));
    });
    return contour;
}

/// Whether two edges cross in the interior of both.
bool cross(const ContourEdge &one, const ContourEdge &two)
{
    const auto parts = [](const ContourEdge &edge, const ContourEdge &other) {
        const Int128 from = doubledArea(edge.from, edge.to, other.from);
        const Int128 to = doubledArea(edge.from, edge.to, other.to);
        return (from < 0 && to > 0) || (from > 0 && to < 0);
    };
    return parts(one, two) && parts(two, one);
}

/// Whether the four vertices named by a rejection are the ends of two crossing edges.
bool namesACrossing(const Shape &shape, const Rejection &rejection)
{
    const std::vector<ContourEdge> edges = contoursOf(shape).edges;
    if (rejection.vertices.size() != 4)
        return false;
    const auto edge = [&](std::size_t end) {
        return ContourEdge{shape.vertices[rejection.vertices[end]].position,
                           shape.vertices[rejection.vertices[end + 1]].position};
    };
    return std::ranges::count(edges, edge(0)) > 0 && std::ranges::count(edges, edge(2)) > 0
        && cross(edge(0), edge(2));
}

/// The distance of a sample from the polygon's edges, px.
double distanceToEdges(const Shape &shape, std::int64_t x, std::int64_t y)
{
    double nearest = 1e9;
    for (const ContourEdge &edge : contoursOf(shape).edges) {
        const double dx = double(edge.to.x - edge.from.x) / 256;
        const double dy = double(edge.to.y - edge.from.y) / 256;
        const double px = double(x) - double(edge.from.x) / 256;
        const double py = double(y) - double(edge.from.y) / 256;
        const double length = dx * dx + dy * dy;
        const double t = length > 0 ? std::clamp((px * dx + py * dy) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, std::hypot(px - t * dx, py - t * dy));
    }
    return nearest;
}

Quantity setUpNumber(const TracedScene &traced, const char *id)
{
    const auto &numbers = traced.trace->numbers().setUp;
    const auto found = std::ranges::find(numbers, QString::fromLatin1(id), &NumberDescription::id);
    return traced.trace->setUp(0).cells[std::size_t(found - numbers.begin())];
}

} // namespace

/// Polygons as triangles (Scan Conversion slides, "From Polygons to Triangles"; Rasterization
/// slides, "Triangulation"): fans and Delaunay triangles against the truth of the whole polygon.
class TestTriangulation : public QObject {
    Q_OBJECT

private slots:
    void aFanCoversWhatItsConvexPolygonCovers()
    {
        int drawnPolygons = 0;
        for (std::uint32_t seed = 0; seed < 3000; ++seed) {
            SeededRandom dice(seed);
            const Lattice grid = seed % 2 == 0 ? 256 : 8;
            Contour contour = starContour(dice, 20 * 256 / grid, dice.between(3, 6));
            for (LatticePoint &point : contour)
                point = {point.x * grid, point.y * grid};
            const Shape shape = polygonOf({contour});
            if (rejectionOf(shape, "polygon-fan"))
                continue;
            ++drawnPolygons;
            const Scene scene = sceneOf({shape}, frameOf(22, 22), "polygon-fan");
            if (drawn(scene) != truthOf(scene))
                QFAIL(qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
        }
        QVERIFY(drawnPolygons > 300);
    }

    void aFanRejectsNonConvexPolygons_data()
    {
        QTest::addColumn<Shape>("shape");
        QTest::addColumn<bool>("isConvex");
        QTest::addColumn<std::vector<std::size_t>>("vertices");
        using Vertices = std::vector<std::size_t>;
        QTest::newRow("square") << polygonOf({pixels({{0, 0}, {4, 0}, {4, 4}, {0, 4}})}) << true
                                << Vertices{};
        QTest::newRow("clockwise")
            << polygonOf({pixels({{0, 0}, {0, 4}, {4, 4}, {4, 0}})}) << true << Vertices{};
        QTest::newRow("collinear and repeated vertices")
            << polygonOf({pixels({{0, 0}, {2, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}})}) << true
            << Vertices{};
        QTest::newRow("dent") << polygonOf({pixels({{0, 0}, {4, 0}, {1, 1}, {0, 4}})}) << false
                              << Vertices{2};
        QTest::newRow("dent at the first vertex, clockwise")
            << polygonOf({pixels({{3, 3}, {0, 4}, {4, 4}, {4, 0}})}) << false << Vertices{0};
        QTest::newRow("dent after a repeated vertex")
            << polygonOf({pixels({{0, 4}, {0, 0}, {0, 0}, {4, 0}, {1, 1}})}) << false
            << Vertices{4};
        QTest::newRow("spike") << polygonOf({pixels({{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}})})
                               << false << Vertices{1};
        QTest::newRow("pentagram: turns one way, round twice")
            << pentagram(ShapeFill::NonZero) << false << Vertices{};
        QTest::newRow("two contours")
            << polygonOf({pixels({{0, 0}, {2, 0}, {0, 2}}), pixels({{4, 4}, {6, 4}, {4, 6}})})
            << false << Vertices{};
    }
    void aFanRejectsNonConvexPolygons()
    {
        QFETCH(Shape, shape);
        QFETCH(bool, isConvex);
        const auto rejection = rejectionOf(shape, "polygon-fan");
        QCOMPARE(rejection.has_value(), !isConvex);
        if (rejection) {
            QCOMPARE(*rejection, PrimitiveRejection::NotConvex);
            QFETCH(std::vector<std::size_t>, vertices);
            QCOMPARE(rejection->vertices, vertices);
        }
    }

    void delaunayTrianglesCoverWhatThePolygonCovers()
    {
        int drawnPolygons = 0;
        int refused = 0;
        for (std::uint32_t seed = 0; seed < 2000; ++seed) {
            SeededRandom dice(seed);
            // Every third polygon has arbitrary vertices on a coarse grid, where contours touch and
            // overlap.
            const Lattice grid = seed % 3 == 0 ? 512 : seed % 3 == 1 ? 256 : 1;
            const Lattice side = 20 * 256 / grid;
            std::vector<Contour> contours;
            const std::int64_t count = dice.between(1, 2);
            for (std::int64_t i = 0; i < count; ++i) {
                contours.push_back(seed % 3 == 0 ? anyContour(dice, side, 1)
                                                 : starContour(dice, side, dice.between(3, 9)));
                for (LatticePoint &point : contours.back())
                    point = {point.x * grid, point.y * grid};
            }
            const Shape shape = polygonOf(contours, fills[std::size_t(dice.between(0, 1))]);
            const auto rejection = rejectionOf(shape, "polygon-delaunay");
            if (rejection == PrimitiveRejection::SelfCrossing) {
                QVERIFY2(namesACrossing(shape, *rejection), qPrintable(contoursText(shape)));
                ++refused;
                continue;
            }
            ++drawnPolygons;
            const Scene scene = sceneOf({shape}, frameOf(22, 22), "polygon-delaunay");
            if (drawn(scene) != truthOf(scene))
                QFAIL(qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
        }
        QVERIFY(drawnPolygons > 400);
        QVERIFY(refused > 400);
    }

    void delaunayTrianglesTakeHolesAndContoursThatTouch_data()
    {
        QTest::addColumn<Shape>("shape");
        const auto outer = pixels({{1, 1}, {15, 1}, {15, 15}, {1, 15}});
        QTest::newRow("hole") << polygonOf({outer, pixels({{4, 4}, {12, 4}, {8, 11}})});
        QTest::newRow("island in a hole")
            << polygonOf({outer, pixels({{3, 3}, {13, 3}, {13, 13}, {3, 13}}),
                          pixels({{6, 6}, {10, 6}, {10, 10}, {6, 10}})});
        QTest::newRow("the same contour twice: nothing") << polygonOf({outer, outer});
        QTest::newRow("the same contour twice, by winding")
            << polygonOf({outer, outer}, ShapeFill::NonZero);
        QTest::newRow("a hole that touches an edge with a vertex")
            << polygonOf({outer, pixels({{8, 1}, {12, 8}, {4, 8}})});
        QTest::newRow("neighbours whose edges overlap in part")
            << polygonOf({pixels({{1, 1}, {8, 1}, {8, 12}, {1, 12}}),
                          pixels({{8, 5}, {15, 5}, {15, 15}, {8, 15}})});
        QTest::newRow("an edge through a vertex of another contour")
            << polygonOf({pixels({{1, 1}, {15, 15}, {15, 1}}), pixels({{8, 8}, {2, 15}, {9, 15}})});
        QTest::newRow("a bow tie whose crossing is a vertex")
            << polygonOf({pixels({{1, 1}, {8, 8}, {15, 15}, {15, 1}, {8, 8}, {1, 15}})});
    }
    void delaunayTrianglesTakeHolesAndContoursThatTouch()
    {
        QFETCH(Shape, shape);
        const Scene scene = sceneOf({shape}, frameOf(17, 17), "polygon-delaunay");
        const auto traced = traceScene(scene);
        QVERIFY(!traced->trace->setUp(0).rejection);
        QCOMPARE(drawn(scene), truthOf(scene));
        QCOMPARE(traced->differences.total(), 0);
    }

    void aTessellationIsWrongAtMostBesideAnEdgeAndSaysSo()
    {
        constexpr double farthest = 0.0028; // √2/512
        int crossings = 0, wrong = 0;
        for (std::uint32_t seed = 0; seed < 400; ++seed) {
            SeededRandom dice(seed);
            const Shape shape = polygonOf(
                {anyContour(dice, 20 * 256, 1), anyContour(dice, 20 * 256, 1)}, fills[seed % 2]);
            const auto traced
                = traceScene(sceneOf({shape}, frameOf(22, 22), "polygon-tessellation"));
            const QString where = u"seed %1, "_s.arg(seed) + contoursText(shape);
            QVERIFY2(!traced->trace->setUp(0).rejection, qPrintable(where));
            crossings += int(setUpNumber(*traced, "crossing_points").toDouble());
            QVERIFY(setUpNumber(*traced, "moved").toDouble() <= farthest);
            for (std::int64_t y = 0; y < 22; ++y) {
                for (std::int64_t x = 0; x < 22; ++x) {
                    if (traced->differences.at(x, y) == Difference::None)
                        continue;
                    ++wrong;
                    QVERIFY2(distanceToEdges(shape, x, y) <= farthest, qPrintable(where));
                    const QString reason = pixelHistory(*traced, x, y).front().reason;
                    QVERIFY2(reason.contains(u"crossings were moved"_s), qPrintable(reason));
                }
            }
        }
        QVERIFY(crossings > 4000);
        QVERIFY2(wrong > 0, "else the moves are not seen anywhere");
    }

    void whatCrossesOnTheLatticeIsTessellatedExactly()
    {
        // A bow tie that crosses itself at (8, 8), and a plus sign of two bars, with four
        // crossings.
        const Shape bowTie = polygonOf({pixels({{1, 1}, {15, 15}, {15, 1}, {1, 15}})});
        const Shape bars = polygonOf({pixels({{2, 6}, {15, 6}, {15, 9}, {2, 9}}),
                                      pixels({{6, 2}, {9, 2}, {9, 15}, {6, 15}})});
        for (const auto &[shape, points] : {std::pair(bowTie, 1), std::pair(bars, 4)}) {
            for (const ShapeFill fill : fills) {
                Shape filled = shape;
                filled.fill = fill;
                const Scene scene = sceneOf({filled}, frameOf(17, 17), "polygon-tessellation");
                const auto traced = traceScene(scene);
                QCOMPARE(setUpNumber(*traced, "crossing_points").toDouble(), points);
                QCOMPARE(setUpNumber(*traced, "moved").toDouble(), 0.0);
                QCOMPARE(drawn(scene), truthOf(scene));
            }
        }
    }

    void withoutCrossingsATessellationIsTheDelaunayTriangulation()
    {
        for (std::uint32_t seed = 0; seed < 200; ++seed) {
            SeededRandom dice(seed);
            const Shape shape = polygonOf({starContour(dice, 20 * 256, dice.between(3, 9))});
            if (rejectionOf(shape, "polygon-delaunay"))
                continue;
            QCOMPARE(tessellationOf(contoursOf(shape)).triangles,
                     delaunayOf(contoursOf(shape)).triangles);
        }
    }

    void trianglesOfOnePolygonWriteEachPixelOnce()
    {
        for (const char *method : {"polygon-fan", "polygon-delaunay"}) {
            for (std::uint32_t seed = 0; seed < 300; ++seed) {
                SeededRandom dice(seed);
                const Shape shape = polygonOf({starContour(dice, 20 * 256, dice.between(3, 5))});
                const auto traced = traceScene(sceneOf({shape}, frameOf(22, 22), method));
                std::vector<std::pair<std::int64_t, std::int64_t>> written;
                for (std::size_t i = 0; i < traced->trace->sampleCount(); ++i) {
                    const PixelChange &change = traced->trace->changes()[i];
                    written.emplace_back(change.x, change.y);
                }
                std::ranges::sort(written);
                QVERIFY2(std::ranges::adjacent_find(written) == written.end(),
                         qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
                for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
                    const SpanRecord row = traced->trace->span(span);
                    QCOMPARE(row.cells.size(), traced->method->numbers.span.size());
                    QCOMPARE(std::int64_t(traced->trace->samples(span).size()), row.drawnSamples());
                }
            }
        }
    }

    void trianglesFarAwayAreTheTruth()
    {
        for (std::uint32_t seed = 0; seed < 200; ++seed) {
            SeededRandom dice(seed);
            const std::int32_t far = std::int32_t(dice.between(-1, 1) * (largestPixel - 40));
            const Shape shape = moved(polygonOf({starContour(dice, 20 * 256, 7)}),
                                      latticePixel(far, -std::int64_t(far)));
            const Scene scene = sceneOf({shape}, frameOf(22, 22, far, -far), "polygon-delaunay");
            if (!rejectionOf(shape, "polygon-delaunay") && drawn(scene) != truthOf(scene))
                QFAIL(qPrintable(u"seed %1, "_s.arg(seed) + contoursText(shape)));
        }
    }
};

PIXELPLUMB_TEST(TestTriangulation)

} // namespace tst_triangulation

#include "tst_triangulation.moc"
