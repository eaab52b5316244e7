// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "core/grade/class/resultsfolder.h"
#include "core/grade/class/submissionfolder.h"
#include "core/scene/files/inputrecord.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

namespace tst_resultsfolder {

using namespace pixelplumb;

/// Grading writes and replaces only its own files.
class TestResultsFolder : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    Assignment m_assignment = exampleAssignment();

    QString path(const QString &name) const { return m_folder->filePath(name); }
    GradingOrder order(const QString &results) const
    {
        return {path("subs"), path(results), u"1"_s, 1};
    }
    /// The error message; empty if grading worked.
    QString graded(const QString &results) const
    {
        const auto report = gradeFolder(order(results), m_assignment);
        return report ? QString() : report.error().message();
    }

private slots:
    void init()
    {
        m_assignment.scenes.resize(1);
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(deliver(path("subs/ann"), m_assignment));
        QVERIFY(writeTo(path("precious"), "precious"));
        QVERIFY(QDir().mkpath(path("elsewhere")));
        QVERIFY(writeTo(path("elsewhere/kept.txt"), "kept"));
    }

    void noLinkIsWrittenThrough_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("target");
        for (const char *name : {"index.html", "grades.csv", "results.json", "junit.xml",
                                 "assignment.json", "grading.lock"})
            QTest::newRow(name) << QString::fromLatin1(name) << u"precious"_s;
        for (const char *name : {"grades", "pictures", "gradescope"})
            QTest::newRow(name) << QString::fromLatin1(name) << u"elsewhere"_s;
    }
    void noLinkIsWrittenThrough()
    {
        QFETCH(QString, name);
        QFETCH(QString, target);
        QCOMPARE(graded("results"), QString()); // it is one of our folders
        const QString place = path("results/") + name;
        QVERIFY(QFileInfo(place).isDir() ? QDir(place).removeRecursively() : QFile::remove(place));
        QVERIFY(QFile::link(path(target), place));

        const QString refusal = graded("results");

        QVERIFY2(refusal.contains(name) && refusal.contains(u"link"_s), qPrintable(refusal));
        QCOMPARE(contentOf(path("precious")), QByteArray("precious"));
        QCOMPARE(QDir(path("elsewhere")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 QStringList("kept.txt"));
        QCOMPARE(contentOf(path("elsewhere/kept.txt")), QByteArray("kept"));
    }

    void aPipeIsNotWaitedFor_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name :
             {"index.html", "submissions.json", "assignment.json", "grading.lock"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void aPipeIsNotWaitedFor()
    {
        QFETCH(QString, name);
        QCOMPARE(graded("results"), QString());
        const QString place = path("results/") + name;
        QVERIFY(QFile::remove(place));
        QCOMPARE(::mkfifo(QFile::encodeName(place).constData(), 0600), 0);

        QVERIFY(!graded("results").isEmpty());
    }

    /// A limit on sizes ends the process with half of the file written.
    void aRunThatIsEndedLeavesNothingHalfWritten()
    {
        QVERIFY(QDir().mkpath(path("results/grades")));
        const ResultsFolder results(path("results"));
        const QString file = submissionFile(u"ann"_s);
        QVERIFY(!results.write(file, "old"));
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit limit{1000, 1000};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            ::signal(SIGXFSZ, SIG_DFL);
            const bool isWritten = !results.write(file, QByteArray(2000, 'x'));
            ::_exit(isWritten ? 0 : 1);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFSIGNALED(status));
        QCOMPARE(QDir(path("results/grades")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 QStringList("ann.json"));
        QCOMPARE(contentOf(path("results/grades/ann.json")), QByteArray("old"));
        QVERIFY(!results.write(file, QByteArray(2000, 'x')));
        QCOMPARE(contentOf(path("results/grades/ann.json")), QByteArray(2000, 'x'));
    }

    void aHardLinkKeepsItsContentElsewhere()
    {
        QCOMPARE(graded("results"), QString());
        const QString page = path("results/index.html");
        QVERIFY(QFile::remove(page));
        std::filesystem::create_hard_link(path("precious").toStdString(), page.toStdString());

        QCOMPARE(graded("results"), QString());

        QCOMPARE(contentOf(path("precious")), QByteArray("precious"));
        QVERIFY(contentOf(page).startsWith("<!DOCTYPE html>"));
    }

    void whatSomebodyElseWroteStays_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"index.html", "assignment.json", "submissions.json",
                                 "pictures/me.png", "grades/mine.txt", "reviews.json"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void whatSomebodyElseWroteStays()
    {
        QFETCH(QString, name);
        QVERIFY(writeTo(path("site/") + name, "mine"));
        const auto before = filesIn(path("site"));

        const QString refusal = graded("site");

        QVERIFY2(refusal.contains(u"is not of results of grading"_s), qPrintable(refusal));
        QVERIFY(filesIn(path("site")) == before);
    }

    void aDamagedListIsNamedWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("place");
        QTest::newRow("cut short") << QByteArray(R"({ "pixelplumbGrades": 1, "submissions")")
                                   << u"submissions.json, line 1, column 39"_s;
        QTest::newRow("a word for a list")
            << QByteArray(R"({ "pixelplumbGrades": 1, "submissions": "ann" })")
            << u"submissions.json, line 1, column 41, submissions: "_s;
    }
    void aDamagedListIsNamedWithItsPlace()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, place);
        QCOMPARE(graded("results"), QString());
        QVERIFY(writeTo(path("results/submissions.json"), content));

        const QString again = graded("results");
        const auto read = readGrades(path("results"));

        QVERIFY2(again.contains(place), qPrintable(again));
        QVERIFY(!read);
        QVERIFY2(read.error().message().contains(place), qPrintable(read.error().message()));
        QCOMPARE(contentOf(path("results/submissions.json")), content);
    }

    void aGradeUnderAnotherNameIsGradedAgainAndNotRead()
    {
        QCOMPARE(graded("results"), QString());
        const auto before = filesIn(path("results"));
        const QString file = submissionFileOf(path("results"), idOf("ann"));
        const QByteArray content = contentOf(file);
        const auto whole = readGrades(path("results"));
        GradedSubmission renamed = whole->submissions.at(0);
        QCOMPARE(renamed.name, u"ann"_s);
        renamed.name = u"bob"_s;
        QVERIFY(writeTo(file, writeGradedSubmission(renamed, writeAssignment(whole->assignment))));

        const auto read = readGrades(path("results"));
        QVERIFY(!read);
        QVERIFY2(read.error().message().contains(u"is not named as grading names"_s),
                 qPrintable(read.error().message()));

        QCOMPARE(graded("results"), QString());
        QCOMPARE(contentOf(file), content);
        QVERIFY(filesIn(path("results")) == before);
    }

    void whatWasEditedIsGradedAgainAndNotRead_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QByteArray>("edited");
        QTest::addColumn<QString>("refused");
        const QString grade = submissionFile(idOf("ann"));
        QTest::newRow("points") << grade << QByteArray("\"points\": ")
                                << QByteArray("\"points\": 1") << grade;
        QTest::newRow("no seal") << grade << QByteArray("\"seal\": ") << QByteArray("\"SEAL\": ")
                                 << grade;
        QTest::newRow("the assignment's points") << assignmentFile << QByteArray("\"points\": {")
                                                 << QByteArray("\"points\":{ ") << QString();
        QTest::newRow("the assignment's hints")
            << assignmentFile << QByteArray("\"hint\": \"hint\"")
            << QByteArray("\"hint\": \"full\"") << grade;
        QTest::newRow("the list of submissions") << submissionListFile << QByteArray("\"ann\"")
                                                 << QByteArray("\"bob\"") << submissionListFile;
    }
    void whatWasEditedIsGradedAgainAndNotRead()
    {
        QFETCH(QString, file);
        QFETCH(QByteArray, written);
        QFETCH(QByteArray, edited);
        QFETCH(QString, refused);
        QCOMPARE(graded("results"), QString());
        const auto before = filesIn(path("results"));
        const QString place = path("results/") + file;
        const QByteArray content = contentOf(place);
        QVERIFY2(content.contains(written), content.constData());
        QVERIFY(writeTo(place, QByteArray(content).replace(written, edited)));

        const auto read = readGrades(path("results"));

        QCOMPARE(read.isOk(), refused.isEmpty()); // spaces change no message
        if (!refused.isEmpty())
            QVERIFY2(read.error().message().contains(path("results/") + refused),
                     qPrintable(read.error().message()));
        QCOMPARE(graded("results"), QString());
        QVERIFY(filesIn(path("results")) == before);
    }

    void aPictureThatWasChangedIsGradedAgainAndNotRead_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("cut short") << QByteArray();
        QTest::newRow("another") << QByteArray("#.\n.#\n");
    }
    void aPictureThatWasChangedIsGradedAgainAndNotRead()
    {
        QFETCH(QByteArray, content);
        QCOMPARE(graded("results"), QString());
        const auto before = filesIn(path("results"));
        const QStringList pictures = QDir(path("results/pictures")).entryList(QDir::Files);
        QVERIFY(!pictures.isEmpty());
        const QString picture = path("results/pictures/") + pictures.front();
        QVERIFY(writeTo(picture, content));

        const auto read = readGrades(path("results"));
        QVERIFY(!read);
        QCOMPARE(read.error().message(),
                 picture
                     + u": has been changed since grading wrote it; expected what "
                       "grading wrote; grade the submissions again"_s);

        QCOMPARE(graded("results"), QString());
        QVERIFY(filesIn(path("results")) == before);
    }

    void aFolderThatCannotBeWrittenToSaysSo()
    {
        QCOMPARE(graded("results"), QString());
        const QByteArray folder = QFile::encodeName(path("results"));
        QCOMPARE(::chmod(QFile::encodeName(m_folder->path()).constData(), 0755), 0);
        QCOMPARE(::chmod(folder.constData(), 0555), 0);
        const auto before = filesIn(path("results"));
        constexpr uid_t somebody = 65534; // root may write anywhere
        const bool isRoot = ::geteuid() == 0;
        QVERIFY(!isRoot || ::seteuid(somebody) == 0);

        const QString refusal = graded("results");

        QVERIFY(!isRoot || ::seteuid(0) == 0);
        QCOMPARE(::chmod(folder.constData(), 0755), 0);
        QVERIFY2(refusal.contains(path("results")) && refusal.contains(u"cannot be written"_s),
                 qPrintable(refusal));
        QVERIFY(filesIn(path("results")) == before);
    }

    void whatCannotBecomeAFolderIsSaid_data()
    {
        QTest::addColumn<QString>("results");
        QTest::addColumn<QString>("why");
        QTest::newRow("a file") << "precious"
                                << "precious: is a file; expected a folder";
        QTest::newRow("under a file") << "precious/below"
                                      << "cannot be made: Not a directory";
        QTest::newRow("a link to nowhere") << "dangling"
                                           << "is a link to ";
    }
    void whatCannotBecomeAFolderIsSaid()
    {
        QFETCH(QString, results);
        QFETCH(QString, why);
        QVERIFY(QFile::link(path("nowhere"), path("dangling")));

        const QString refusal = graded(results);

        QVERIFY2(refusal.contains(why), qPrintable(refusal));
        QCOMPARE(contentOf(path("precious")), QByteArray("precious"));
    }

    void otherFilesMayStandBesideTheResults()
    {
        QVERIFY(writeTo(path("site/notes.txt"), "mine"));
        QVERIFY(QDir().mkpath(path("site/pictures"))); // empty, as an ended run leaves it
        QCOMPARE(graded("site"), QString());
        QCOMPARE(contentOf(path("site/notes.txt")), QByteArray("mine"));
    }

    void theAssignmentThatIsReadIsNotReplaced()
    {
        QCOMPARE(graded("results"), QString());
        const InputRecord record;
        const QString own = assignmentFileOf(path("results"));
        const auto read = readAssignmentFile(own);
        QVERIFY(read.isOk());
        const auto before = filesIn(path("results"));

        const auto report = gradeFolder(order("results"), *read);

        QVERIFY(!report);
        QVERIFY2(report.error().message().contains(u"is the input, which it would replace"_s),
                 qPrintable(report.error().message()));
        QVERIFY(filesIn(path("results")) == before);
    }

    void resultsMayBeReadAndGradedAgain()
    {
        const InputRecord record;
        QCOMPARE(graded("results"), QString());
        QVERIFY(readGrades(path("results")).isOk());
        QVERIFY(ResultsFolder(path("results")).read(assignmentFile).isOk());
        QCOMPARE(graded("results"), QString());
    }

    void resultsAmongTheSubmissionsAreFoundBehindLinks_data()
    {
        QTest::addColumn<QString>("results");
        QTest::newRow("itself") << u"subs"_s;
        QTest::newRow("below") << u"subs/results"_s;
        QTest::newRow("by dots") << u"elsewhere/../subs/results"_s;
        QTest::newRow("by a link, not there yet") << u"link/results/deep"_s;
        QTest::newRow("by a link to the submissions") << u"link"_s;
        QTest::newRow("by a link to what is not there") << u"dangling"_s;
        QTest::newRow("above") << u"."_s;
    }
    void resultsAmongTheSubmissionsAreFoundBehindLinks()
    {
        QFETCH(QString, results);
        QVERIFY(QFile::link(path("subs"), path("link")));
        QVERIFY(QFile::link(path("subs/results"), path("dangling")));

        QVERIFY(!graded(results).isEmpty());

        QCOMPARE(QDir(path("subs")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 QStringList("ann"));
    }
};

PIXELPLUMB_TEST(TestResultsFolder)

} // namespace tst_resultsfolder

#include "tst_resultsfolder.moc"
