// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/lab/operationtable.h"
#include "core/lab/standardexamples.h"
#include "core/scan/choicenames.h"
#include "tests/support/scenesformethods.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <numeric>

using namespace pixelplumb;

namespace {

using enum Operation;

constexpr std::int32_t side = 16; // px, of every frame here

FrameSpec square(std::int32_t pixels)
{
    FrameSpec spec;
    spec.width = pixels;
    spec.height = pixels;
    return spec;
}

/// On columns 0 … 4 it has 1, 3, 5, 3 and 1 pixels. All slopes and all changes of its colours from
/// pixel to pixel are integers, so that nothing is ever carried.
Primitives tentTriangle()
{
    Triangle triangle;
    triangle.vertices = {{{latticePixel(0, 0), {{0, 0, 0}}},
                          {latticePixel(4, 0), {{80, 40, 0}}},
                          {latticePixel(2, 4), {{40, 80, 20}}}}};
    return {{triangle}, {}};
}

/// Of six pixels and one colour.
Primitives oneColourLine()
{
    Shape line = lineAt(0, 0, 5, 2);
    line.vertices[1].colour = line.vertices[0].colour;
    return {{}, {line}};
}

OperationCounts countsOf(const char *method, Arithmetic arithmetic, const Primitives &primitives,
                         std::int32_t pixels = side)
{
    const FrameBuffer frame(square(pixels));
    ScanSettings settings = methodNamed(QString::fromLatin1(method))->adapted({});
    settings.arithmetic = arithmetic;
    return countOperations(*methodNamed(QString::fromLatin1(method)), settings, primitives,
                           frame.view())
        .value();
}

/// What differs, in words; empty where a stage has these counts and no others.
QString departure(const OperationCounts &counts, WorkStage stage,
                  const std::vector<std::pair<Operation, std::int64_t>> &expected)
{
    OperationRow wanted = {};
    for (const auto &[operation, count] : expected)
        wanted[std::size_t(operation)] = count;
    QStringList differing;
    for (const Operation operation : allOperations) {
        if (counts.of(stage, operation) != wanted[std::size_t(operation)])
            differing.append(QStringLiteral("%1 %2 instead of %3")
                                 .arg(counts.of(stage, operation))
                                 .arg(QString::fromLatin1(nameOf(operation).data()))
                                 .arg(wanted[std::size_t(operation)]));
    }
    return differing.join(QStringLiteral(", "));
}

} // namespace

/// Operations counted by kernels in numbers that count, against operations counted by hand.
class TestOperationCounts : public QObject {
    Q_OBJECT

private slots:
    void aColumnScanInFloat32IsCountedAsByHand()
    {
        const OperationCounts counts = countsOf("column-scan", Arithmetic::Float32, tentTriangle());
        QCOMPARE(counts.primitives, std::int64_t(1));
        QCOMPARE(counts.spans, std::int64_t(5));
        QCOMPARE(counts.pixels, std::int64_t(13));
        QCOMPARE(counts.refused, std::int64_t(0));
        // An edge's slope is (yb − ya)/(xb − xa): 4 coordinates become floats, 2 subtractions, 1
        // division. Each of 3 colour rates is (cb − ca)/(xb − xa): 1 subtraction of bytes, 3
        // conversions, 1 subtraction, 1 division. The walk starts at a + (x − xa)·m: the pre-step
        // takes 2 conversions and 1 subtraction; y and 3 colours each 1 conversion, 1
        // multiplication and 1 addition. All that for 3 edges.
        QCOMPARE(departure(counts, WorkStage::SetUp,
                           {{Division, 3 * (1 + 3)},
                            {FloatAddition, 3 * (2 + 3 + 1 + 4)},
                            {IntegerAddition, 3 * 3},
                            {Multiplication, 3 * 4},
                            {Conversion, 3 * (4 + 3 * 3 + 2 + 4)}}),
                 QString());
        // A column: ⌈y_B⌉ and ⌊y_T⌋; y_B = y_T?, then y_T − y_B and for each of R G B ΔR = (R_T −
        // R_B)/(y_T − y_B), which the two columns of one pixel do without, a 0 being converted; y
        // converted, y − y_B, and for each of R G B R_B + (y − y_B)·ΔR; 2 edges each add 1 slope
        // and 3 rates. Which edge is above takes one comparison, and two where they meet, in the
        // first and the last column.
        QCOMPARE(departure(counts, WorkStage::Span,
                           {{Division, 3 * 3},
                            {Rounding, 5 * 2},
                            {FloatAddition, 3 * (1 + 3) + 5 * (1 + 3) + 5 * 8},
                            {Multiplication, 5 * 3},
                            {Operation::Comparison, 5 + 5 + 2},
                            {Conversion, 2 + 5}}),
                 QString());
        // A pixel: R G B rounded, and ΔR ΔG ΔB added.
        QCOMPARE(departure(counts, WorkStage::Pixel, {{Rounding, 13 * 3}, {FloatAddition, 13 * 3}}),
                 QString());
    }

    void inFixedPointTheSameAdditionsAreOfIntegers()
    {
        const OperationCounts floating
            = countsOf("column-scan", Arithmetic::Float32, tentTriangle());
        const OperationCounts fixed = countsOf("column-scan", Arithmetic::Fixed16, tentTriangle());
        for (const WorkStage stage : allWorkStages) {
            QCOMPARE(fixed.of(stage, FloatAddition), std::int64_t(0));
            QCOMPARE(fixed.of(stage, IntegerAddition),
                     floating.of(stage, FloatAddition) + floating.of(stage, IntegerAddition));
            QCOMPARE(fixed.of(stage, Division), floating.of(stage, Division));
        }
    }

    void anExactColumnScanIsCountedAsByHand()
    {
        const OperationCounts counts = countsOf("column-scan", Arithmetic::Exact, tentTriangle());
        // n/d as quotient and remainder is 1 division, 1 comparison and 1 subtraction that make it
        // a floor, 1 multiplication and 1 subtraction for the remainder. It is wanted for each
        // edge's slope and y.
        // The plane: 4 differences, x1·y2 − x2·y1, its sign; a channel: 2 differences of levels,
        // twice s·(c·y − c′·y′), area ≠ 0?, and ΔR, a quotient of a numerator with 1
        // multiplication.
        // Slope: 2 differences, ΔX = 0?, 2 multiplications. y: 3 differences and 1 sum, ΔX = 0?, 4
        // multiplications. Columns start on the plane: no edge's colour is walked.
        QCOMPARE(departure(counts, WorkStage::SetUp,
                           {{Division, 3 + 3 * 2},
                            {IntegerAddition, 4 + 1 + 3 * (4 + 2) + 3 * (2 * 2 + 2 + 4)},
                            {Multiplication, 3 + 3 * (6 + 1 + 1) + 3 * (2 * 1 + 2 + 4)},
                            {Operation::Comparison, 1 + 3 * (1 + 1) + 3 * (2 * 1 + 2)}}),
                 QString());
        // ⌈y_B⌉: remainder ≠ 0?, 1 addition. Twice area ≠ 0?; the ways to the column and to the row
        // are 1 multiplication and 1 subtraction each; each channel's R is a quotient of a
        // numerator with 3 multiplications and 2 additions. 2 numbers advance: 2 additions, 1
        // comparison for the carry.
        QCOMPARE(departure(counts, WorkStage::Span,
                           {{Division, 5 * 3},
                            {IntegerAddition, 5 * (1 + 2 + 3 * (2 + 2) + 2 * 2)},
                            {Multiplication, 5 * (2 + 3 * (1 + 3))},
                            {Operation::Comparison, 5 * (1 + 2 + 3 * 1 + 2)}}),
                 QString());
        // Each channel: 2 remainders more than the denominator?, 2 additions; then it advances.
        QCOMPARE(departure(counts, WorkStage::Pixel,
                           {{IntegerAddition, 13 * 3 * (2 + 2)},
                            {Operation::Comparison, 13 * 3 * (1 + 1)}}),
                 QString());
    }

    void edgeEquationsAreCountedAsByHand()
    {
        const OperationCounts counts
            = countsOf("edge-equations", Arithmetic::Float32, tentTriangle());
        QCOMPARE(counts.spans, std::int64_t(5));
        QCOMPARE(counts.pixels, std::int64_t(13));
        QCOMPARE(counts.refused, std::int64_t(25 - 13)); // the bounding box has 5 × 5 samples
        QCOMPARE(counts.total(WorkStage::Span), std::int64_t(0));
        // A sample: a·x + b·y + c for 3 edges. E ≥ 0 is asked of one edge after the other until one
        // refuses: of the lower one 5 times a row, of the right one too, of the left one 5, 4, 4,
        // 3 and 3 times in rows 0 … 4.
        // A pixel: 3 weights E/E(opposite), 3 times α·R0 + β·R1 + γ·R2 with levels that the set-up
        // made floats, and 3 roundings.
        QCOMPARE(departure(counts, WorkStage::Pixel,
                           {{Division, 13 * 3},
                            {Rounding, 13 * 3},
                            {FloatAddition, 25 * 3 * 2 + 13 * 3 * 2},
                            {Multiplication, 25 * 3 * 2 + 13 * 3 * 3},
                            {Operation::Comparison, 25 + 25 + (5 + 4 + 4 + 3 + 3)},
                            {Conversion, 25 * 3 * 2}}),
                 QString());
    }

    void incrementalBarycentricCoordinatesAddSixNumbersASample()
    {
        const OperationCounts counts
            = countsOf("barycentric-incremental", Arithmetic::Float32, tentTriangle());
        // α β γ R G B each add their change, from sample to sample and from column to column.
        QCOMPARE(departure(counts, WorkStage::Span, {{FloatAddition, 5 * 6}}), QString());
        // The signs of α, then β, then γ, until one refuses.
        QCOMPARE(departure(counts, WorkStage::Pixel,
                           {{Rounding, 13 * 3},
                            {FloatAddition, 25 * 6},
                            {Operation::Comparison, 25 + (5 + 4 + 4 + 3 + 3) + 13}}),
                 QString());
    }

    void aPlaneEquationIsCountedAsByHandForTheColoursAlone()
    {
        const OperationCounts counts
            = countsOf("interpolate-plane", Arithmetic::Float32, tentTriangle());
        QCOMPARE(counts.spans, std::int64_t(5));
        QCOMPARE(counts.pixels, std::int64_t(13));
        // A channel's plane: 3 points of 3 coordinates each become floats; the cross product has 3
        // times 2 products and 5 differences; D has 3 products and 2 sums; 3 quotients.
        // What is covered is walked in integers along 3 edges. y: 3 differences and a sum, ΔX = 0?,
        // 4 products; slope: 2 differences, ΔX = 0?, 2 products; each then a quotient and remainder
        // of 1 division, 1 comparison, 2 subtractions and 1 product.
        QCOMPARE(departure(counts, WorkStage::SetUp,
                           {{Division, 3 * 3 + 3 * 2},
                            {FloatAddition, 3 * (3 * 5 + 2)},
                            {IntegerAddition, 3 * (4 + 2 + 2 * 2)},
                            {Multiplication, 3 * (3 * 2 + 3) + 3 * (4 + 2 + 2 * 1)},
                            {Operation::Comparison, 3 * (2 + 2 * 1)},
                            {Conversion, 3 * 3 * 3}}),
                 QString());
        // ⌈y_B⌉: remainder ≠ 0?, 1 addition. 2 edges advance: 2 additions, 1 comparison.
        QCOMPARE(
            departure(counts, WorkStage::Span,
                      {{IntegerAddition, 5 * (1 + 2 * 2)}, {Operation::Comparison, 5 * (1 + 2)}}),
            QString());
        // Each of R G B: a·x + b·y + c with x and y converted, and a rounding.
        QCOMPARE(departure(counts, WorkStage::Pixel,
                           {{Rounding, 13 * 3},
                            {FloatAddition, 13 * 3 * 2},
                            {Multiplication, 13 * 3 * 2},
                            {Conversion, 13 * 3 * 2}}),
                 QString());
    }

    void theOtherFormsOfInterpolationCostASampleWhatTheySay()
    {
        // R G B rounded, and their rates added.
        QCOMPARE(departure(countsOf("interpolate-bilinear", Arithmetic::Float32, tentTriangle()),
                           WorkStage::Pixel, {{Rounding, 13 * 3}, {FloatAddition, 13 * 3}}),
                 QString());
        // Three weights a·x + b·y + c; each of R G B is α·v0 + β·v1 + γ·v2 and rounded.
        QCOMPARE(departure(countsOf("interpolate-barycentric", Arithmetic::Float32, tentTriangle()),
                           WorkStage::Pixel,
                           {{Rounding, 13 * 3},
                            {FloatAddition, 13 * (3 * 2 + 3 * 2)},
                            {Multiplication, 13 * (3 * 2 + 3 * 3)},
                            {Conversion, 13 * 3 * 2}}),
                 QString());
    }

    void theRectangleSavesSamplesAndIncrementsSaveTheirOperations()
    {
        for (const Arithmetic arithmetic :
             {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64}) {
            const OperationCounts all = countsOf("barycentric-all", arithmetic, tentTriangle());
            const OperationCounts rectangle
                = countsOf("barycentric-rectangle", arithmetic, tentTriangle());
            const OperationCounts increments
                = countsOf("barycentric-incremental", arithmetic, tentTriangle());
            QCOMPARE(all.timesOf(WorkStage::Pixel), std::int64_t(side * side));
            QCOMPARE(rectangle.timesOf(WorkStage::Pixel), std::int64_t(5 * 5));
            QCOMPARE(increments.timesOf(WorkStage::Pixel), std::int64_t(5 * 5));
            QVERIFY(all.total(WorkStage::Pixel) > rectangle.total(WorkStage::Pixel));
            QVERIFY(rectangle.total(WorkStage::Pixel) > increments.total(WorkStage::Pixel));
            QVERIFY(increments.total(WorkStage::SetUp) > rectangle.total(WorkStage::SetUp));
        }
    }

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

    void theSetUpWeighsInASmallTriangle()
    {
        const Method &method = *methodNamed(u"column-scan");
        const std::vector<StandardExample> examples = standardExamplesFor(method);
        QCOMPARE(examples.size(), std::size_t(2));
        for (const Arithmetic arithmetic : method.arithmetics) {
            const auto large = countOperations(method, arithmetic, examples[0]);
            const auto small = countOperations(method, arithmetic, examples[1]);
            QVERIFY(large->setUpShare() < 0.1);
            QVERIFY(small->setUpShare() > 0.2);
        }
    }

    void everyMethodButTheCurvesIsCountedOnItsExample()
    {
        for (const Method &method : methods()) {
            if (method.id == QStringLiteral("bezier-subdivision")) {
                QVERIFY(!isCounted(method));
                QVERIFY(!countingGap(method, Arithmetic::Exact).isEmpty());
                continue;
            }
            QVERIFY2(isCounted(method), qPrintable(method.id));
            for (const StandardExample &example : standardExamplesFor(method)) {
                for (const Arithmetic arithmetic : method.arithmetics) {
                    const auto counts = countOperations(method, arithmetic, example);
                    QVERIFY2(counts && counts->pixels > 0 && counts->total() > 0,
                             qPrintable(method.id));
                }
            }
        }
    }

    void aCountedRunDrawsThePicture_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods()) {
            if (isCounted(method))
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void aCountedRunDrawsThePicture()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        for (const auto &[name, scene] : scenesForEveryMethod()) {
            for (const Arithmetic arithmetic : method.arithmetics) {
                for (const FillRule rule : method.fillRules) {
                    const ScanSettings settings = {arithmetic, rule, scene.settings.rounding};
                    const Primitives primitives = primitivesOnSamples(scene);
                    const FrameBuffer drawn(scene.frame);
                    const FrameBuffer counted(scene.frame);
                    method.draw(primitives, settings, drawn.view());
                    const auto counts
                        = countOperations(method, settings, primitives, counted.view());
                    QVERIFY2(drawn.image() == counted.image(),
                             qPrintable(QStringLiteral("%1 in %2, %3")
                                            .arg(name, nameText(nameOf(arithmetic)),
                                                 nameText(nameOf(rule)))));
                    const OperationRow totals = counts->totals();
                    QCOMPARE(counts->total(),
                             counts->total(WorkStage::SetUp) + counts->total(WorkStage::Span)
                                 + counts->total(WorkStage::Pixel));
                    QCOMPARE(std::accumulate(totals.begin(), totals.end(), std::int64_t(0)),
                             counts->total());
                }
            }
        }
    }

    void theListenerEndsACount()
    {
        const FrameBuffer frame(square(side));
        int asked = 0;
        const auto counts
            = countOperations(*methodNamed(u"column-scan"), {}, tentTriangle(), frame.view(),
                              [&](const JobProgress &) { return ++asked > 1; });
        QVERIFY(!counts);
        QCOMPARE(asked, 1);
    }

    void theTableLeavesOutWhatNeverOccursAndEndsWithTheSum()
    {
        OperationCounts counts;
        counts.primitives = 2;
        counts.spans = 4;
        counts.pixels = 3;
        counts.refused = 1;
        counts.stages[0][std::size_t(Division)] = 6;
        counts.stages[1][std::size_t(FloatAddition)] = 5;
        counts.stages[2][std::size_t(FloatAddition)] = 8;
        QCOMPARE(
            operationTableText(counts),
            (QStringList{"                       a set-up      a span    a sample         all",
                         "divisions                     3           0           0           6",
                         "float additions               0        1.25           2          13",
                         "all                           3        1.25           2          19"}));
        QCOMPARE(countsText(counts),
                 QStringLiteral("2 set-ups, 4 spans, 3 pixels, 1 sample refused, 19 operations"));
    }
};

QTEST_GUILESS_MAIN(TestOperationCounts)
#include "tst_operationcounts.moc"
