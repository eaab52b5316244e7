// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "core/oracle/oracle.h"
#include "tests/support/caselist.h"
#include "tests/support/sanitized.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_hardcases {

using namespace pixelplumb;

/// The hard cases of triangles: which methods are right on all of them, and that the checks can
/// fail.
class TestHardCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_cases = casesOf(testData("hard_cases.json"));
        QCOMPARE(m_cases.size(), std::size_t(82));
        m_fewer = fewerIfSanitized(m_cases);
    }

    void columnScanIsRightInExactArithmetic_data() { addRows(m_fewer); }
    void columnScanIsRightInExactArithmetic()
    {
        QFETCH(const HardCase *, hardCase);
        const Method *method = methodNamed(u"column-scan");

        const CaseReport report = checkCase(
            *hardCase,
            {{method, {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}},
             {method, {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest}}});

        QStringList remarks = report.remarks;
        for (const ContenderVerdict &verdict : report.verdicts)
            remarks += verdict.remarks;
        const CaseOutcome expected
            = hardCase->kind == HardCaseKind::Line ? CaseOutcome::Skipped : CaseOutcome::Passed;
        QVERIFY2(report.summary() == expected, qPrintable(remarks.join(u'\n')));
        QCOMPARE(report.count(CaseOutcome::Passed), std::int64_t(report.verdicts.size()));
    }

    void theOracleIsRightUnderEveryRule_data() { addRows(m_fewer); }
    void theOracleIsRightUnderEveryRule()
    {
        QFETCH(const HardCase *, hardCase);
        for (const auto &[rule, facts] : hardCase->facts) {
            const QStringList shortfalls = shortfallsOf(
                *hardCase, {Arithmetic::Exact, rule, ByteRounding::Nearest}, drawTruly);
            QVERIFY2(shortfalls.isEmpty(), qPrintable(shortfalls.join(u'\n')));
        }
    }

    void theOraclesColoursAreTheExactOnes_data() { addRows(m_fewer); }
    void theOraclesColoursAreTheExactOnes()
    {
        QFETCH(const HardCase *, hardCase);
        if (!hardCase->displacements.isEmpty())
            QSKIP("the facts hold for vertices off the lattice");
        for (const ExpectedPoint &point : hardCase->points) {
            const auto colour = oracle::colourAt(hardCase->triangles.front(), point.x, point.y);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const QStringList parts = point.exactColour[channel].split(u'/');
                const Quantity expected = Quantity::rational(parts.front().toLongLong(),
                                                             parts.value(1, u"1"_s).toLongLong());
                QCOMPARE(toText(colour[channel]), toText(expected));
            }
        }
    }

    // The checks can fail: rounding arithmetics fall short where the catalogue says so.
    void roundingNumbersFallShort_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<QString>("remark");
        const FillRule closed = FillRule::Closed;
        QTest::newRow("tenths, float32")
            << "tie_tenths" << Arithmetic::Float32 << closed << "64 pixels missing";
        QTest::newRow("tenths, float64: more bits, more misses")
            << "tie_tenths" << Arithmetic::Float64 << closed << "127 pixels missing";
        QTest::newRow("stagnation")
            << "stagnation_20000" << Arithmetic::Float32 << closed << "114693 pixels extra";
        QTest::newRow("stagnation, half-open") << "stagnation_20000" << Arithmetic::Float32
                                               << FillRule::HalfOpenColumn << "98298 pixels extra";
        QTest::newRow("sliver") << "sliver_fibonacci" << Arithmetic::Float32 << closed
                                << "1 pixel missing, 5 pixels extra";
        QTest::newRow("overshoot")
            << "overshoot_sliver" << Arithmetic::Float32 << closed << "84 pixels missing";
        QTest::newRow("fixed point is no better")
            << "vertical_right_on_last_column" << Arithmetic::Fixed16 << closed << "pixels missing";
    }
    void roundingNumbersFallShort()
    {
        QFETCH(QString, id);
        QFETCH(Arithmetic, arithmetic);
        QFETCH(FillRule, rule);
        QFETCH(QString, remark);

        const QStringList shortfalls
            = shortfallsOf(caseNamed(m_cases, id), {arithmetic, rule, ByteRounding::Nearest},
                           drawingBy(*methodNamed(u"column-scan"), Kernels::Plain));

        QVERIFY2(shortfalls.join(u'\n').contains(remark), qPrintable(shortfalls.join(u'\n')));
    }

    // Faults planted in an otherwise right drawing.
    void aDrawingThatLosesOnePixelFallsShort()
    {
        const Drawing lossy
            = [](const Primitives &primitives, const ScanSettings &settings, FrameView frame) {
                  drawTruly(primitives, settings, frame);
                  *frame.at(5, 7) = 0;
              };

        const QStringList shortfalls
            = shortfallsOf(caseNamed(m_cases, u"vertical_left"_s),
                           {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}, lossy);

        QCOMPARE(shortfalls.value(0), u"1 pixel missing"_s);
        QCOMPARE(shortfalls.value(1), u"pixel count 76 instead of 77"_s);
    }

    void aDrawingThatTruncatesFallsShortInColour()
    {
        const Drawing truncating
            = [](const Primitives &primitives, ScanSettings settings, FrameView frame) {
                  settings.rounding = ByteRounding::Truncate;
                  drawTruly(primitives, settings, frame);
              };

        const QStringList shortfalls = shortfallsOf(
            caseNamed(m_cases, u"frame_exact_fit"_s),
            {Arithmetic::Exact, FillRule::TopLeft, ByteRounding::Nearest}, truncating);

        QVERIFY(shortfalls.value(0).endsWith(u"in another colour"_s));
    }

    void aDrawingThatChangesWhenMovedFallsShort()
    {
        const Drawing local
            = [](const Primitives &primitives, const ScanSettings &settings, FrameView frame) {
                  drawTruly(primitives, settings, frame);
                  if (frame.firstColumn == 5000)
                      *frame.at(5000 + 100, frame.firstRow + 60) = qRgb(1, 2, 3);
              };

        const QStringList shortfalls
            = shortfallsOf(caseNamed(m_cases, u"translation_invariance"_s),
                           {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}, local);

        QCOMPARE(shortfalls, QStringList{u"distinct pictures 2 instead of 1"_s});
    }

    void aDrawingThatOverdrawsASharedEdgeFallsShort()
    {
        const Drawing closed
            = [](const Primitives &primitives, ScanSettings settings, FrameView frame) {
                  settings.fillRule = FillRule::Closed;
                  drawTruly(primitives, settings, frame);
              };

        const QStringList shortfalls = shortfallsOf(
            caseNamed(m_cases, u"vertical_both_ends_quad"_s),
            {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest}, closed);

        QCOMPARE(shortfalls, QStringList{u"coverage (times×pixels) 1×416 2×9 instead of 1×384"_s});
    }

    // Facts about vertices off the lattice do not hold for the snapped vertices that are drawn.
    void whatIsOffTheLatticeIsComparedWithTheTruthAfterSnapping_data()
    {
        QTest::addColumn<QByteArray>("members");
        const QByteArray start
            = "\"id\": \"off\", \"stresses\": \"s\", \"scale\": 1000, \"canvas\": "
              "[20, 20], \"origin\": [0, 0], ";
        const QByteArray corners = "[1, 0], [9003, 1000], [3000, 9100]";
        QTest::newRow("mesh") << start + "\"kind\": \"mesh\", \"vertices\": [" + corners
                + "], \"triangles\": [[0, 1, 2]], \"expected\": { \"closed\": { \"histogram\": { "
                  "\"1\": 3 } } }";
        QTest::newRow("sequence") << start + "\"kind\": \"sequence\", \"frames\": [[" + corners
                + "], [" + corners
                + "]], \"expected\": { \"closed\": { \"counts\": [1, 2], \"toggles\": 3 } }";
        QTest::newRow("translation") << start + "\"kind\": \"translation\", \"vertices\": ["
                + corners
                + "], "
                  "\"offsets_px\": [[0, 0], [100, 50]], \"expected\": { \"closed\": { \"count\": "
                  "3, "
                  "\"distinct_pictures\": 1 } }";
    }
    void whatIsOffTheLatticeIsComparedWithTheTruthAfterSnapping()
    {
        QFETCH(QByteArray, members);
        const auto cases = readHardCases(fileOfCase(members));
        QVERIFY2(cases.isOk(), cases ? "" : qPrintable(cases.error().message()));
        const HardCase &hardCase = cases->front();
        QVERIFY(!hardCase.displacements.isEmpty());
        const ScanSettings settings;
        const Drawing lossy
            = [](const Primitives &primitives, const ScanSettings &under, FrameView frame) {
                  drawTruly(primitives, under, frame);
                  *frame.at(frame.firstColumn + 3, frame.firstRow + 3) = 0;
              };

        QCOMPARE(shortfallsOf(hardCase, settings, drawTruly), QStringList());
        QVERIFY(!shortfallsOf(hardCase, settings, lossy).isEmpty());
    }

    void aDrawingThatFlickersFallsShort()
    {
        const Drawing flickering = [](const Primitives &primitives, const ScanSettings &settings,
                                      FrameView frame) {
            drawTruly(primitives, settings, frame);
            const bool odd = primitives.triangles.front().vertices[1].position.y / 16 % 2 != 0;
            if (odd)
                *frame.at(250, 2) = qRgb(0, 0, 0);
        };

        const QStringList shortfalls = shortfallsOf(
            caseNamed(m_cases, u"moving_sliver"_s),
            {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}, flickering);

        QCOMPARE(shortfalls.size(), qsizetype(2));
        QCOMPARE(shortfalls.back(), u"toggles 760 instead of 729"_s); // 31 more
    }

private:
    std::vector<HardCase> m_cases;
    std::vector<HardCase> m_fewer; ///< under sanitizers
};

PIXELPLUMB_TEST(TestHardCases)

} // namespace tst_hardcases

#include "tst_hardcases.moc"
