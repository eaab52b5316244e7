// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scan/tests/edgeline.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_equationmisprints {

using namespace pixelplumb;

namespace {

Triangle triangleAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                    std::int64_t x2, std::int64_t y2)
{
    return {{{{latticePixel(x0, y0), {{255, 0, 0}}},
              {latticePixel(x1, y1), {{0, 255, 0}}},
              {latticePixel(x2, y2), {{0, 0, 255}}}}}};
}

using ExactLine = EdgeLine<ExactPlane<Int128>>;

ExactLine lineThrough(const LatticePoint &p, const LatticePoint &q,
                      LineForm form = LineForm::Absolute)
{
    return ExactLine(form, p, q, p);
}

/// a·x + b·y + c in pixels, with the given coefficients.
double at(double a, double b, double c, double x, double y) { return a * x + b * y + c; }

/// The cells of a traced sample with these titles.
std::vector<Quantity> cellsOf(const TracedScene &traced, std::int64_t x, std::int64_t y,
                              const QStringList &titles)
{
    std::vector<Quantity> cells;
    for (std::size_t span = 0; span < traced.trace->spanCount(); ++span) {
        for (const SampleRecord &sample : traced.trace->samples(span)) {
            if (sample.x != x || sample.y != y)
                continue;
            const auto &columns = traced.method->numbers.sample;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if (titles.contains(columns[i].title))
                    cells.push_back(sample.cells[i]);
            }
        }
    }
    return cells;
}

} // namespace

/// The slides' misprints (resources/misprints.md) in equations of edges, planes and weights, each
/// with the right form and the slides' own numbers.
class TestEquationMisprints : public QObject {
    Q_OBJECT

private slots:
    void edgeCoefficientsVanishAtBothVerticesAndThePrintedOnesDoNot()
    {
        const double x0 = 3, y0 = 5, x1 = 11, y1 = 7;
        const ExactLine line = lineThrough(latticePixel(3, 5), latticePixel(11, 7));
        QCOMPARE(line.valueAt<LineForm::Absolute>(latticePixel(3, 5)), Int128(0));
        QCOMPARE(line.valueAt<LineForm::Absolute>(latticePixel(11, 7)), Int128(0));
        QCOMPARE(double(line.a) / 256, y1 - y0);
        QCOMPARE(double(line.b) / 256, x0 - x1);
        QCOMPARE(double(line.c) / 65536, x1 * y0 - x0 * y1);
        // As printed: B = y₀ − x₁, C = x₀y₀ − x₀y₁.
        QVERIFY(at(y1 - y0, y0 - x1, x0 * y0 - x0 * y1, x1, y1) != 0);
        // With only B corrected, C is still not that of a line through the two points.
        QVERIFY(at(y1 - y0, x0 - x1, x0 * y0 - x0 * y1, x0, y0) != 0);
    }

    void theExampleEdgeHasTheSlidesNumbers()
    {
        // −2x − y + 2 passes through (0, 2) and (1, 0).
        const ExactLine line = lineThrough(latticePixel(0, 2), latticePixel(1, 0));
        QCOMPARE(A::quantityOfRate(line.a, line.unit), Quantity::integer(-2));
        QCOMPARE(A::quantityOfRate(line.b, line.unit), Quantity::integer(-1));
        QCOMPARE(A::quantityOf(line.c, line.unit), Quantity::integer(2));
        QCOMPARE(valueOf(line, 0, 0), Quantity::integer(2));
        QCOMPARE(valueOf(line, 1, 0), Quantity::integer(0));
        // F′(0, 0) = 1 for k = ½: −x − y/2 + 1.
        QCOMPARE(Quantity::rational(line.c, 2 * line.unit), Quantity::integer(1));
        QCOMPARE(A::quantityOfRate(line.b, 2 * line.unit), Quantity::rational(-1, 2));
    }

    void strictAndWeakTestsDifferOnTheBoundaryAlone()
    {
        // The second of the Triangle Rasterization slides, "Triangle rasterization implementation
        // guidelines", keeps E >= 0: the closed rule. Under E > 0 no boundary sample is drawn,
        // under E >= 0 all are: Pick's count A + B/2 + 1 against A − B/2 + 1.
        const Triangle triangle = triangleAt(0, 0, 8, 0, 0, 8);
        ScanPicture closed(frameOf(10, 10));
        closed.draw(*methodNamed(u"edge-equations"), triangle, {});
        int weak = 0, strict = 0;
        for (std::int64_t y = 0; y < 10; ++y) {
            for (std::int64_t x = 0; x < 10; ++x) {
                const auto verdict = oracle::judge(triangle, FillRule::Closed, x, y);
                weak += int(closed.at(x, y) != 0);
                strict += int(std::ranges::all_of(
                    verdict.edges, [](const auto &edge) { return edge.edgeFunction > 0; }));
            }
        }
        QCOMPARE(weak, 32 + 24 / 2 + 1);
        QCOMPARE(strict, 32 - 24 / 2 + 1);
    }

    void theSolvedSystemIsRightExceptWhereItsDeterminantIsZero()
    {
        const LatticePoint p = latticePixel(3, 5), q = latticePixel(11, 7);
        const ExactLine line = lineThrough(p, q, LineForm::Solved);
        QCOMPARE(line.valueAt<LineForm::Solved>(p), Int128(0));
        QCOMPARE(line.valueAt<LineForm::Solved>(q), Int128(0));
        QCOMPARE(A::quantityOf(line.c, line.unit), Quantity::integer(-1));
        // 3·7 − 5·11 = −34: A = (7 − 5)/−34, B = (3 − 11)/−34.
        QCOMPARE(A::quantityOfRate(line.a, line.unit), Quantity::rational(-2, 34));
        QCOMPARE(A::quantityOfRate(line.b, line.unit), Quantity::rational(8, 34));
        // A line through (0, 0): no solution with C ≠ 0.
        const ExactLine throughOrigin
            = lineThrough(latticePixel(2, 3), latticePixel(4, 6), LineForm::Solved);
        QCOMPARE(throughOrigin.determinant, Int128(0));
        QCOMPARE(throughOrigin.c, Int128(0));
        QCOMPARE(throughOrigin.valueAt<LineForm::Solved>(latticePixel(4, 6)), Int128(0));
        QVERIFY(throughOrigin.valueAt<LineForm::Solved>(latticePixel(1, 0)) != 0);
    }

    void thePlaneEquationNeedsItsConstantTerm()
    {
        // v = 1, 4 and 9 at (0, 0), (1, 0) and (0, 1): v = 3x + 8y + 1.
        const double a = -3, b = -8, c = 1; // N = (P₂ − P₁) × (P₃ − P₁)
        const double d = -(c * 1); // D = −N·P₁
        const auto value = [&](double x, double y) { return -a / c * x - b / c * y - d / c; };
        QCOMPARE(value(0, 0), 1.0);
        QCOMPARE(value(1, 0), 4.0);
        QCOMPARE(value(0, 1), 9.0);
        // As printed, "Ax + By + Cv + 0 = 0": the plane would pass through (0, 0, 0).
        QVERIFY(a * 0 + b * 0 + c * 1 != 0);
        QCOMPARE(a * 0 + b * 0 + c * 1 + d, 0.0);
    }

    void aWeightIsTheSameByEitherNameOfItsEdge()
    {
        // f_ac = −f_ca: divided by their values at b they agree; their signs alone do not.
        const LatticePoint a = latticePixel(2, 1), b = latticePixel(9, 3), c = latticePixel(4, 8);
        const ExactLine ca = lineThrough(c, a), ac = lineThrough(a, c);
        const LatticePoint sample = latticePixel(5, 4);
        const auto weight = [&](const ExactLine &line) {
            using Plane = ExactPlane<Int128>;
            const Plane::Divisor atB(line.valueAt<LineForm::Absolute>(b));
            return Plane::quantityOf(Plane::ratio(line.valueAt<LineForm::Absolute>(sample), atB));
        };
        QCOMPARE(weight(ac), weight(ca));
        QCOMPARE(ac.valueAt<LineForm::Absolute>(sample), -ca.valueAt<LineForm::Absolute>(sample));
    }

    void theBarycentricGridHasTheSlidesNumbers_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("titles");
        QTest::newRow("all") << u"barycentric-all"_s << QStringList{u"α"_s, u"β"_s, u"γ"_s};
        QTest::newRow("Cramer") << u"barycentric-cramer"_s << QStringList{u"u"_s, u"v"_s, u"w"_s};
    }
    void theBarycentricGridHasTheSlidesNumbers()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, titles);
        // A at (0, 0), B at (5, 5), C at (5, 0): u falls by 1/5 from column to column, v grows by
        // 1/5 from row to row.
        Scene scene;
        scene.method = id.toStdString();
        scene.frame.width = 7;
        scene.frame.height = 8;
        scene.frame.firstRow = -1;
        scene.triangles = {triangleAt(0, 0, 5, 5, 5, 0)};
        const auto traced = traceScene(scene);
        const bool seesAll = id == u"barycentric-all"_s;
        int compared = 0;
        for (std::int64_t y = seesAll ? -1 : 0; y <= (seesAll ? 6 : 5); ++y) {
            for (std::int64_t x = 0; x <= (seesAll ? 6 : 5); ++x) {
                const std::vector<Quantity> expected
                    = {Quantity::rational(5 - x, 5), Quantity::rational(y, 5),
                       Quantity::rational(x - y, 5)};
                QCOMPARE(cellsOf(*traced, x, y, titles), expected);
                ++compared;
            }
        }
        QCOMPARE(compared, seesAll ? 56 : 36);
        // The printed row v = 0.2, and its gap: −0.2 0.0 0.2 _ 0.6 0.8 1.0.
        if (seesAll)
            QCOMPARE(cellsOf(*traced, 3, 1, titles)[2], Quantity::rational(4, 10));
    }

    void normalisedWeightsArePositiveInsideForEitherWinding()
    {
        for (const Triangle &triangle :
             {triangleAt(0, 0, 6, 0, 0, 6), triangleAt(0, 0, 0, 6, 6, 0)}) {
            Scene scene;
            scene.method = "barycentric-all";
            scene.triangles = {triangle};
            const auto traced = traceScene(scene);
            for (const Quantity &weight : cellsOf(*traced, 2, 2, {u"α"_s, u"β"_s, u"γ"_s}))
                QVERIFY(weight.toDouble() > 0);
        }
    }

private:
    using A = ExactPlane<Int128>;

    static Quantity valueOf(const ExactLine &line, std::int64_t x, std::int64_t y)
    {
        return A::quantityOf(line.valueAt<LineForm::Absolute>(latticePixel(x, y)), line.unit);
    }
};

PIXELPLUMB_TEST(TestEquationMisprints)

} // namespace tst_equationmisprints

#include "tst_equationmisprints.moc"
