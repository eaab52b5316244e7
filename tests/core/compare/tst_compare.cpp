// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/contest.h"
#include "core/compare/exactbounds.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_compare {

using namespace pixelplumb;

namespace {

Scene sceneWith(const std::array<LatticePoint, 3> &corners, const FrameSpec &frame)
{
    Scene scene;
    scene.frame = frame;
    scene.triangles.resize(1);
    for (std::size_t i = 0; i < 3; ++i)
        scene.triangles.front().vertices[i].position = corners[i];
    scene.triangles.front().vertices[0].colour = {{255, 0, 0}};
    scene.triangles.front().vertices[1].colour = {{0, 255, 0}};
    scene.triangles.front().vertices[2].colour = {{0, 0, 255}};
    return scene;
}

/// Slopes 1/10 and 7/10, and samples on both edges in every tenth column.
Scene tenths()
{
    FrameSpec frame;
    frame.width = 1001;
    frame.height = 701;
    return sceneWith({latticePixel(0, 0), latticePixel(1000, 100), latticePixel(1000, 700)}, frame);
}

Contender columnScan(Arithmetic arithmetic, FillRule rule = FillRule::Closed)
{
    return {methodNamed(u"column-scan"), {arithmetic, rule, ByteRounding::Nearest}};
}

Contender truth(FillRule rule = FillRule::Closed)
{
    return {nullptr, {Arithmetic::Exact, rule, ByteRounding::Nearest}};
}

/// The size of the pixel's largest group of agreeing contenders, counted without the map.
int largestGroup(const Contest &contest, std::int64_t x, std::int64_t y)
{
    std::map<QRgb, int> groups;
    int largest = 0;
    for (const ContenderRun &run : contest.runs)
        largest = std::max(largest, ++groups[*run.picture.view().at(x, y)]);
    return largest;
}

} // namespace

class TestCompare : public QObject {
    Q_OBJECT

private slots:
    void agreesWhereAllAreTheTruth()
    {
        const auto contest = compareContenders(
            tenths(), {columnScan(Arithmetic::Exact), truth(), columnScan(Arithmetic::Exact)});

        QCOMPARE(contest->agreement.differing(), 0);
        QCOMPARE(contest->agreement.countAgreeing(3), std::int64_t(1001 * 701));
        QCOMPARE(contest->agreement.count(Disagreement::None), std::int64_t(1001 * 701));
        for (const ContenderRun &run : contest->runs)
            QVERIFY(!run.traced); // nothing to explain, nothing recorded
    }

    void recordsEveryMethodWhenAsked()
    {
        ContestOptions options;
        options.recorded = Recorded::All;

        const auto contest
            = compareContenders(tenths(), {columnScan(Arithmetic::Exact), truth()}, options);

        QVERIFY(contest->runs[0].traced);
        QVERIFY(!contest->runs[1].traced);
    }

    void countsTheLargestGroupOfEveryPixel()
    {
        const auto contest
            = compareContenders(tenths(),
                                {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Float32),
                                 columnScan(Arithmetic::Float64), truth(FillRule::TopLeft)});

        std::array<std::int64_t, 5> counts = {};
        int wrong = 0;
        for (std::int64_t y = 0; y < 701; ++y) {
            for (std::int64_t x = 0; x < 1001; ++x) {
                const int expected = largestGroup(*contest, x, y);
                ++counts[std::size_t(expected)];
                wrong += contest->agreement.agreeingAt(x, y) != expected;
            }
        }
        QCOMPARE(wrong, 0);
        std::int64_t reasons = 0;
        for (const Disagreement reason : allDisagreements)
            reasons += contest->agreement.count(reason);
        QCOMPARE(reasons, contest->agreement.differing());
        for (int agreeing = 1; agreeing <= 4; ++agreeing)
            QCOMPARE(contest->agreement.countAgreeing(agreeing), counts[std::size_t(agreeing)]);
    }

    void losesMorePixelsAtTenthsInFloat64ThanInFloat32()
    {
        const auto contest = compareContenders(
            tenths(), {truth(), columnScan(Arithmetic::Float32), columnScan(Arithmetic::Float64)});

        const auto missing = [&](std::size_t run) {
            return contest->runs[run].tally.againstTruth.count(Difference::Missing);
        };
        QCOMPARE(missing(1), 64);
        QCOMPARE(missing(2), 127);
    }

    void namesDriftWhereTheNumberTypeCouldHoldTheBound()
    {
        const auto contest = compareContenders(
            tenths(), {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Float32)});

        const PixelComparison pixel = comparePixel(*contest, 10, 1);

        QCOMPARE(pixel.agreeing, 1);
        QCOMPARE(pixel.reason, Disagreement::Drift);
        QVERIFY(pixel.opinions[0].written);
        QVERIFY(!pixel.opinions[1].written);
        const Deviation &deviation = pixel.opinions[1].deviation;
        QCOMPARE(deviation.kind, Difference::Missing);
        QCOMPARE(deviation.bound, DecidingBound::Lower);
        QCOMPARE(deviation.exact, Quantity::integer(1));
        QCOMPARE(deviation.used, Quantity::of(1.0000001f));
        QVERIFY(deviation.isTie);
        QCOMPARE(pixel.opinions[1].words,
                 u"missing: y_B = 1.0000001 instead of 1, 1.2e−07 px too high; "
                 "float32 can represent the exact bound, but the accumulated "
                 "increments missed it; the sample lies exactly on an edge"_s);
    }

    void namesTheTieRuleWhereOnlyTheRulesDiffer()
    {
        const auto contest = compareContenders(
            tenths(),
            {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Exact, FillRule::HalfOpenColumn),
             truth(FillRule::TopLeft)});

        QVERIFY(contest->agreement.differing() > 0);
        QCOMPARE(contest->agreement.count(Disagreement::TieRule), contest->agreement.differing());
        for (std::int64_t y = 0; y < 701; ++y) {
            for (std::int64_t x = 0; x < 1001; ++x) {
                if (contest->agreement.reasonAt(x, y) == Disagreement::TieRule)
                    QVERIFY(liesOnBoundary(contest->primitives.triangles.front(), x, y));
            }
        }
    }

    void namesRoundingWhereAByteIsOffByOne()
    {
        const auto contest = compareContenders(
            tenths(), {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Fixed32)});

        int checked = 0;
        for (std::int64_t y = 0; y < 701; ++y) {
            for (std::int64_t x = 0; x < 1001; ++x) {
                if (contest->agreement.reasonAt(x, y) != Disagreement::Rounding)
                    continue;
                const PixelComparison pixel = comparePixel(*contest, x, y);
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const int off = pixel.opinions[0].colour.channels[channel]
                        - pixel.opinions[1].colour.channels[channel];
                    QVERIFY(std::abs(off) <= 1);
                }
                QVERIFY(pixel.opinions[0].written && pixel.opinions[1].written);
                ++checked;
            }
        }
        QVERIFY(checked > 0);
    }

    void namesPrecisionWhereAVertexCannotBeHeld()
    {
        FrameSpec frame; // 2^24 + 1 is no float32
        frame.width = 16;
        frame.height = 12;
        frame.firstColumn = (1 << 24) - 4;
        const Lattice left = (1 << 24) - 3;
        const Scene scene = sceneWith(
            {latticePixel(left, 0), latticePixel((1 << 24) + 1, 9), latticePixel((1 << 24) + 9, 2)},
            frame);

        const auto contest = compareContenders(
            scene, {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Float32)});

        QVERIFY(contest->agreement.count(Disagreement::Precision) > 0);
        QCOMPARE(contest->agreement.count(Disagreement::Drift), 0);
        const auto fixed = compareContenders(
            scene, {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Fixed16)});
        QCOMPARE(fixed->agreement.count(Disagreement::Precision), fixed->agreement.differing());
        QVERIFY(fixed->agreement.differing() > 0);
    }

    void agreesWithTheTraceWhateverTheOrderOfTheContenders()
    {
        const std::vector<Contender> contenders
            = {columnScan(Arithmetic::Float32), truth(), columnScan(Arithmetic::Fixed16)};
        const auto contest = compareContenders(tenths(), contenders);
        const auto reversed = compareContenders(tenths(), {contenders.rbegin(), contenders.rend()});

        for (std::int64_t y = 0; y < 701; ++y) {
            for (std::int64_t x = 0; x < 1001; ++x) {
                if (contest->agreement.reasonAt(x, y) != reversed->agreement.reasonAt(x, y)
                    || contest->agreement.agreeingAt(x, y) != reversed->agreement.agreeingAt(x, y))
                    QFAIL(qPrintable(u"pixel (%1, %2)"_s.arg(x).arg(y)));
            }
        }
        QCOMPARE(contest->runs[0].tally.differsFrom[2], reversed->runs[2].tally.differsFrom[0]);
    }

    void stopsWhenProgressSaysSo()
    {
        ContestOptions options;
        int calls = 0;
        options.progress = [&calls](const JobProgress &) { return ++calls < 3; };

        QVERIFY(!compareContenders(
            tenths(), {columnScan(Arithmetic::Exact), columnScan(Arithmetic::Float32)}, options));
        QCOMPARE(calls, 3);
    }

    void knowsTheBoundsOfRowsAsThoseOfColumns()
    {
        const Triangle triangle = tenths().triangles.front();

        const auto column = exactBoundsOn(triangle, {SpanAxis::Column, 5, 0});
        const auto row = exactBoundsOn(triangle, {SpanAxis::Row, 50, 0});

        QCOMPARE(column->lower, Quantity::rational(1, 2));
        QCOMPARE(column->upper, Quantity::rational(7, 2));
        QCOMPARE(row->lower, Quantity::rational(500, 7)); // 50 / (7/10)
        QCOMPARE(row->upper, Quantity::integer(500));
        QVERIFY(!exactBoundsOn(triangle, {SpanAxis::Row, 701, 0}));
        QVERIFY(!exactBoundsOn(triangle, {SpanAxis::Free, 0, 0}));
    }

    void readsIncrementsFromFormulas_data()
    {
        QTest::addColumn<QString>("formula");
        QTest::addColumn<bool>("incremental");
        QTest::newRow("none") << QString() << false;
        QTest::newRow("step") << u"y_B ← y_B′ + m"_s << true;
        QTest::newRow("decision") << u"p ← p′ + 2Δy"_s << true;
        QTest::newRow("direct") << u"y = m·x + b"_s << false;
        QTest::newRow("set once") << u"E ← a·x + b·y + c"_s << false;
    }
    void readsIncrementsFromFormulas()
    {
        QFETCH(QString, formula);
        QFETCH(bool, incremental);
        NumberDescription number;
        number.formula = formula;

        QCOMPARE(isIncremental(number), incremental);
    }
};

PIXELPLUMB_TEST(TestCompare)

} // namespace tst_compare

#include "tst_compare.moc"
