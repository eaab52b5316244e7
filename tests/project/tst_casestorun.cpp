// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/casestorun.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <numeric>
#include <set>

namespace tst_casestorun {

using namespace pixelplumb;

namespace {

std::vector<int> numbersBelow(int end)
{
    std::vector<int> numbers(std::size_t(end), 0);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

QString parityOf(int number) { return number % 2 == 0 ? "even" : "odd"; }

} // namespace

/// Which cases of a long list run.
class TestCasesToRun : public QObject {
    Q_OBJECT

private slots:
    void init() { qunsetenv("PIXELPLUMB_TEST_CASES"); }

    void aTenthOfEachGroupIsRunInOrder()
    {
        const std::vector<int> run = casesToRun(numbersBelow(200), parityOf);

        QCOMPARE(std::ranges::count(run, "even", parityOf), 10);
        QCOMPARE(std::ranges::count(run, "odd", parityOf), 10);
        QVERIFY(std::ranges::is_sorted(run));
        QCOMPARE(std::set(run.begin(), run.end()).size(), run.size());
    }

    void noGroupIsLeftOut()
    {
        const auto ownGroup = [](int number) { return QString::number(number); };
        QCOMPARE(casesToRun(numbersBelow(7), ownGroup), numbersBelow(7));
        QCOMPARE(casesToRun(numbersBelow(11)).size(), std::size_t(2));
        QVERIFY(casesToRun(numbersBelow(0)).empty());
    }

    void everyRunMeetsTheSameCasesUnlessItHasAnotherSeed()
    {
        const auto usual = casesToRun(numbersBelow(200));
        QCOMPARE(casesToRun(numbersBelow(200)), usual);
        qputenv("PIXELPLUMB_TEST_CASES", "1");
        QCOMPARE(casesToRun(numbersBelow(200)), usual);

        std::set<int> met;
        for (int seed = 1; seed <= 100; ++seed) {
            qputenv("PIXELPLUMB_TEST_CASES", QByteArray::number(seed));
            for (const int number : casesToRun(numbersBelow(200)))
                met.insert(number);
        }
        QCOMPARE(met.size(), std::size_t(200));
    }

    void groupsOfOneSizeAreNotDrawnAlike()
    {
        const auto run = casesToRun(numbersBelow(200), parityOf);
        std::vector<int> halves[2];
        for (const int number : run)
            halves[number % 2].push_back(number / 2);
        QVERIFY(halves[0] != halves[1]);
    }

    void allCasesRunOnRequest()
    {
        QVERIFY(!areAllCasesRun());
        qputenv("PIXELPLUMB_TEST_CASES", "all");
        QVERIFY(areAllCasesRun());
        QCOMPARE(casesToRun(numbersBelow(200), parityOf), numbersBelow(200));
    }

    void randomCasesAreFewAndFixedByDefault()
    {
        qunsetenv("RC_PARAMS");
        drawFewerRandomCases();
        QCOMPARE(qgetenv("RC_PARAMS"), "max_success=10 seed=1");

        qputenv("RC_PARAMS", "seed=7");
        drawFewerRandomCases();
        QCOMPARE(qgetenv("RC_PARAMS"), "seed=7");

        qunsetenv("RC_PARAMS");
        qputenv("PIXELPLUMB_TEST_CASES", "all");
        drawFewerRandomCases();
        QVERIFY(!qEnvironmentVariableIsSet("RC_PARAMS"));
    }
};

PIXELPLUMB_TEST(TestCasesToRun)

} // namespace tst_casestorun

#include "tst_casestorun.moc"
