// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "tests/support/caselist.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_casefile {

using namespace pixelplumb;

namespace {

const QByteArray smallTriangle = "\"id\": \"small\", \"kind\": \"triangle\", \"scale\": 1, "
                                 "\"vertices\": [[0, 0], [4, 0], [0, 4]], "
                                 "\"colours\": [[255, 0, 0], [0, 255, 0], [0, 0, 255]], "
                                 "\"canvas\": [6, 6], \"origin\": [0, 0], "
                                 "\"expected\": {\"closed\": {\"count\": 15}}";

QString reasonFor(const QByteArray &text)
{
    const Result<std::vector<HardCase>> cases = readHardCases(text);
    return cases ? u"no error"_s : cases.error().message();
}

} // namespace

/// How a file of hard cases is read, snapped and rejected.
class TestCaseFile : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_cases = casesOf(testData("hard_cases.json")); }

    void snapsACaseThatLiesOffTheLatticeAndReportsIt()
    {
        const HardCase &hardCase = caseNamed(m_cases, u"denormal_offset"_s);

        QCOMPARE(hardCase.displacements.size(), qsizetype(4));
        QCOMPARE(hardCase.displacements.front(), u"vertices[0][0] by -7.174648137343064e-43 px"_s);
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

        QCOMPARE(caseNamed(m_cases, id).refusal, refusal);
    }

    void anInvalidCaseThatIsAcceptedFallsShort()
    {
        const auto cases = readHardCases(fileOfCase(
            R"("id": "harmless", "kind": "invalid", "vertices_text": [["0", "0"], ["1", "0"], ["0", "1"]])"));

        QVERIFY(cases.isOk());
        QCOMPARE(checkCase(cases->front(), {}).summary(), CaseOutcome::FellShort);
    }

    void namesTheFaultOfACaseFile_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        QTest::newRow("good") << fileOfCase(smallTriangle) << "no error";
        QTest::newRow("empty") << QByteArray() << "the input is empty; expected JSON";
        QTest::newRow("a scene") << QByteArray("{\"pixelplumb\": 1}")
                                 << "line 1, column 1, version: nothing; expected the integer 1";
        QTest::newRow("newer") << QByteArray("{\"version\": 2, \"cases\": []}")
                               << "line 1, column 13, version: 2; expected the integer 1";
        QTest::newRow("no cases") << QByteArray("{\"version\": 1}")
                                  << "line 1, column 1, cases: nothing; expected an array";
        QTest::newRow("unknown kind") << fileOfCase("\"id\": \"a\", \"kind\": \"spiral\"")
                                      << "line 1, column 46, cases[0].kind: “spiral”; expected one "
                                         "of triangle, mesh, sequence, "
                                         "translation, invalid, line, circle, polygon, attributes, "
                                         "effects";
        QTest::newRow("canvas 0")
            << QByteArray(fileOfCase(smallTriangle)).replace("[6, 6]", "[0, 6]")
            << "line 1, column 175, cases[0].canvas[0]: 0; expected an integer from 1 to 32768";
        QTest::newRow("vertex too far")
            << QByteArray(fileOfCase(smallTriangle)).replace("[4, 0]", "[4000000000, 0]")
            << "line 1, column 96, cases[0].vertices[1][0]: 4000000000; expected an integer in "
               "units of "
               "1/scale px, within ±1073741824 px";
        QTest::newRow("scale 0")
            << QByteArray(fileOfCase(smallTriangle)).replace("\"scale\": 1", "\"scale\": 0")
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
        const QByteArray text = fileOfCase(smallTriangle);
        for (qsizetype length = 0; length < text.size(); ++length)
            QVERIFY2(!readHardCases(text.first(length)).isOk(),
                     qPrintable(QString::number(length)));
    }

private:
    std::vector<HardCase> m_cases;
};

PIXELPLUMB_TEST(TestCaseFile)

} // namespace tst_casefile

#include "tst_casefile.moc"
