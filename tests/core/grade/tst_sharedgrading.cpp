// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "core/grade/class/resultslock.h"
#include "core/grade/class/submissionfolder.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace tst_sharedgrading {

using namespace pixelplumb;

namespace {

constexpr int longest = 120'000; // ms

using Processes = std::vector<std::unique_ptr<QProcess>>;

} // namespace

/// Several runs grade into one folder of results.
class TestSharedGrading : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    Assignment m_assignment = exampleAssignment();
    QMap<QString, QByteArray> m_alone; ///< the results of one run alone

    QString path(const QString &name) const { return m_folder.filePath(name); }
    GradingOrder order(const QString &results) const
    {
        return {path("subs"), path(results), u"1"_s, 1};
    }
    std::unique_ptr<QProcess> started(const QString &results, const QStringList &names = {}) const
    {
        auto process = std::make_unique<QProcess>();
        process->start(program(),
                       QStringList{"grade", "--assignment", path("assignment.json"), "--jobs", "1",
                                   "-o", path(results), "--", path("subs")}
                           + names);
        return process;
    }
    /// How many of the runs printed a report; the others leave it to them.
    static int reportsOf(const Processes &runs)
    {
        int reports = 0;
        for (const auto &run : runs) {
            if (!run->waitForFinished(longest) || run->exitCode() != 0)
                return -1;
            const QByteArray told = run->readAllStandardOutput();
            reports += told.isEmpty() ? 0 : 1;
            const bool leaves
                = run->readAllStandardError().contains("other runs are still grading; the last");
            if (leaves != told.isEmpty())
                return -1;
        }
        return reports;
    }
    static bool isClaimed(const QString &results, const QByteArray &submission)
    {
        const auto lock = ResultsLock::of(ResultsFolder(results));
        return lock && !lock->claim(submission)->isOpen();
    }

private slots:
    void initTestCase()
    {
        m_assignment.scenes.resize(1);
        QVERIFY(writeTo(path("assignment.json"), writeAssignment(m_assignment)));
        const std::vector<Defect> defects = defectsOf(m_assignment);
        QVERIFY(deliver(path("subs/--ann"), m_assignment));
        QVERIFY(deliver(path("subs/bob"), m_assignment, {defects.front(), defects.back()}));
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(deliver(path("subs/student ") + QString::number(i), m_assignment,
                            {defects[i * defects.size() / 3]}));
        QCOMPARE(started("alone")->waitForFinished(longest), true);
        m_alone = filesIn(path("alone"));
        QVERIFY(m_alone.size() > 14);
    }

    void processesAtOnceGiveTheBytesOfOne_data()
    {
        QTest::addColumn<int>("processes");
        QTest::newRow("two") << 2;
        QTest::newRow("four") << 4;
    }
    void processesAtOnceGiveTheBytesOfOne()
    {
        QFETCH(int, processes);
        const QString results = "shared by " + QString::number(processes);
        Processes runs;
        for (int i = 0; i < processes; ++i)
            runs.push_back(started(results));

        QVERIFY(reportsOf(runs) >= 1);

        QVERIFY(filesIn(path(results)) == m_alone);
    }

    void processesWithListsGiveTheBytesOfOne()
    {
        const QStringList names = QDir(path("subs")).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        QCOMPARE(names.size(), 5);
        Processes runs;
        runs.push_back(started("by lists", names.mid(0, 2)));
        runs.push_back(started("by lists", names.mid(2, 2)));
        runs.push_back(started("by lists", names.mid(4)));

        QVERIFY(reportsOf(runs) >= 1);

        QVERIFY(filesIn(path("by lists")) == m_alone);
    }

    void aKilledProcessLosesItsCurrentSubmissionAlone()
    {
        const QTemporaryDir folder;
        Assignment assignment = m_assignment;
        assignment.program = AssignedProgram{{}, ProgramInput::Json, 1, 1024, 1};
        const QString file = folder.filePath("a.json");
        const QString results = folder.filePath("results");
        QVERIFY(writeTo(file, writeAssignment(assignment)));
        for (const char *name : {"ann", "cem", "dea"})
            QVERIFY(deliver(folder.filePath("subs/") + name, assignment));
        const QString sleeping = folder.filePath("subs/bob/draw"); // until the clock ends it
        QVERIFY(writeTo(sleeping, "#!/bin/sh\nsleep 60\n"));
        QVERIFY(QFile::setPermissions(sleeping,
                                      QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        const QStringList words = {"grade", folder.filePath("subs"), "-o", results, "--jobs",
                                   "1",     "--assignment",          file};

        QProcess killed;
        killed.start(program(), words);
        const QString first = submissionFileOf(results, idOf("ann"));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(first) && isClaimed(results, "bob"), longest);
        const ProgramRun beside = run(words);
        killed.kill();
        QVERIFY(killed.waitForFinished(longest));

        QCOMPARE(beside.exitCode, 0);
        QVERIFY2(beside.messages.contains("other runs are still grading"),
                 beside.messages.constData());
        QVERIFY(!QFile::exists(results + "/index.html"));
        QVERIFY(!isClaimed(results, "bob"));
        const auto read = readGrades(results);
        QVERIFY(read.isOk());
        QCOMPARE(read->missing, QStringList("bob"));

        const auto before = filesIn(results + "/grades");
        const ProgramRun next = run(words);
        QCOMPARE(next.exitCode, 0);
        QVERIFY2(next.output.startsWith("4 submissions\n"), next.output.constData());
        const auto after = filesIn(results + "/grades");
        QCOMPARE(after.size(), 4);
        for (const auto &[name, grade] : before.asKeyValueRange())
            QCOMPARE(after[name], grade);
    }

    void theLastRunGradesWhatAnEndedOneHadClaimed()
    {
        QVERIFY(gradeFolder(order("taken over"), m_assignment).isOk());
        const auto before = filesIn(path("taken over"));
        QVERIFY(QFile::remove(submissionFileOf(path("taken over"), idOf("bob"))));
        auto lock = std::make_unique<Result<ResultsLock>>(
            ResultsLock::of(ResultsFolder(path("taken over"))));
        (*lock)->share();
        auto claim = std::make_unique<Result<Descriptor>>((*lock)->claim("bob"));
        QVERIFY((*claim)->isOpen());

        const auto report
            = gradeFolder(order("taken over"), m_assignment, [&](const JobProgress &progress) {
                  if (progress.done == 4) { // all but bob
                      claim.reset();
                      lock.reset();
                  }
                  return true;
              });

        QVERIFY(report.isOk() && report->has_value());
        QVERIFY(filesIn(path("taken over")) == before);
    }

    void onlyRunsOfOneAssignmentShareAFolder()
    {
        QVERIFY(gradeFolder(order("one assignment"), m_assignment).isOk());
        const auto before = filesIn(path("one assignment"));
        Assignment other = m_assignment;
        other.hint = HintLevel::Full;
        {
            auto lock = ResultsLock::of(ResultsFolder(path("one assignment")));
            QVERIFY(lock.isOk());
            lock->share();

            const auto same = gradeFolder(order("one assignment"), m_assignment);
            const auto refused = gradeFolder(order("one assignment"), other);

            QVERIFY(same.isOk() && !same->has_value());
            QVERIFY(!refused);
            QCOMPARE(refused.error().message(),
                     path("one assignment/assignment.json")
                         + u": is of another run, which is still grading; expected "
                           "its end, or another folder for this assignment"_s);
        }
        QVERIFY(filesIn(path("one assignment")) == before);
        const auto after = gradeFolder(order("one assignment"), other);
        QVERIFY(after.isOk() && after->has_value());
        QCOMPARE((*after)->assignment.hint, HintLevel::Full);
    }

    void whatADeadProcessLeftIsTidiedUp()
    {
        QVERIFY(gradeFolder(order("left"), m_assignment).isOk());
        const auto before = filesIn(path("left"));
        QVERIFY(before.contains("grading.lock"));
        const QString half = submissionFileOf(path("left"), idOf("bob")) + ".0123abcd";
        QVERIFY(writeTo(half, "{ \"half"));

        QVERIFY(gradeFolder(order("left"), m_assignment).isOk());

        QVERIFY(filesIn(path("left")) == before);
    }
};

PIXELPLUMB_TEST(TestSharedGrading)

} // namespace tst_sharedgrading

#include "tst_sharedgrading.moc"
