// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/countedarithmetic.h"
#include "core/lab/counting/operationtable.h"
#include "core/scan/lines/linesymmetric.h"
#include "tests/support/countedbyhand.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_shapeoperationcounts {

using namespace pixelplumb;
using enum pixelplumb::Operation;

namespace {

/// A line of six pixels in one colour.
Primitives oneColourLine()
{
    Shape line = lineAt(0, 0, 5, 2);
    line.vertices[1].colour = line.vertices[0].colour;
    return {{}, {line}};
}

/// The operations that find the pixels of a line from (0, 0) to (5, 2), without a colour: the
/// set-up, which includes the first pixel, and five steps.
struct PlaceCounts {
    OperationRow setUp = {};
    OperationRow steps = {};
};

template <class SetUp, class Step>
PlaceCounts placesFrom(const OperationTally &tally, const SetUp &setUp, Step step)
{
    PlaceCounts places;
    places.setUp = tally.counts.totals();
    for (int i = 0; i < 5; ++i)
        advance(setUp, step);
    if (step.place.along != 5 || step.place.across != 2)
        return {};
    const OperationRow all = tally.counts.totals();
    for (std::size_t kind = 0; kind < all.size(); ++kind)
        places.steps[kind] = all[kind] - places.setUp[kind];
    return places;
}

PlaceCounts placesByBresenham()
{
    const OperationTally tally;
    const auto setUp = bresenhamSetUp<Counted<std::int64_t>>({0, 0}, {5, 2});
    return placesFrom(tally, setUp, bresenhamStepAt(setUp, 0));
}

PlaceCounts placesSymmetrically()
{
    const OperationTally tally;
    const auto setUp = symmetricSetUp<Counted<Int128>>(lineAt(0, 0, 5, 2));
    return placesFrom(tally, setUp, symmetricStepAt(setUp, 0));
}

} // namespace

/// Operations of lines, circles and polygons, against counts by hand.
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
        // Divisions for the colours alone: 3 levels and 3 rates.
        QCOMPARE(counts.of(WorkStage::SetUp, Division), std::int64_t(3 + 3));
    }

    void bresenhamPlacementIsCountedByStage_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<PlaceCounts>("counted");
        QTest::addColumn<QString>("setUp");
        QTest::newRow("whole ends")
            << u"line-bresenham"_s << placesByBresenham()
            << u"set-up: 2 multiplications (2Δx and 2Δy), 4 additions (Δx, Δy, 2Δy − "
               "2Δx and p₀) and 2 comparisons"_s;
        QTest::newRow("sub-pixel ends")
            << u"line-bresenham-symmetric"_s << placesSymmetrically()
            << u"with 15 multiplications, 10 additions and 2 comparisons"_s;
    }
    void bresenhamPlacementIsCountedByStage()
    {
        QFETCH(QString, id);
        QFETCH(PlaceCounts, counted);
        QFETCH(QString, setUp);
        const bool hasWholeEnds = id == u"line-bresenham"_s;
        const auto of
            = [](const OperationRow &row, Operation kind) { return row[std::size_t(kind)]; };
        for (const Operation none : {Rounding, FloatAddition, Conversion, Function})
            QCOMPARE(of(counted.setUp, none) + of(counted.steps, none), std::int64_t(0));
        QCOMPARE(of(counted.setUp, Division), std::int64_t(hasWholeEnds ? 0 : 1));
        QCOMPARE(of(counted.setUp, Multiplication), std::int64_t(hasWholeEnds ? 2 : 15));
        QCOMPARE(of(counted.setUp, IntegerAddition), std::int64_t(hasWholeEnds ? 4 : 10));
        QCOMPARE(of(counted.setUp, Operation::Comparison), std::int64_t(2));
        QCOMPARE(of(counted.steps, Division) + of(counted.steps, Multiplication), std::int64_t(0));
        QCOMPARE(of(counted.steps, Operation::Comparison), std::int64_t(5));
        QCOMPARE(of(counted.steps, IntegerAddition), std::int64_t(5));

        const QString words = countingGap(*methodNamed(id), Arithmetic::Exact);
        for (const QString &part :
             {setUp, u"each step: 1 comparison (p with 0) and 1 addition (to p)"_s,
              u"no rounding and no floating point"_s,
              hasWholeEnds ? u"one division finds the first pixel"_s
                           : u"1 division, which finds the first pixel"_s})
            QVERIFY2(words.contains(part), qPrintable(words));
        // The rest belongs to the colour.
        const OperationCounts all = countsOf(qPrintable(id), Arithmetic::Exact, oneColourLine());
        QVERIFY(all.of(WorkStage::SetUp, Division) > of(counted.setUp, Division));
        QVERIFY(all.of(WorkStage::Span, IntegerAddition) > of(counted.steps, IntegerAddition));
    }

    void whereTheFrameCutsALineByBresenhamOneDivisionFindsItsFirstPixel()
    {
        const OperationTally places;
        using Integer = Counted<std::int64_t>;
        bresenhamStepAt(bresenhamSetUp<Integer>({0, 0}, {5, 2}), 4); // from column 4 on
        QCOMPARE(places.counts.totals()[std::size_t(Division)], std::int64_t(1));
    }

    void everyLineOfTheSlidesResumesHasItsWordsByStage_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id :
             {"line-slope-intercept", "line-dda", "line-bresenham", "line-bresenham-symmetric"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void everyLineOfTheSlidesResumesHasItsWordsByStage()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        for (const Arithmetic arithmetic : method.arithmetics) {
            const QString words = countingGap(method, arithmetic);
            QVERIFY2(words.contains(u"the set-up: "_s), qPrintable(words));
            QVERIFY2(words.contains(u"each step: "_s), qPrintable(words));
            QVERIFY2(words.contains(u"the colour's"_s), qPrintable(words));
        }
    }

    void aLineByItsEquationTakesTheOperationsThatItsWordsSay()
    {
        const OperationCounts counts
            = countsOf("line-slope-intercept", Arithmetic::Float32, oneColourLine());
        // m, 3 rates; m·x₀ of b.
        QCOMPARE(counts.of(WorkStage::SetUp, Division), std::int64_t(1 + 3));
        QCOMPARE(counts.of(WorkStage::SetUp, Multiplication), std::int64_t(1));
        QCOMPARE(counts.of(WorkStage::Span, Multiplication), std::int64_t(6 * (1 + 3))); // m·x
        QCOMPARE(counts.of(WorkStage::Span, Rounding), std::int64_t(6));
        QCOMPARE(countsOf("line-slope-intercept", Arithmetic::Exact, oneColourLine())
                     .of(WorkStage::Span, Division),
                 std::int64_t(6 * (1 + 3))); // of the row, of 3 levels
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
        // One slope per edge, when it becomes active.
        QCOMPARE(counts.totals()[std::size_t(Division)], std::int64_t(2));
        // ⌈x⌉ when an edge becomes active and after each of its steps; the last step is not needed.
        QCOMPARE(counts.of(WorkStage::Span, Rounding), std::int64_t(2 + 2 * 3));
    }

    /// A comb: on each of its rows some teeth have already ended.
    void anEdgeTableLooksAtFewerEdgesThanThereAre()
    {
        // Teeth of heights 2, 4 and 6 on a bar in rows 2 … 3; edges listed from the bar's lower
        // side.
        Shape comb;
        comb.kind = PrimitiveKind::Polygon;
        comb.fill = ShapeFill::EvenOdd;
        for (const auto &[x, y] :
             {std::pair(0, 1), std::pair(12, 1), std::pair(12, 9), std::pair(10, 9),
              std::pair(10, 3), std::pair(7, 3), std::pair(7, 7), std::pair(5, 7), std::pair(5, 3),
              std::pair(2, 3), std::pair(2, 5), std::pair(0, 5)})
            comb.vertices.push_back({latticePixel(x, y), {{255, 0, 0}}});
        const OperationCounts counts = countsOf("polygon-parity", Arithmetic::Exact, {{}, {comb}});
        // Rows 2 and 3 meet the two sides, 4 and 5 three teeth, 6 and 7 two, 8 and 9 one.
        QCOMPARE(counts.spans, std::int64_t(8));
        QCOMPARE(counts.edgesLookedAt, std::int64_t(2 * (2 + 6 + 4 + 2)));
        QCOMPARE(counts.edgesOfRows, std::int64_t(8 * 12));
        QVERIFY2(countsText(counts).endsWith(u", 28 of 96 edges looked at"_s),
                 qPrintable(countsText(counts)));

        const OperationCounts ofTriangle = countsOf(
            "column-scan", Arithmetic::Exact,
            {{Triangle{
                 {{{latticePixel(1, 1), {}}, {latticePixel(9, 2), {}}, {latticePixel(4, 8), {}}}}}},
             {}});
        QCOMPARE(ofTriangle.edgesOfRows, std::int64_t(0));
        QVERIFY(!countsText(ofTriangle).contains(u"edges"_s));
    }
};

PIXELPLUMB_TEST(TestShapeOperationCounts)

} // namespace tst_shapeoperationcounts

#include "tst_shapeoperationcounts.moc"
