// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <rapidcheck.h>

#include <cmath>
#include <sstream>

namespace tst_oracle {

using namespace pixelplumb;

namespace {

/// Where random vertices come from, and which window of the plane is compared.
struct Family {
    Lattice extent; ///< coordinates within ± this, lattice units
    Lattice grid; ///< all coordinates are multiples of this
    std::int32_t window; ///< side of the compared frame, px
};

Triangle fromCoordinates(const std::array<Lattice, 6> &c, const std::array<int, 3> &levels)
{
    Triangle triangle = triangleAtUnits({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]});
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i].colour = {
            {std::uint8_t(levels[i]), std::uint8_t(255 - levels[i]), std::uint8_t(levels[i] / 2)}};
    return triangle;
}

rc::Gen<Triangle> triangles(const Family &family)
{
    const Lattice steps = family.extent / family.grid;
    const auto coordinate = rc::gen::map(rc::gen::inRange<Lattice>(-steps, steps + 1),
                                         [grid = family.grid](Lattice n) { return n * grid; });
    return rc::gen::apply(fromCoordinates, rc::gen::container<std::array<Lattice, 6>>(coordinate),
                          rc::gen::container<std::array<int, 3>>(rc::gen::inRange(0, 256)));
}

/// A window that the triangle's boundary crosses: at a point between two of its vertices.
FrameSpec windowOn(const Triangle &triangle, std::int32_t side, int edge, int sixteenths)
{
    const LatticePoint a = triangle.vertices[std::size_t(edge)].position;
    const LatticePoint b = triangle.vertices[std::size_t((edge + 1) % 3)].position;
    const Lattice x = a.x + (b.x - a.x) / 16 * sixteenths;
    const Lattice y = a.y + (b.y - a.y) / 16 * sixteenths;
    return frameOf(side, side, std::int32_t(floorPixel(x) - side / 2),
                   std::int32_t(floorPixel(y) - side / 2));
}

bool agree(const Triangle &triangle, const FrameSpec &spec, FillRule rule, ByteRounding rounding)
{
    const ScanSettings settings{Arithmetic::Exact, rule, rounding};
    ScanPicture byScan(spec);
    byScan.draw(columnScan(), triangle, settings);
    ScanPicture byOracle(spec);
    byOracle.drawTruth(triangle, settings);
    return byScan == byOracle;
}

} // namespace

/// The column scan in exact arithmetic against the truth, with which it shares no code.
class TestOracle : public QObject {
    Q_OBJECT

private slots:
    void agreesWithTheScanOnEveryTriangleOfAnEightByEightLattice_data()
    {
        QTest::addColumn<FillRule>("rule");
        QTest::newRow("closed") << FillRule::Closed;
        QTest::newRow("half-open-column") << FillRule::HalfOpenColumn;
        QTest::newRow("open") << FillRule::Open;
    }
    void agreesWithTheScanOnEveryTriangleOfAnEightByEightLattice()
    {
        QFETCH(FillRule, rule);
        const ScanSettings settings{Arithmetic::Exact, rule, ByteRounding::Nearest};
        ScanPicture byScan(frameOf(8, 8));
        ScanPicture byOracle(frameOf(8, 8));
        std::int64_t disagreements = 0;
        std::int64_t compared = 0;
        for (int code = 0; code < 64 * 64 * 64; ++code) {
            const Triangle triangle = triangleAt(code & 7, code >> 3 & 7, code >> 6 & 7,
                                                 code >> 9 & 7, code >> 12 & 7, code >> 15 & 7);
            byScan.clear();
            byScan.draw(columnScan(), triangle, settings);
            byOracle.clear();
            byOracle.drawTruth(triangle, settings);
            ++compared;
            if (!(byScan == byOracle) && ++disagreements <= 4) {
                std::ostringstream name;
                name << triangle;
                qWarning("differs: %s\n%s\n%s", name.str().c_str(), qPrintable(byScan.text()),
                         qPrintable(byOracle.text()));
            }
        }
        QCOMPARE(compared, std::int64_t(262144));
        QCOMPARE(disagreements, std::int64_t(0));
    }

    void agreesWithTheScanOnRandomTriangles_data()
    {
        QTest::addColumn<Lattice>("extent");
        QTest::addColumn<Lattice>("grid");
        QTest::addColumn<int>("window");
        constexpr Lattice px = unitsPerPixel;
        QTest::newRow("1/256 px, a few pixels") << 6 * px << Lattice(1) << 12;
        QTest::newRow("1/16 px, 24 px") << 24 * px << Lattice(16) << 48;
        QTest::newRow("whole pixels, 64 px") << 32 * px << px << 64;
        QTest::newRow("1/256 px, 2048 px") << 2048 * px << Lattice(1) << 33;
        QTest::newRow("whole pixels, 2^20 px") << (Lattice(1) << 20) * px << px << 33;
        QTest::newRow("1/256 px, 2^20 px") << (Lattice(1) << 20) * px << Lattice(1) << 33;
        QTest::newRow("1/256 px, 2^29 px") << (Lattice(1) << 29) * px << Lattice(1) << 17;
    }
    void agreesWithTheScanOnRandomTriangles()
    {
        QFETCH(Lattice, extent);
        QFETCH(Lattice, grid);
        QFETCH(int, window);
        const auto property = [&] {
            const Triangle triangle = *triangles({extent, grid, window});
            const int edge = *rc::gen::inRange(0, 3);
            const int sixteenths = *rc::gen::inRange(0, 17);
            const FillRule rule
                = *rc::gen::element(FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open);
            const ByteRounding rounding
                = *rc::gen::element(ByteRounding::Nearest, ByteRounding::Truncate);
            RC_ASSERT(
                agree(triangle, windowOn(triangle, window, edge, sixteenths), rule, rounding));
        };
        QVERIFY(rc::check(QTest::currentDataTag(), property));
    }

    void coversEachSampleOfTwoTrianglesOnceUnderTheWatertightRules()
    {
        const bool held = rc::check("a quad cut along its diagonal is tiled once", [] {
            const Triangle first = *triangles({20 * unitsPerPixel, 16, 48});
            // The fourth corner is the first vertex mirrored at the midpoint of the opposite edge.
            Triangle second = first;
            const auto &v = first.vertices;
            second.vertices[0].position = {v[1].position.x + v[2].position.x - v[0].position.x,
                                           v[1].position.y + v[2].position.y - v[0].position.y};
            RC_PRE(doubledArea(first) != 0);
            for (const FillRule rule :
                 {FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::Closed}) {
                for (std::int64_t y = -48; y < 48; ++y) {
                    for (std::int64_t x = -48; x < 48; ++x) {
                        const bool a = oracle::covers(first, rule, x, y);
                        const bool b = oracle::covers(second, rule, x, y);
                        if (rule == FillRule::Closed) {
                            // Inside the quad the two closed triangles meet only on the diagonal.
                            const auto verdict = oracle::judge(first, rule, x, y);
                            RC_ASSERT(!(a && b) || verdict.edges[1].edgeFunction == 0);
                        } else {
                            RC_ASSERT(!(a && b));
                        }
                    }
                }
            }
        });
        QVERIFY(held);
    }

    void countsWhatPicksTheoremCounts()
    {
        const bool held = rc::check("closed coverage is A + B/2 + 1", [] {
            const Triangle triangle = *triangles({30 * unitsPerPixel, unitsPerPixel, 64});
            RC_PRE(doubledArea(triangle) != 0);
            std::int64_t boundary = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const LatticePoint a = triangle.vertices[i].position;
                const LatticePoint b = triangle.vertices[(i + 1) % 3].position;
                boundary
                    += std::int64_t(greatestCommonDivisor(b.x - a.x, b.y - a.y)) / unitsPerPixel;
            }
            const auto area
                = std::int64_t(absolute(doubledArea(triangle))) / (unitsPerPixel * unitsPerPixel);
            ScanPicture drawing(frameOf(61, 61, -30, -30));
            drawing.draw(columnScan(), triangle, {});
            RC_ASSERT(2 * drawing.count() == area + boundary + 2);
        });
        QVERIFY(held);
    }

    void givesTheNumbersOfAColumn()
    {
        const Triangle triangle = triangleAtUnits({1024, 1280}, {14848, 3072}, {6784, 11264});
        const auto column = oracle::columnAt(triangle, FillRule::Closed, 27);
        QVERIFY(column.has_value());
        QCOMPARE(toText(column->yBottom), u"7 53/54"_s); // 5 + 23·7/54
        QCOMPARE(toText(column->yTop), u"43 31/63"_s); // 44 − (1/2)·(64/63)
        QCOMPARE(column->firstRow, std::int64_t(8));
        QCOMPARE(column->endRow, std::int64_t(44));
        QVERIFY(!oracle::columnAt(triangle, FillRule::Closed, 3).has_value());
    }

    void tellsWhichEdgeRefusesASampleAndByHowMuch()
    {
        const Triangle triangle = triangleAt(0, 0, 8, 0, 0, 8);
        const auto verdict = oracle::judge(triangle, FillRule::Closed, 6, 5);
        QVERIFY(!verdict.covered);
        QVERIFY(verdict.edges[0].accepts);
        QVERIFY(!verdict.edges[1].accepts); // x + y = 8, the sample is at 11
        QCOMPARE(toText(verdict.edges[1].distanceAlongColumn), u"-3"_s);
        QVERIFY(qAbs(verdict.edges[1].distance + 3 / std::sqrt(2.0)) < 1e-12);
        QVERIFY(oracle::covers(triangle, FillRule::Closed, 4, 4));
        QVERIFY(!oracle::covers(triangle, FillRule::HalfOpenColumn, 4, 4));
    }
};

PIXELPLUMB_TEST(TestOracle)

} // namespace tst_oracle

#include "tst_oracle.moc"
