// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "core/oracle/oracle.h"
#include "core/scene/coordinatetext.h"
#include "core/scene/fileaccess.h"

#include <QtTest>

using namespace pixelplumb;

namespace {

QByteArray caseFile(const QByteArray &members)
{
    return "{\"version\": 1, \"cases\": [{" + members + "}]}";
}

const QByteArray smallTriangle = "\"id\": \"small\", \"kind\": \"triangle\", \"scale\": 1, "
                                 "\"vertices\": [[0, 0], [4, 0], [0, 4]], "
                                 "\"colours\": [[255, 0, 0], [0, 255, 0], [0, 0, 255]], "
                                 "\"canvas\": [6, 6], \"origin\": [0, 0], "
                                 "\"expected\": {\"closed\": {\"count\": 15}}";

QString reasonFor(const QByteArray &text)
{
    const Result<std::vector<HardCase>> cases = readHardCases(text);
    return cases ? QStringLiteral("no error") : cases.error().message();
}

} // namespace

Q_DECLARE_METATYPE(const HardCase *)

class tst_HardCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const QString path = QFINDTESTDATA("data/hard_cases.json");
        const Result<QByteArray> text = readFile(path);
        QVERIFY2(text.isOk(), text ? "" : qPrintable(text.error().message()));
        const Result<std::vector<HardCase>> cases = readHardCases(*text);
        QVERIFY2(cases.isOk(), cases ? "" : qPrintable(cases.error().message()));
        m_cases = *cases;
        QCOMPARE(m_cases.size(), std::size_t(82));
    }

    void columnScanIsRightInExactArithmetic_data() { addCases(); }
    void columnScanIsRightInExactArithmetic()
    {
        QFETCH(const HardCase *, hardCase);
        const Method *method = methodNamed(u"column-scan");

        const CaseReport report = checkCase(
            *hardCase,
            {{method, {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}},
             {method, {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest}}});

        QStringList remarks = report.remarks;
        for (const CandidateVerdict &verdict : report.verdicts)
            remarks += verdict.remarks;
        const CaseOutcome expected
            = hardCase->kind == HardCaseKind::Line ? CaseOutcome::Skipped : CaseOutcome::Passed;
        QVERIFY2(report.summary() == expected, qPrintable(remarks.join(u'\n')));
        QCOMPARE(report.count(CaseOutcome::Passed), std::int64_t(report.verdicts.size()));
    }

    void theOracleIsRightUnderEveryRule_data() { addCases(); }
    void theOracleIsRightUnderEveryRule()
    {
        QFETCH(const HardCase *, hardCase);
        for (const auto &[rule, facts] : hardCase->facts) {
            const QStringList shortfalls = shortfallsOf(
                *hardCase, {Arithmetic::Exact, rule, ByteRounding::Nearest}, drawTruly);
            QVERIFY2(shortfalls.isEmpty(), qPrintable(shortfalls.join(u'\n')));
        }
    }

    void theOraclesColoursAreTheExactOnes_data() { addCases(); }
    void theOraclesColoursAreTheExactOnes()
    {
        QFETCH(const HardCase *, hardCase);
        if (!hardCase->displacements.isEmpty())
            QSKIP("the facts hold for vertices off the lattice");
        for (const ExpectedPoint &point : hardCase->points) {
            const auto colour = oracle::colourAt(hardCase->triangles.front(), point.x, point.y);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const QStringList parts = point.exactColour[channel].split(u'/');
                const Quantity expected = Quantity::rational(
                    parts.front().toLongLong(), parts.value(1, QStringLiteral("1")).toLongLong());
                QCOMPARE(toText(colour[channel]), toText(expected));
            }
        }
    }

    // The checks can fail: numbers that round fall short where the catalogue says so.
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
                                << "2 pixels missing, 3 pixels extra";
        QTest::newRow("overshoot")
            << "overshoot_sliver" << Arithmetic::Float32 << closed << "85 pixels missing";
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
            = shortfallsOf(caseNamed(id), {arithmetic, rule, ByteRounding::Nearest},
                           methodNamed(u"column-scan")->draw);

        QVERIFY2(shortfalls.join(u'\n').contains(remark), qPrintable(shortfalls.join(u'\n')));
    }

    // Faults planted in a drawing that is right otherwise.
    void aDrawingThatLosesOnePixelFallsShort()
    {
        const Drawing lossy
            = [](const Primitives &primitives, const ScanSettings &settings, FrameView frame) {
                  drawTruly(primitives, settings, frame);
                  *frame.at(5, 7) = 0;
              };

        const QStringList shortfalls
            = shortfallsOf(caseNamed(QStringLiteral("vertical_left")),
                           {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}, lossy);

        QCOMPARE(shortfalls.value(0), QStringLiteral("1 pixel missing"));
        QCOMPARE(shortfalls.value(1), QStringLiteral("pixel count 76 instead of 77"));
    }

    void aDrawingThatTruncatesFallsShortInColour()
    {
        const Drawing truncating
            = [](const Primitives &primitives, ScanSettings settings, FrameView frame) {
                  settings.rounding = ByteRounding::Truncate;
                  drawTruly(primitives, settings, frame);
              };

        const QStringList shortfalls = shortfallsOf(
            caseNamed(QStringLiteral("frame_exact_fit")),
            {Arithmetic::Exact, FillRule::TopLeft, ByteRounding::Nearest}, truncating);

        QVERIFY(shortfalls.value(0).endsWith(QStringLiteral("in another colour")));
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
            = shortfallsOf(caseNamed(QStringLiteral("translation_invariance")),
                           {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}, local);

        QCOMPARE(shortfalls, QStringList{QStringLiteral("distinct pictures 2 instead of 1")});
    }

    void aDrawingThatOverdrawsASharedEdgeFallsShort()
    {
        const Drawing closed
            = [](const Primitives &primitives, ScanSettings settings, FrameView frame) {
                  settings.fillRule = FillRule::Closed;
                  drawTruly(primitives, settings, frame);
              };

        const QStringList shortfalls = shortfallsOf(
            caseNamed(QStringLiteral("vertical_both_ends_quad")),
            {Arithmetic::Exact, FillRule::HalfOpenColumn, ByteRounding::Nearest}, closed);

        QCOMPARE(shortfalls,
                 QStringList{QStringLiteral("coverage (times×pixels) 1×416 2×9 instead of 1×384")});
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
            caseNamed(QStringLiteral("moving_sliver")),
            {Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest}, flickering);

        QCOMPARE(shortfalls.size(), qsizetype(2));
        QCOMPARE(shortfalls.back(), QStringLiteral("toggles 760 instead of 729")); // 31 more
    }

    void snapsACaseThatLiesOffTheLatticeAndReportsIt()
    {
        const HardCase &hardCase = caseNamed(QStringLiteral("denormal_offset"));

        QCOMPARE(hardCase.displacements.size(), qsizetype(4));
        QCOMPARE(hardCase.displacements.front(),
                 QStringLiteral("vertices[0][0] by -7.174648137343064e-43 px"));
        QCOMPARE(hardCase.triangles.front().vertices[1].position, latticePixel(3, 0));
    }

    void refusesTheCoordinatesOfInvalidCases_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("refusal");
        QTest::newRow("NaN") << "nan_vertex"
                             << "“nan” is no coordinate";
        QTest::newRow("infinity") << "inf_vertex"
                                  << "“inf” is no coordinate";
        QTest::newRow("3e9") << "int_cast_out_of_range"
                             << "3e9 is outside ±1073741824 px";
    }
    void refusesTheCoordinatesOfInvalidCases()
    {
        QFETCH(QString, id);
        QFETCH(QString, refusal);

        QCOMPARE(caseNamed(id).refusal, refusal);
    }

    void anInvalidCaseThatIsAcceptedFallsShort()
    {
        const auto cases = readHardCases(caseFile(
            R"("id": "harmless", "kind": "invalid", "vertices_text": [["0", "0"], ["1", "0"], ["0", "1"]])"));

        QVERIFY(cases.isOk());
        QCOMPARE(checkCase(cases->front(), {}).summary(), CaseOutcome::FellShort);
    }

    void namesTheFaultOfACaseFile_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        QTest::newRow("good") << caseFile(smallTriangle) << "no error";
        QTest::newRow("empty") << QByteArray() << "the input is empty; expected JSON";
        QTest::newRow("a scene")
            << QByteArray("{\"pixelplumb\": 1}")
            << "line 1, column 1, version: nothing; expected an integer from 1 to 1";
        QTest::newRow("newer") << QByteArray("{\"version\": 2, \"cases\": []}")
                               << "line 1, column 13, version: 2; expected an integer from 1 to 1";
        QTest::newRow("no cases") << QByteArray("{\"version\": 1}")
                                  << "line 1, column 1, cases: nothing; expected an array";
        QTest::newRow("unknown kind") << caseFile("\"id\": \"a\", \"kind\": \"spiral\"")
                                      << "line 1, column 46, cases[0].kind: “spiral”; expected one "
                                         "of triangle, mesh, sequence, "
                                         "translation, invalid, line, circle, polygon, attributes";
        QTest::newRow("canvas 0")
            << QByteArray(caseFile(smallTriangle)).replace("[6, 6]", "[0, 6]")
            << "line 1, column 175, cases[0].canvas[0]: 0; expected an integer from 1 to 32768";
        QTest::newRow("vertex too far")
            << QByteArray(caseFile(smallTriangle)).replace("[4, 0]", "[4000000000, 0]")
            << "line 1, column 96, cases[0].vertices[1][0]: 4000000000; expected an integer in "
               "units of "
               "1/scale px, within ±1073741824 px";
        QTest::newRow("scale 0")
            << QByteArray(caseFile(smallTriangle)).replace("\"scale\": 1", "\"scale\": 0")
            << "line 1, column 71, cases[0].scale: 0; expected the units in a pixel, 1 or more";
    }
    void namesTheFaultOfACaseFile()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);

        QCOMPARE(reasonFor(text), message);
    }

    void refusesEveryCaseFileThatIsCutShort()
    {
        const QByteArray text = caseFile(smallTriangle);
        for (qsizetype length = 0; length < text.size(); ++length)
            QVERIFY2(!readHardCases(text.first(length)).isOk(),
                     qPrintable(QString::number(length)));
    }

private:
    void addCases() const
    {
        QTest::addColumn<const HardCase *>("hardCase");
        for (const HardCase &hardCase : m_cases)
            QTest::newRow(qPrintable(hardCase.id)) << &hardCase;
    }
    const HardCase &caseNamed(const QString &id) const
    {
        return *std::ranges::find(m_cases, id, &HardCase::id);
    }

    std::vector<HardCase> m_cases;
};

QTEST_GUILESS_MAIN(tst_HardCases)
#include "tst_hardcases.moc"
