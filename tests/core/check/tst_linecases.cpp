// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "tests/support/caselist.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_linecases {

using namespace pixelplumb;

/// The line cases among the hard cases.
class TestLineCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_cases = casesOf(testData("hard_cases.json"));
        std::erase_if(m_cases,
                      [](const HardCase &hardCase) { return hardCase.kind != HardCaseKind::Line; });
        QCOMPARE(m_cases.size(), std::size_t(8));
    }

    // What the literal forms get wrong in the hard cases, each for its own reason.
    void hardCasesAreFailedByTheFormsThatTheyStress_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::addColumn<QStringList>("failed");
        QTest::newRow("DDA, exact") << "line-dda" << Arithmetic::Exact << QStringList();
        QTest::newRow("DDA, float32 drifts")
            << "line-dda" << Arithmetic::Float32 << QStringList({u"line_long_16381"_s});
        QTest::newRow("Bresenham, from the left end")
            << "line-bresenham" << Arithmetic::Exact << QStringList();
        QTest::newRow("Bresenham, ties up")
            << "line-bresenham-symmetric" << Arithmetic::Exact << QStringList();
        QTest::newRow("y = mx + b: casts, gaps, no slope")
            << "line-slope-intercept" << Arithmetic::Exact
            << QStringList({u"line_negative"_s, u"line_steep"_s, u"line_vertical"_s,
                            u"line_point"_s, u"line_diagonal"_s});
    }
    void hardCasesAreFailedByTheFormsThatTheyStress()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        QFETCH(QStringList, failed);
        QStringList found;
        for (const HardCase &hardCase : m_cases) {
            const CaseReport report = checkCase(
                hardCase,
                {{methodNamed(method), {arithmetic, FillRule::Closed, ByteRounding::Nearest}}});
            QCOMPARE(report.verdicts.size(), std::size_t(1));
            if (report.summary() == CaseOutcome::FellShort)
                found.append(hardCase.id);
        }
        QCOMPARE(found, failed);
    }

    void aLineCaseUnderAnotherRuleIsRefused()
    {
        const auto cases = readHardCases(
            R"({"version": 1, "cases": [{"id": "a", "kind": "line", "rule": "up", "endpoints": [[0, 0], [1, 1]]}]})");

        QVERIFY(!cases.isOk());
        QVERIFY(cases.error().message().contains(u"cases[0].rule: “up”; expected “major axis"));
    }

private:
    std::vector<HardCase> m_cases;
};

PIXELPLUMB_TEST(TestLineCases)

} // namespace tst_linecases

#include "tst_linecases.moc"
