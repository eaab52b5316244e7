// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_trianglemethods {

using namespace pixelplumb;

namespace {

/// Adds a row for each method, each arithmetic in which it claims to be stable, and each fill rule.
void addStableRows()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<ScanSettings>("settings");
    for (const Method *method : triangleMethods()) {
        for (const Arithmetic arithmetic : method->stableArithmetics) {
            for (const FillRule rule : method->fillRules) {
                const ScanSettings settings{arithmetic, rule, ByteRounding::Nearest};
                QTest::newRow(rowName(*method, settings).c_str()) << method->id << settings;
            }
        }
    }
}

/// Compares the method's picture with the oracle's; the message names the triangle.
bool drawsTheTruth(const Method &method, const Triangle &triangle, const ScanSettings &settings,
                   ScanPicture &drawn, ScanPicture &truth)
{
    drawn.clear();
    truth.clear();
    drawn.draw(method, triangle, settings);
    truth.drawTruth(triangle, settings);
    if (drawn == truth)
        return true;
    qWarning("%s", textOfTriangle(triangle).c_str());
    return false;
}

/// Vertices in and around a window, sometimes collinear or coincident.
Triangle randomTriangle(std::mt19937_64 &random, const FrameSpec &window, Lattice step)
{
    const auto coordinate = [&](std::int64_t first, std::int64_t length) {
        std::uniform_int_distribution<Lattice> within((first - 8) * unitsPerPixel / step,
                                                      (first + length + 8) * unitsPerPixel / step);
        return within(random) * step;
    };
    std::array<LatticePoint, 3> points;
    for (LatticePoint &point : points)
        point = {coordinate(window.firstColumn, window.width),
                 coordinate(window.firstRow, window.height)};
    switch (std::uniform_int_distribution<int>(0, 11)(random)) {
    case 0: // collinear: zero area
        points[2] = {2 * points[1].x - points[0].x, 2 * points[1].y - points[0].y};
        break;
    case 1: // two coincident vertices
        points[2] = points[std::uniform_int_distribution<std::size_t>(0, 1)(random)];
        break;
    case 2: // a sliver
        points[2] = {points[1].x + step, points[1].y - step};
        break;
    case 3: // a horizontal and a vertical edge
        points[1].y = points[0].y;
        points[2].x = points[0].x;
        break;
    default:
        break;
    }
    return triangleOf(points);
}

} // namespace

/// Every triangle method, in the slides' forms and in the stable ones, against the oracle.
class TestTriangleMethods : public QObject {
    Q_OBJECT

private slots:
    void drawsTheTruthForEveryTriangleOfALattice_data() { addStableRows(); }
    void drawsTheTruthForEveryTriangleOfALattice()
    {
        QFETCH(QString, id);
        QFETCH(ScanSettings, settings);
        const Method &method = *methodNamed(id);
        ScanPicture drawn(frameOf(5, 5)), truth(frameOf(5, 5));
        constexpr std::int64_t side = 5;
        const auto point
            = [](std::int64_t index) { return latticePixel(index % side, index / side); };
        bool allTrue = true;
        for (std::int64_t a = 0; a < side * side && allTrue; a += isSanitized ? 7 : 1) {
            for (std::int64_t b = 0; b < side * side && allTrue; ++b) {
                for (std::int64_t c = 0; c < side * side && allTrue; ++c)
                    allTrue = drawsTheTruth(method, triangleOf({{point(a), point(b), point(c)}}),
                                            settings, drawn, truth);
            }
        }
        QVERIFY(allTrue);
    }

    void drawsTheTruthForTrianglesOfALargerLattice_data() { addStableRows(); }
    void drawsTheTruthForTrianglesOfALargerLattice()
    {
        QFETCH(QString, id);
        QFETCH(ScanSettings, settings);
        const Method &method = *methodNamed(id);
        ScanPicture drawn(frameOf(8, 8)), truth(frameOf(8, 8));
        // Every 37th of the 64³ triangles of whole vertices; with sanitizers every 299th.
        for (std::int64_t index = 0; index < 64 * 64 * 64; index += isSanitized ? 299 : 37) {
            const auto point = [&](std::int64_t divisor) {
                const std::int64_t place = index / divisor % 64;
                return latticePixel(place % 8, place / 8);
            };
            QVERIFY(drawsTheTruth(method, triangleOf({{point(1), point(64), point(4096)}}),
                                  settings, drawn, truth));
        }
    }

    void drawsTheTruthNearAndFarFromTheOrigin_data() { addStableRows(); }
    void drawsTheTruthNearAndFarFromTheOrigin()
    {
        QFETCH(QString, id);
        QFETCH(ScanSettings, settings);
        const Method &method = *methodNamed(id);
        constexpr std::uint64_t seed = 20;
        std::mt19937_64 random(seed);
        for (const Lattice step : {256, 16, 1}) {
            for (const std::int32_t origin : {0, 16384, -16384, 1 << 20, -(1 << 20)}) {
                ScanPicture drawn(frameOf(24, 20, origin, -origin)),
                    truth(frameOf(24, 20, origin, -origin));
                for (int i = 0; i < fewerIfSanitized(60); ++i) {
                    const Triangle triangle = randomTriangle(random, drawn.spec(), step);
                    settings.rounding = i % 4 == 0 ? ByteRounding::Truncate : ByteRounding::Nearest;
                    QVERIFY2(drawsTheTruth(method, triangle, settings, drawn, truth),
                             qPrintable(u"seed %1, origin %2"_s.arg(seed).arg(origin)));
                }
            }
        }
    }

    void drawsTheTruthForTheLargestTriangles_data() { addStableRows(); }
    void drawsTheTruthForTheLargestTriangles()
    {
        QFETCH(QString, id);
        QFETCH(ScanSettings, settings);
        const Method &method = *methodNamed(id);
        constexpr std::uint64_t seed = 7;
        std::mt19937_64 random(seed);
        std::uniform_int_distribution<Lattice> anywhere(-largestCoordinate, largestCoordinate);
        std::uniform_int_distribution<Lattice> near(-4000, 4000);
        for (int i = 0; i < fewerIfSanitized(200); ++i) {
            std::array<LatticePoint, 3> points;
            for (LatticePoint &point : points)
                point = {anywhere(random), anywhere(random)};
            if (i % 2 == 0)
                points[0] = {near(random), near(random)};
            if (i % 3 == 0)
                points[1] = {-points[2].x, -points[2].y};
            ScanPicture drawn(frameOf(12, 10, -5, -5)), truth(frameOf(12, 10, -5, -5));
            QVERIFY2(drawsTheTruth(method, triangleOf(points), settings, drawn, truth),
                     qPrintable(u"seed %1"_s.arg(seed)));
        }
    }

    void biasScanComputesInIntegersOutsideItsProvedDomainAndSaysSo()
    {
        const Method &method = *methodNamed(u"column-scan-bias");
        const auto isProved = [&](const Triangle &triangle) {
            Scene scene;
            scene.method = "column-scan-bias";
            scene.settings.arithmetic = Arithmetic::Float64;
            scene.triangles = {triangle};
            return traceScene(scene)->trace->setUp(0).cells.back();
        };
        QCOMPARE(method.numbers.setUp.back().title, u"proved₀₂"_s);
        // W'·H' = 2^20 · 2^20, then one row more.
        QCOMPARE(isProved(triangleOf({{{0, 0}, {1 << 20, 1 << 20}, {0, 300}}})),
                 Quantity::integer(1));
        QCOMPARE(isProved(triangleOf({{{0, 0}, {1 << 20, (1 << 20) + 1}, {0, 300}}})),
                 Quantity::integer(0));
    }

    /// Each column of a filled outline reaches from the lowest pixel of its three lines to the
    /// highest.
    void aFilledOutlineIsItsLinesAndWhatLiesBetweenThem()
    {
        const Method &fill = *methodNamed(u"midpoint-outline-fill");
        const Method &bresenham = *methodNamed(u"line-bresenham");
        std::mt19937_64 random(20261123);
        int beyondTheTruth = 0;
        for (int round = 0; round < 400; ++round) {
            ScanPicture drawn(frameOf(24, 20, -3, 2));
            ScanPicture lines(frameOf(24, 120, -3, -46)); // with all rows that a triangle can reach
            ScanPicture truth(frameOf(24, 20, -3, 2));
            const Triangle triangle
                = randomTriangle(random, drawn.spec(), round % 2 == 0 ? 256 : 37);
            drawn.draw(fill, triangle, {});
            truth.drawTruth(triangle, {});
            Primitives outline;
            for (std::size_t edge = 0; edge < 3; ++edge)
                outline.shapes.push_back(lineAtUnits(triangle.vertices[edge].position,
                                                     triangle.vertices[(edge + 1) % 3].position));
            Run(&bresenham, outline, {}, lines.view()).draw(lines.view());
            for (std::int64_t x = -3; x < 21; ++x) {
                std::int64_t lowest = 1000;
                std::int64_t highest = -1000;
                for (std::int64_t y = -46; y < 74; ++y) {
                    if (lines.at(x, y) == 0)
                        continue;
                    lowest = std::min(lowest, y);
                    highest = y;
                }
                for (std::int64_t y = 2; y < 22; ++y) {
                    const bool isFilled = y >= lowest && y <= highest;
                    QVERIFY2((drawn.at(x, y) != 0) == isFilled, textOfTriangle(triangle).c_str());
                    beyondTheTruth += isFilled && truth.at(x, y) == 0;
                    // On whole pixels it has everything that the truth has.
                    QVERIFY2(round % 2 != 0 || isFilled || truth.at(x, y) == 0,
                             textOfTriangle(triangle).c_str());
                }
            }
        }
        QVERIFY(beyondTheTruth > 1000);
    }

    void refusesTheRulesThatAMethodCannotKeep()
    {
        const Method &rows = *methodNamed(u"row-walk");
        QVERIFY(rows.refusal({Arithmetic::Exact, FillRule::HalfOpenColumn, {}})
                    .contains(rows.fillRuleReason));
        const Method &offScreen = *methodNamed(u"barycentric-off-screen");
        QVERIFY(offScreen.refusal({Arithmetic::Exact, FillRule::Closed, {}})
                    .contains(offScreen.fillRuleReason));
        QVERIFY(offScreen.refusal({Arithmetic::Exact, FillRule::OffScreenPoint, {}}).isEmpty());
    }
};

PIXELPLUMB_TEST(TestTriangleMethods)

} // namespace tst_trianglemethods

#include "tst_trianglemethods.moc"
