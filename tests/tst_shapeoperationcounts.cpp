// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/countedarithmetic.h"
#include "core/scan/linebresenham.h"
#include "tests/support/countedbyhand.h"
#include "tests/support/shapes.h"

#include <QTest>

using namespace pixelplumb;
using enum pixelplumb::Operation;

namespace {

/// Of six pixels and one colour.
Primitives oneColourLine()
{
    Shape line = lineAt(0, 0, 5, 2);
    line.vertices[1].colour = line.vertices[0].colour;
    return {{}, {line}};
}

} // namespace

/// The same of lines, circles and polygons.
class TestShapeOperationCounts : public QObject {
    Q_OBJECT

private slots:
    void bresenhamDecidesByOneComparisonAndOneAdditionAStep()
    {
        const OperationCounts counts
            = countsOf("line-bresenham", Arithmetic::Exact, oneColourLine());
        QCOMPARE(counts.spans, std::int64_t(6));
        QCOMPARE(counts.pixels, std::int64_t(6));
        // p < 0?, p + increment; R G B advance by 2 additions and 1 comparison for a carry, which
        // one colour never has.
        QCOMPARE(
            departure(counts, WorkStage::Span,
                      {{IntegerAddition, 6 * (1 + 3 * 2)}, {Operation::Comparison, 6 * (1 + 3)}}),
            QString());
        QCOMPARE(counts.of(WorkStage::Pixel, Division), std::int64_t(0));
        // Those of the colours alone: 3 levels and 3 rates.
        QCOMPARE(counts.of(WorkStage::SetUp, Division), std::int64_t(3 + 3));
    }

    void theDivisionsAndMultiplicationsOfALineByBresenhamAreThoseOfItsColour()
    {
        const OperationCounts all = countsOf("line-bresenham", Arithmetic::Exact, oneColourLine());
        const OperationTally places; // what finds the pixels, without a colour
        using Integer = Counted<std::int64_t>;
        const auto setUp = bresenhamSetUp<Integer>({0, 0}, {5, 2});
        auto step = bresenhamStepAt(setUp, 0);
        const OperationRow begun = places.counts.totals();
        for (std::int64_t i = 0; i < 5; ++i)
            advance(setUp, step);
        QCOMPARE(step.place.along, std::int64_t(5));
        QCOMPARE(step.place.across, std::int64_t(2));

        const OperationRow row = places.counts.totals();
        for (const Operation none : {Division, Rounding, FloatAddition, Conversion, Function})
            QCOMPARE(row[std::size_t(none)], std::int64_t(0));
        QCOMPARE(row[std::size_t(Multiplication)], std::int64_t(2)); // 2Δx, 2Δy
        const auto ofSteps = [&](Operation operation) {
            return row[std::size_t(operation)] - begun[std::size_t(operation)];
        };
        QCOMPARE(ofSteps(Operation::Comparison), std::int64_t(5));
        QCOMPARE(ofSteps(IntegerAddition), std::int64_t(5));
        QVERIFY(all.totals()[std::size_t(Division)] > 0);
        QVERIFY(all.totals()[std::size_t(Multiplication)] > 2);
        // From column 4 on: the frame cuts the start off.
        bresenhamStepAt(setUp, 4);
        QCOMPARE(places.counts.totals()[std::size_t(Division)], std::int64_t(1));
        for (const char *part :
             {"no division, no rounding and no floating point", "Δx and Δy are doubled",
              "one comparison and one addition", "one division finds the first pixel"})
            QVERIFY2(countingGap(*methodNamed(u"line-bresenham"), Arithmetic::Exact)
                         .contains(QString::fromUtf8(part)),
                     part);
    }

    void theDdaRoundsAndAddsOnceAStep()
    {
        const OperationCounts counts = countsOf("line-dda", Arithmetic::Float32, oneColourLine());
        QCOMPARE(counts.of(WorkStage::SetUp, Division), std::int64_t(1 + 3)); // m, 3 rates
        QCOMPARE(
            departure(counts, WorkStage::Span, {{Rounding, 6 * 1}, {FloatAddition, 6 * (1 + 3)}}),
            QString());
        QCOMPARE(departure(counts, WorkStage::Pixel, {{Rounding, 6 * 3}}), QString());
    }

    void theMidpointCircleNeitherDividesNorRounds()
    {
        const OperationCounts counts
            = countsOf("circle-midpoint", Arithmetic::Exact, {{}, {circleAt(7, 6, 4)}});
        QVERIFY(counts.pixels > 0);
        for (const Operation operation : {Division, Rounding, FloatAddition, Conversion, Function})
            QCOMPARE(counts.totals()[std::size_t(operation)], std::int64_t(0));
        QCOMPARE(counts.total(WorkStage::Pixel), std::int64_t(0));
    }

    void theParametricCircleTakesASineAndACosineAStep()
    {
        const OperationCounts counts
            = countsOf("circle-parametric", Arithmetic::Float32, {{}, {circleAt(7, 6, 3)}});
        QCOMPARE(counts.spans, std::int64_t(19)); // ⌈2π·3⌉ steps
        // θ = n·step, centre + r·cos θ and centre + r·sin θ, and each plus 1/2 to an integer.
        QCOMPARE(departure(counts, WorkStage::Span,
                           {{Function, 19 * 2},
                            {Rounding, 19 * 2},
                            {FloatAddition, 19 * 4},
                            {Multiplication, 19 * 3},
                            {Conversion, 19 * 5}}),
                 QString());
    }

    void aPolygonAsksItsActiveEdgesAlone()
    {
        // Rows 2 … 5 cross the two upright edges of the four.
        Shape polygon;
        polygon.kind = PrimitiveKind::Polygon;
        polygon.fill = ShapeFill::EvenOdd;
        for (const auto &[x, y] :
             {std::pair(1, 1), std::pair(5, 1), std::pair(5, 5), std::pair(1, 5)})
            polygon.vertices.push_back({latticePixel(x, y), {{255, 0, 0}}});
        const OperationCounts counts
            = countsOf("polygon-parity", Arithmetic::Float32, {{}, {polygon}});
        QCOMPARE(counts.spans, std::int64_t(4));
        // A slope each, when the edge becomes active.
        QCOMPARE(counts.totals()[std::size_t(Division)], std::int64_t(2));
        // ⌈x⌉ where an edge becomes active and after each of its steps; it ends before the last.
        QCOMPARE(counts.of(WorkStage::Span, Rounding), std::int64_t(2 + 2 * 3));
    }
};

QTEST_GUILESS_MAIN(TestShapeOperationCounts)
#include "tst_shapeoperationcounts.moc"
