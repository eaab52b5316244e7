// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/countedbyhand.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_operationcounts {

using namespace pixelplumb;
using enum pixelplumb::Operation;

/// Triangle operations counted by kernels in counting numbers, against counts by hand.
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
        // R_B)/(y_T − y_B), which the two columns of one pixel skip, converting a 0; y converted, y
        // − y_B, and for each of R G B R_B + (y − y_B)·ΔR; 2 edges each add 1 slope and 3 rates.
        // Deciding which edge is above takes one comparison, and two where they meet, in the first
        // and the last column.
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

    void cramersRuleDividesForUAndVAlone()
    {
        const OperationCounts counts
            = countsOf("barycentric-cramer", Arithmetic::Float32, tentTriangle());
        const std::int64_t samples = counts.pixels + counts.refused;
        QVERIFY(samples > 13);
        QCOMPARE(counts.of(WorkStage::Pixel, Division), 2 * samples);
        // Each of R, G and B is a·(x − x_C) + b·(y − y_C); R, G and B only for written pixels.
        QCOMPARE(counts.of(WorkStage::Pixel, Multiplication), 4 * samples + 9 * counts.pixels);
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
        // n/d as quotient and remainder: 1 division, 1 comparison and 1 subtraction for the floor,
        // 1 multiplication and 1 subtraction for the remainder. Each edge's slope and y need it.
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
        // ⌈y_B⌉: remainder ≠ 0?, 1 addition. Twice area ≠ 0?; the distances to the column and to
        // the row are 1 multiplication and 1 subtraction each; each channel's R is a quotient of a
        // numerator with 3 multiplications and 2 additions. 2 numbers advance: 2 additions, 1
        // comparison for the carry.
        QCOMPARE(departure(counts, WorkStage::Span,
                           {{Division, 5 * 3},
                            {IntegerAddition, 5 * (1 + 2 + 3 * (2 + 2) + 2 * 2)},
                            {Multiplication, 5 * (2 + 3 * (1 + 3))},
                            {Operation::Comparison, 5 * (1 + 2 + 3 * 1 + 2)}}),
                 QString());
        // Each channel: 2 comparisons of a remainder with the denominator, 2 additions; then it
        // advances.
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
        // A sample: a·x + b·y + c for 3 edges. E ≥ 0 is tested for one edge after the other until
        // one fails: 5 times a row for the lower edge, 5 for the right one, and 5, 4, 4, 3 and 3
        // times in rows 0 … 4 for the left one.
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
        // The signs of α, then β, then γ, until one fails.
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
        // The coverage is walked in integers along 3 edges. y: 3 differences and a sum, ΔX = 0?, 4
        // products; slope: 2 differences, ΔX = 0?, 2 products; each then a quotient and remainder
        // with 1 division, 1 comparison, 2 subtractions and 1 product.
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
        // Three weights a·x + b·y + c; each of R G B is α·v0 + β·v1 + γ·v2, then rounded.
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
};

PIXELPLUMB_TEST(TestOperationCounts)

} // namespace tst_operationcounts

#include "tst_operationcounts.moc"
