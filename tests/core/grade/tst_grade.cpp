// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "core/grade/class/resultsfolder.h"
#include "core/runs/tracedscene.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/defectgroups.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/scanning.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace tst_grade {

using namespace pixelplumb;

namespace {

GradingOrder orderOf(const QTemporaryDir &folder, const char *results, int jobs = 2)
{
    return {folder.filePath(u"subs"_s), folder.filePath(QLatin1String(results)), u"1"_s, jobs};
}

const GradedSubmission *submissionNamed(const GradeReport &report, const QString &name)
{
    const auto found = std::ranges::find(report.submissions, name, &GradedSubmission::name);
    return found != report.submissions.end() ? &*found : nullptr;
}

/// The submission folder of this defect. Ids may contain a slash, folder names not.
QString folderOf(const Defect &defect) { return QString(defect.id).replace(u'/', u'-'); }

bool isAmong(const GradedSubmission &submission, const QStringList &defects)
{
    return std::ranges::any_of(submission.candidates, [&](const GradedCandidate &candidate) {
        return candidate.distance == 0 && candidate.defects == defects;
    });
}

} // namespace

/// Grades a folder of submissions.
class TestGrade : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder; ///< a class with all defects that are tried
    QTemporaryDir m_few; ///< a class that is graded several times
    Assignment m_assignment = exampleAssignment();
    std::vector<Defect> m_alone; ///< the defects in m_folder

    /// Delivers one right submission, some with a single defect, and some that are no picture.
    bool deliverClass(const QTemporaryDir &folder, const std::vector<Defect> &alone) const
    {
        const auto submission
            = [&folder](const QString &name) { return folder.filePath(u"subs/"_s + name); };
        bool isDelivered = deliver(submission(u"right"_s), m_assignment)
            && QDir().mkpath(submission(u"empty"_s)) && QDir().mkpath(submission(u"small"_s));
        for (const Defect &defect : alone)
            isDelivered
                = isDelivered && deliver(submission(folderOf(defect)), m_assignment, {defect});
        const QString first = m_assignment.scenes.front().name + u".png"_s;
        const QByteArray half = contentOf(submission(u"right/"_s + first)).left(60);
        return isDelivered && writeTo(submission(u"nonsense/"_s + first), "nonsense")
            && writeTo(submission(u"half/"_s + first), half)
            && QImage(3, 2, QImage::Format_RGB32).save(submission(u"small/"_s + first));
    }
    GradeReport graded(const GradingOrder &order)
    {
        const auto report = gradeFolder(order, m_assignment);
        if (!report)
            qWarning("%s", qPrintable(report.error().message()));
        return report && *report ? **report : GradeReport();
    }

    /// An assignment of a square of 100 pixels; only its colours count, 1 point.
    static Assignment pointsOfASquare(Credit credit, Leeway leeway)
    {
        Assignment assignment = exampleAssignment();
        assignment.credit = credit;
        assignment.margin.leeway = leeway;
        assignment.scenes.resize(1);
        AssignedScene &square = assignment.scenes[0];
        square.name = u"square"_s;
        square.points = {0, 0, 1};
        square.scene = Scene();
        square.scene.frame.width = square.scene.frame.height = 16;
        square.scene.triangles = {triangleAt(2, 2, 11, 2, 11, 11), triangleAt(2, 2, 11, 11, 2, 11)};
        return assignment;
    }
    static QImage pictureOf(const Assignment &assignment)
    {
        FrameBuffer frame(assignment.scenes[0].scene.frame);
        drawScene(assignment.scenes[0].scene, frame);
        return frame.copy();
    }

private slots:
    void initTestCase()
    {
        QVERIFY(!m_assignment.scenes.empty());
        const std::vector<Defect> defects = defectsOf(m_assignment);
        for (std::size_t i = 0; i < defects.size(); i += 2) // each one takes a diagnosis
            m_alone.push_back(defects[i]);
        m_alone = casesToRun(m_alone, groupOf);
        QVERIFY(deliverClass(m_folder, m_alone));
        QVERIFY(deliverClass(m_few, {defects[0], defects[defects.size() / 2]}));
        QVERIFY(deliver(m_few.filePath(u"subs/two"_s), m_assignment,
                        {defects.front(), defects.back()}));
    }

    void everyDefectIsNamed()
    {
        const GradeReport report = graded(orderOf(m_folder, "first"));
        int named = 0;
        for (const Defect &defect : m_alone) {
            const auto *each = submissionNamed(report, folderOf(defect));
            QVERIFY(each);
            if (each->verdict == GradeVerdict::Right)
                continue; // this arithmetic is exact enough here
            if (defect.choice == QLatin1String(arithmeticChoice)
                && each->verdict == GradeVerdict::Undecidable)
                continue; // which is allowed
            ++named;
            QVERIFY2(isAmong(*each, {defect.id}), qPrintable(defect.id));
        }
        QVERIFY(2 * std::size_t(named) > m_alone.size());
        const auto *right = submissionNamed(report, u"right"_s);
        QVERIFY(right);
        QCOMPARE(right->verdict, GradeVerdict::Right);
        QCOMPARE(right->points(), m_assignment.points());
    }

    void whatIsNoPictureIsToldAndHasNoPoints_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("told");
        QTest::newRow("empty") << "empty"
                               << "there is no picture";
        QTest::newRow("nonsense") << "nonsense"
                                  << "expected";
        QTest::newRow("half") << "half"
                              << "";
        QTest::newRow("small") << "small"
                               << "3 × 2";
    }
    void whatIsNoPictureIsToldAndHasNoPoints()
    {
        QFETCH(QString, name);
        QFETCH(QString, told);
        const GradeReport report = graded(orderOf(m_folder, "first"));
        const auto *submission = submissionNamed(report, name);
        QVERIFY(submission);
        QCOMPARE(submission->verdict, GradeVerdict::Nothing);
        QCOMPARE(submission->points(), 0.0);
        const QString fault = submission->scenes.front().fault;
        QVERIFY2(!fault.isEmpty() && fault.contains(told), qPrintable(fault));
    }

    void theSameSubmissionsGiveTheSameBytes()
    {
        graded(orderOf(m_few, "first"));
        graded(orderOf(m_few, "again", 1));
        const auto files = filesIn(m_few.filePath(u"first"_s));
        QVERIFY(files.size() > 8); // more than the submissions
        QVERIFY(filesIn(m_few.filePath(u"again"_s)) == files);
    }

    void whatWasEndedGoesOnWhereItStopped()
    {
        const GradingOrder order = orderOf(m_few, "ended", 1);
        const auto ended = gradeFolder(order, m_assignment,
                                       [](const JobProgress &told) { return told.done < 5; });
        QVERIFY(ended.isOk());
        QVERIFY(!ended->has_value());
        const QDir grades(m_few.filePath(u"ended/grades"_s));
        QCOMPARE(grades.entryList(QDir::Files).size(), 5);
        const auto sofar = readGrades(m_few.filePath(u"ended"_s));
        QVERIFY(sofar.isOk());
        QCOMPARE(sofar->submissions.size(), 5U);
        QVERIFY(!sofar->missing.isEmpty());
        // An existing grade is reused as it is; the submission is not examined again.
        const QString kept = grades.filePath(grades.entryList(QDir::Files).front());
        const QByteArray grade = contentOf(kept);
        const QByteArray assignment = writeAssignment(m_assignment);
        auto touched = readGradedSubmission(grade, assignment);
        QVERIFY(touched.isOk());
        touched->differing += 7;
        const QByteArray other = writeGradedSubmission(*touched, assignment);
        QVERIFY(writeTo(kept, other));
        graded(order);
        QCOMPARE(contentOf(kept), other);
        QVERIFY(writeTo(kept, grade));
        graded(order);

        graded(orderOf(m_few, "first"));
        QVERIFY(filesIn(m_few.filePath(u"ended"_s)) == filesIn(m_few.filePath(u"first"_s)));
    }

    void whoIsNotNamedHasNoGrade()
    {
        const QTemporaryDir folder;
        const Defect defect = defectsOf(m_assignment).back();
        for (const QString &name : {u"ann"_s, u"böb\u202e"_s, u"cem"_s, u"dea"_s})
            QVERIFY(deliver(folder.filePath(u"subs/"_s + name), m_assignment, {defect}));
        const auto words = [&](const QStringList &names) {
            return QStringList{u"grade"_s, folder.filePath(u"subs"_s)} + names
                + QStringList{u"--assignment"_s, resource(u"/assignments/column-scan.json"_s),
                              u"-o"_s, folder.filePath(u"results"_s)};
        };

        const ProgramRun nobody = run(words({u"ann"_s, u"zoe"_s}));
        QCOMPARE(nobody.exitCode, 2);
        QVERIFY2(nobody.messages.contains("zoe: is no submission in "),
                 nobody.messages.constData());
        QVERIFY(!QFile::exists(folder.filePath(u"results"_s)));

        // A name is taken as it is, or as results show it.
        const ProgramRun named = run(words({u"cem"_s, u"böb\\xe2\\x80\\xae"_s}));
        QCOMPARE(named.exitCode, 0);
        QVERIFY2(named.output.startsWith("2 submissions\npartial: 2 more without a grade\n"),
                 named.output.constData());
        for (const char *file : {"results.json", "index.html", "junit.xml", "grades.csv"}) {
            const QString path = folder.filePath(u"results/"_s + QLatin1String(file));
            QVERIFY2(contentOf(path).contains("ann") && contentOf(path).contains("dea"), file);
        }
        const QByteArray junit = contentOf(folder.filePath(u"results/junit.xml"_s));
        QVERIFY2(junit.contains("<testsuite name=\"ann\" tests=\"1\""), junit.constData());
        QVERIFY(junit.contains("<skipped message=\"no grade\"/>"));
        const auto read = readGrades(folder.filePath(u"results"_s));
        QVERIFY(read.isOk());
        QCOMPARE(read->missing, QStringList({u"ann"_s, u"dea"_s}));

        const ProgramRun rest = run(words({u"ann"_s, u"dea"_s}));
        QCOMPARE(rest.exitCode, 0);
        QVERIFY2(rest.output.startsWith("4 submissions\n    4  "), rest.output.constData());
    }

    void aShareOfThePixelsGivesAShareOfThePoints()
    {
        const QTemporaryDir folder;
        Assignment assignment = m_assignment;
        assignment.scenes.resize(1);
        assignment.scenes[0].points = {1, 10, 10};
        const QString first = assignment.scenes[0].name + u".png"_s;
        const QString own = folder.filePath(u"subs/ann/"_s);
        QVERIFY(deliver(own, assignment));
        QImage image(own + first);
        const QImage right = image;
        const QRgb background = image.pixel(0, 0);
        int covered = 0;
        for (int line = 0; line < image.height(); ++line) {
            for (int x = 0; x < image.width(); ++x)
                covered += image.pixel(x, line) != background ? 1 : 0;
        }
        int removed = 0;
        for (int line = 0; line < image.height() && removed < covered / 4; ++line) {
            for (int x = 0; x < image.width(); ++x) {
                if (image.pixel(x, line) != background) {
                    image.setPixel(x, line, background);
                    ++removed;
                }
            }
        }
        QVERIFY(image.save(own + first));
        const auto pointsFor = [&](Credit credit) {
            assignment.credit = credit;
            const auto report = gradeFolder(
                orderOf(folder, credit == Credit::Share ? "share" : "whole"), assignment);
            return (*report)->submissions.front().scenes.front().checks[1].points;
        };
        QCOMPARE(pointsFor(Credit::Whole), 0.0);
        const double share = double(covered - removed) / covered;
        const double points = pointsFor(Credit::Share);
        // Pixels that are left open count for neither side.
        QVERIFY2(std::abs(points - 10 * share) < 0.5, qPrintable(QString::number(points)));
        QVERIFY(points < 10);
    }

    void aPictureInWhiteIsRightWhereColoursHaveNoPoints()
    {
        const QTemporaryDir folder;
        Assignment assignment = m_assignment;
        assignment.scenes.resize(1);
        assignment.scenes[0].points = {1, 10, 0, 0};
        const QString own = folder.filePath(u"subs/ann/"_s);
        QVERIFY(deliver(own, assignment));
        const QString file = own + assignment.scenes[0].name + u".png"_s;
        QImage image(file);
        const QRgb background = image.pixel(0, 0);
        for (int line = 0; line < image.height(); ++line) {
            for (int x = 0; x < image.width(); ++x) {
                if (image.pixel(x, line) != background)
                    image.setPixelColor(x, line, Qt::white);
            }
        }
        QVERIFY(image.save(file));
        const auto report = gradeFolder(orderOf(folder, "results"), assignment);
        const GradedSubmission &ann = (*report)->submissions.front();
        QCOMPARE(ann.verdict, GradeVerdict::Right);
        QCOMPARE(ann.points(), 11.0);
        QVERIFY(ann.candidates.empty());
    }

    void sharesAreExactHundredths()
    {
        const QTemporaryDir folder;
        const Assignment assignment = pointsOfASquare(Credit::Share, Leeway::Strict);
        QImage picture = pictureOf(assignment);
        QList<QPoint> inside;
        for (int line = 0; line < picture.height(); ++line) {
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixel(x, line) != picture.pixel(0, 0))
                    inside += {x, line};
            }
        }
        QCOMPARE(inside.size(), 100);
        for (qsizetype right = 99; right >= 50; --right) {
            picture.setPixelColor(inside[right], Qt::white); // covered, but in another colour
            const QString name = folder.filePath(u"subs/%1/square.png"_s.arg(right));
            QVERIFY(QDir().mkpath(QFileInfo(name).path()) && picture.save(name));
        }
        const auto report = gradeFolder(orderOf(folder, "results"), assignment);
        QVERIFY(report && *report);
        for (const GradedSubmission &each : (*report)->submissions)
            QCOMPARE(each.points(), each.name.toInt() / 100.0);
    }

    void whatIsLeftOpenFailsNoCheck_data()
    {
        QTest::addColumn<int>("credit");
        QTest::newRow("whole") << int(Credit::Whole);
        QTest::newRow("share") << int(Credit::Share);
    }
    void whatIsLeftOpenFailsNoCheck()
    {
        QFETCH(int, credit);
        const QTemporaryDir folder;
        Assignment assignment = pointsOfASquare(Credit(credit), Leeway::Edges);
        // Three pixels inside, twelve on edges.
        assignment.scenes[0].scene.triangles = {triangleAt(3, 3, 7, 3, 3, 7)};
        QImage picture = pictureOf(assignment);
        int left = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (x > 3 && y > 3 && x + y < 10)
                    ++left;
                else // picture lines run downward
                    picture.setPixel(x, picture.height() - 1 - y, picture.pixel(15, 0));
            }
        }
        QCOMPARE(left, 3);
        const QString name = folder.filePath(u"subs/inner/square.png"_s);
        QVERIFY(QDir().mkpath(QFileInfo(name).path()) && picture.save(name));
        const auto report = gradeFolder(orderOf(folder, "results"), assignment);
        QVERIFY(report && *report);
        const GradedSubmission &graded = (*report)->submissions.front();
        QCOMPARE(graded.verdict, GradeVerdict::Undecidable);
        QVERIFY(graded.scenes.front().checks.front().isPassed);
        QCOMPARE(graded.points(), 1.0);
    }

    void whatIsNotReadIsToldToTheStudent()
    {
        const QTemporaryDir folder;
        const QString subs = folder.filePath(u"subs/"_s);
        const QString scene = m_assignment.scenes.front().name;
        QVERIFY(deliver(subs + u"twice"_s, m_assignment));
        QVERIFY(
            QImage(subs + u"twice/%1.png"_s.arg(scene)).save(subs + u"twice/%1.bmp"_s.arg(scene)));
        QVERIFY(QDir().mkpath(subs + u"linked"_s));
        QVERIFY(
            QFile::link(subs + u"twice/%1.png"_s.arg(scene), subs + u"linked/%1.png"_s.arg(scene)));
        QVERIFY(QDir().mkpath(subs + u"piped"_s));
        QCOMPARE(::mkfifo(QFile::encodeName(subs + u"piped/%1.png"_s.arg(scene)), 0600), 0);
        QVERIFY(QFile::link(subs + u"twice"_s, subs + u"whole link"_s));
        QVERIFY(QDir().mkpath(subs + u".git"_s));

        const ProgramRun told = run({u"grade"_s, subs, u"--assignment"_s,
                                     resource(u"/assignments/column-scan.json"_s), u"-o"_s,
                                     folder.filePath(u"results"_s)});
        QCOMPARE(told.exitCode, 0);
        QVERIFY2(told.messages.contains("begin with a dot: 1 (.git)"), told.messages.constData());
        const auto report = readGrades(folder.filePath(u"results"_s));
        QVERIFY(report.isOk());
        const auto sentences = [&](const char *name) {
            const auto *submission = submissionNamed(*report, QLatin1String(name));
            return submission ? sentencesFor(*submission, HintLevel::Class).join(u'\n') : QString();
        };
        QVERIFY2(sentences("twice").contains(u"graded %1.png; %1.bmp is there, too"_s.arg(scene)),
                 qPrintable(sentences("twice")));
        QVERIFY2(sentences("linked").contains(u"%1.png is a link"_s.arg(scene)),
                 qPrintable(sentences("linked")));
        QVERIFY2(sentences("piped").contains(u"%1.png is a pipe"_s.arg(scene)),
                 qPrintable(sentences("piped")));
        QVERIFY2(sentences("whole link").contains(u"whole link is a link"_s),
                 qPrintable(sentences("whole link")));
        const QByteArray table = contentOf(folder.filePath(u"results/grades.csv"_s));
        QVERIFY2(table.contains("\npiped,0,") && table.contains(",nothing,,"), table.constData());
    }

    void anAssignmentWithoutPointsIsWarnedOf()
    {
        const QTemporaryDir folder;
        Assignment assignment = m_assignment;
        for (AssignedScene &scene : assignment.scenes)
            scene.points = {0, 0, 0};
        QVERIFY(writeTo(folder.filePath(u"none.json"_s), writeAssignment(assignment)));
        QVERIFY(QDir().mkpath(folder.filePath(u"subs"_s)));
        const ProgramRun told
            = run({u"grade"_s, folder.filePath(u"subs"_s), u"--assignment"_s,
                   folder.filePath(u"none.json"_s), u"-o"_s, folder.filePath(u"results"_s)});
        QCOMPARE(told.exitCode, 0);
        QVERIFY2(told.messages.contains("all checks have 0 points"), told.messages.constData());
    }

    void whatIsGoneOrOtherIsGradedAnew()
    {
        const QTemporaryDir folder;
        const QString subs = folder.filePath(u"subs/"_s);
        QVERIFY(deliver(subs + u"ann"_s, m_assignment));
        QVERIFY(deliver(subs + u"bob"_s, m_assignment));
        const GradingOrder order = orderOf(folder, "results");
        QCOMPARE(graded(order).submissions.size(), 2U);
        QVERIFY(deliver(subs + u"ann"_s, m_assignment, {defectsOf(m_assignment).back()}));
        QVERIFY(QDir(subs + u"bob"_s).removeRecursively());
        const GradeReport report = graded(order);
        QCOMPARE(report.submissions.size(), 1U);
        QCOMPARE(report.submissions.front().verdict, GradeVerdict::Wrong);
    }

    void hostileNamesAndLinksHarmNothing()
    {
        const QTemporaryDir folder;
        const QByteArray subs = QFile::encodeName(folder.filePath(u"subs"_s));
        const QByteArray first = m_assignment.scenes.front().name.toUtf8() + ".png";
        QVERIFY(QDir().mkpath(QString::fromUtf8(subs)));
        const std::vector<QByteArray> names
            = {"a\nb", "x..\\..\\up", "\xff\xfe", "\x1b]0;title\x07",
               "=1+1", "<script>",    "%1%2",     "&amp;"};
        for (const QByteArray &name : names)
            QCOMPARE(::mkdir((subs + '/' + name).constData(), 0700), 0);
        QVERIFY(deliver(folder.filePath(u"secret"_s), m_assignment));
        const QByteArray secret = QFile::encodeName(folder.filePath(u"secret"_s));
        QCOMPARE(
            ::symlink((secret + '/' + first).constData(), (subs + "/a\nb/" + first).constData()),
            0);
        QCOMPARE(::symlink(secret.constData(), (subs + "/link").constData()), 0);
        QCOMPARE(::mkfifo((subs + "/\xff\xfe/" + first).constData(), 0600), 0);

        const GradeReport report = graded(orderOf(folder, "results"));
        QCOMPARE(report.submissions.size(), names.size() + 1);
        for (const GradedSubmission &each : report.submissions) {
            QCOMPARE(each.verdict, GradeVerdict::Nothing);
            QVERIFY(!each.name.contains(u'\n') && !each.name.contains(QChar(0x1b)));
        }
        const QStringList entries
            = QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
        QCOMPARE(entries, QStringList({u"results"_s, u"secret"_s, u"subs"_s}));
        const QByteArray page = contentOf(folder.filePath(u"results/index.html"_s));
        QVERIFY(page.contains("&lt;script&gt;") && !page.contains("<script"));
        QVERIFY(contentOf(folder.filePath(u"results/grades.csv"_s)).contains("\n'=1+1,"));
        // Qt's strings cannot hold these names, so its own clean-up would leave the files.
        QCOMPARE(::unlink((subs + "/\xff\xfe/" + first).constData()), 0);
        QCOMPARE(::rmdir((subs + "/\xff\xfe").constData()), 0);
    }

    void hostileProgramsCostOnlyThemselves()
    {
        const QTemporaryDir folder;
        Assignment assignment = m_assignment;
        assignment.program = AssignedProgram{u"draw"_s, ProgramInput::Json, 1, 1024, 1};
        assignment.scenes.resize(1);
        QVERIFY(deliver(folder.filePath(u"subs/right"_s), assignment));
        const auto addProgram = [&](const char *name, const char *script) {
            const QString path = folder.filePath(u"subs/%1/draw"_s.arg(QLatin1String(name)));
            QVERIFY(writeTo(path, QByteArray("#!/bin/sh\n") + script));
            QVERIFY(QFile::setPermissions(path,
                                          QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        };
        addProgram("crashing", "kill -SEGV $$\n");
        addProgram("hanging", "trap '' TERM\nsleep 60\n");
        addProgram("flooding", "while :; do echo 0123456789012345678901234567890123456789; done\n");
        addProgram("forking", "for i in 1 2 3 4 5 6 7 8; do setsid sleep 60 & done\nexit 0\n");
        addProgram("nonsense", "echo nonsense\n");
        const auto result = gradeFolder(orderOf(folder, "results"), assignment);
        QVERIFY(result.isOk() && result->has_value());
        const GradeReport &report = **result;
        QCOMPARE(report.submissions.size(), 6U);
        for (const GradedSubmission &each : report.submissions) {
            const bool isRight = each.name == u"right"_s;
            QCOMPARE(each.verdict, isRight ? GradeVerdict::Right : GradeVerdict::Nothing);
            QVERIFY(isRight || !each.scenes.front().fault.isEmpty());
        }
    }

    void theCommandGradesAndTellsTheCauses()
    {
        const QTemporaryDir folder;
        const auto defects = defectsOf(m_assignment);
        QVERIFY(deliver(folder.filePath(u"subs/ann"_s), m_assignment, {defects.back()}));
        QVERIFY(deliver(folder.filePath(u"subs/bob"_s), m_assignment, {defects.back()}));
        const QString subs = folder.filePath(u"subs"_s);
        const QStringList words = {u"grade"_s, subs, u"--assignment"_s,
                                   resource(u"/assignments/column-scan.json"_s), u"-o"_s};
        const ProgramRun told = run(words + QStringList{folder.filePath(u"r"_s)});
        QCOMPARE(told.exitCode, 0);
        QVERIFY2(told.output.startsWith("2 submissions\n    2  " + defects.back().id.toUtf8()),
                 told.output.constData());
        const ProgramRun within = run(words + QStringList{subs + u"/results"_s});
        QCOMPARE(within.exitCode, 2);
        QVERIFY(!QFile::exists(subs + u"/results"_s));
    }
};

PIXELPLUMB_TEST(TestGrade)

} // namespace tst_grade

#include "tst_grade.moc"
