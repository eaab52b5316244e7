// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/tablefolder.h"
#include "tests/support/runchecks/checkedruns.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"

#include <QSet>
#include <QTest>

#include <algorithm>
#include <map>

namespace tst_everyrun {

using namespace pixelplumb;

namespace {

/// The checks' findings in the runs of one method: the first fault of each check, and how many runs
/// have one.
class Findings {
public:
    void note(const RunCheck &check, const QString &where, const QString &fault)
    {
        if (fault.isEmpty())
            return;
        Finding &finding = m_findings[check.sentence];
        if (finding.count++ == 0)
            finding.first = where + u": "_s + fault;
    }

    /// One line per check; empty if nothing was found.
    QString text() const
    {
        QString text;
        for (const auto &[sentence, finding] : m_findings)
            text += u"\nNot so: %1. In %2 runs, first in %3"_s.arg(
                sentence, QString::number(finding.count), finding.first);
        return text;
    }

private:
    struct Finding {
        QString first;
        int count = 0;
    };
    std::map<QString, Finding> m_findings;
};

/// The default triangle by the column scan.
CheckedRun exampleRun()
{
    return checkedRunOf(u"default"_s, RunOrigin::Scene, defaultSceneIn(Arithmetic::Exact));
}

/// The run's trace, so that a test can make it inconsistent with the rest.
TracedScene &changeable(const CheckedRun &run)
{
    return *std::const_pointer_cast<TracedScene>(run.traced);
}

} // namespace

/// Every method on every scene in every arithmetic, each run traced once and given to all checks
/// that must hold for every run (tests/support/runchecks).
class TestEveryRun : public QObject {
    Q_OBJECT

private slots:
    void everyRunOfAMethodKeepsWhatIsPromised_data()
    {
        QTest::addColumn<const Method *>("method");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << &method;
    }
    void everyRunOfAMethodKeepsWhatIsPromised()
    {
        QFETCH(const Method *, method);
        const std::vector<RunCheck> checks = runChecks(m_tables);
        Findings findings;
        m_runs.forEachOf(*method, [&](const CheckedRun &run) {
            for (const RunCheck &check : checks)
                findings.note(check, run.name, check.faultOf(run));
        });
        for (const RunCheck &check : checks) {
            // A few runs cannot show everything.
            if (check.faultOfAll && !isSanitized)
                findings.note(check, method->id, check.faultOfAll(*method));
        }
        QVERIFY2(findings.text().isEmpty(), qPrintable(findings.text()));
    }

    void anotherProgramReadsTheTablesOfTheRuns()
    {
        QVERIFY(m_tables.keptCount() > 0);
        const QString fault = m_tables.faultByPython();
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    void someMethodOfEveryFamilyIsStable()
    {
        QSet<MethodFamily> families;
        QSet<MethodFamily> stable;
        for (const Method &method : methods()) {
            families.insert(method.family);
            if (!method.stableArithmetics.empty())
                stable.insert(method.family);
        }
        QCOMPARE(stable, families);
    }

    void aRunThatBreaksAPromiseIsNoticed_data()
    {
        using Break = std::function<void(CheckedRun &)>;
        QTest::addColumn<QString>("sentence");
        QTest::addColumn<Break>("breakIt");
        const auto row = [](const char *sentence, const Break &breakIt) {
            QTest::newRow(sentence) << QString::fromUtf8(sentence) << breakIt;
        };
        row("tracing changes no pixel, and every position can be reached from either side",
            [](CheckedRun &run) {
                changeable(run).scene.triangles[0].vertices[0].colour = {{9, 9, 9}};
            });
        row("the picture is the truth where the method is stable",
            [](CheckedRun &run) { changeable(run).differences.set(26, 20, Difference::Colour); });
        row("a wrong pixel is decided by its last visit",
            [](CheckedRun &run) { changeable(run).differences.set(26, 20, Difference::Colour); });
        row("every step has a heading and a sentence",
            [](CheckedRun &run) { run.steps.back().explanation.sentence.clear(); });
        row("coordinates that are not the scene's are said to be",
            [](CheckedRun &run) { changeable(run).scene.frame.pixelCentre = PixelCentre::Half; });
        row("every formula comes out at the number beside it", [](CheckedRun &run) {
            run.steps.front().explanation.lines.front().used = Quantity::integer(12345);
        });
        row("every step does a line of the pseudocode, and every line is done",
            [](CheckedRun &run) { changeable(run).method = methodNamed(u"point-address"); });
    }
    void aRunThatBreaksAPromiseIsNoticed()
    {
        QFETCH(QString, sentence);
        QFETCH(std::function<void(CheckedRun &)>, breakIt);
        TableFolder folder;
        const auto faultOf = [&](const CheckedRun &run) {
            std::vector<RunCheck> checks = runChecks(folder);
            const auto check = std::ranges::find(checks, sentence, &RunCheck::sentence);
            return check == checks.end() ? u"no such check"_s : check->faultOf(run);
        };
        CheckedRun run = exampleRun();
        QCOMPARE(faultOf(run), QString());
        breakIt(run);
        QVERIFY(!faultOf(run).isEmpty());
    }

private:
    const CheckedRuns m_runs;
    TableFolder m_tables;
};

PIXELPLUMB_TEST(TestEveryRun)

} // namespace tst_everyrun

#include "tst_everyrun.moc"
