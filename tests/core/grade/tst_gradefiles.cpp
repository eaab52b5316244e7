// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradereports.h"
#include "core/grade/class/submissionfolder.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

namespace tst_gradefiles {

using namespace pixelplumb;

namespace {

const QByteArray oneScene = R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 6 },
    "primitives": [ { "triangle": [[0, 0], [7, 0], [0, 5]], "colors": ["#ff0000", "#00ff00", "#0000ff"] } ] })";

QByteArray assignmentWith(const QByteArray &more, const QByteArray &ofScene = {})
{
    return R"({ "pixelplumbAssignment": 1, "name": "Two", )" + more
        + R"("scenes": [ { "name": "one", )" + ofScene + R"("scene": )" + oneScene + "} ] }";
}

GradedSubmission submission(const char *name, GradeVerdict verdict,
                            std::vector<GradedCandidate> candidates = {})
{
    GradedSubmission graded;
    graded.name = QString::fromLatin1(name);
    graded.id = idOf(name);
    graded.verdict = verdict;
    graded.candidates = std::move(candidates);
    return graded;
}

GradedCandidate candidate(const char *id, std::int64_t distance = 0)
{
    return {{QString::fromLatin1(id)}, {u"Look."_s}, {u"Done."_s}, distance, {}};
}

} // namespace

/// Assignments and grades as files.
class TestGradeFiles : public QObject {
    Q_OBJECT

private slots:
    void anAssignmentIsReadBackAsItWasWritten_data()
    {
        QTest::addColumn<QByteArray>("program");
        QTest::newRow("a program with a name")
            << QByteArray(R"({ "file": "main.py", "input": "lines", "seconds": 3 })");
        QTest::newRow("the one executable file")
            << QByteArray(R"({ "input": "lines", "seconds": 3 })");
    }
    void anAssignmentIsReadBackAsItWasWritten()
    {
        QFETCH(QByteArray, program);
        const auto assignment = readAssignment(assignmentWith(
            R"("hint": "full", "leeway": "once", "tolerance": "float64", "winding": "counter-clockwise", "credit": "share", "points": { "coverage": 2.5 },
               "program": )"
            + program + ", "));
        QVERIFY2(assignment.isOk(), assignment ? "" : qPrintable(assignment.error().message()));
        QCOMPARE(assignment->hint, HintLevel::Full);
        QCOMPARE(assignment->points(), 1 + 2.5 + 2);
        QCOMPARE(assignment->program->seconds, 3);

        const auto again = readAssignment(writeAssignment(*assignment));
        QVERIFY(again.isOk());
        QVERIFY(*again == *assignment);
        QCOMPARE(writeAssignment(*again), writeAssignment(*assignment));
    }

    void whatIsWrongWithAnAssignmentIsToldWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("told");
        const auto row = [](const char *name, const QByteArray &text, const char *told) {
            QTest::newRow(name) << text << QString::fromUtf8(told);
        };
        row("no assignment", R"({ "name": "" })", "this is no assignment");
        row("newer", R"({ "pixelplumbAssignment": 2 })",
            "pixelplumbAssignment: 2; expected the integer 1");
        row("unknown key", assignmentWith(R"("grade": 1, )"), "grade: unknown key “grade”");
        row("unknown hint", assignmentWith(R"("hint": "some", )"),
            "hint: “some”; expected one of class, hint, pixels, full");
        row("negative points", assignmentWith({}, R"("points": { "colours": -1 }, )"),
            "scenes[0].points.colours: -1; expected a number from 0 to 1000000");
        row("no memory", assignmentWith(R"("program": { "megabytes": 0 }, )"),
            "program.megabytes: 0: a class' programs may not have all memory; expected 16 to");
        row("memory in which nothing starts", assignmentWith(R"("program": { "megabytes": 15 }, )"),
            "program.megabytes: 15; expected an integer from 16 to 1048576");
        row("unknown credit", assignmentWith(R"("credit": "half", )"),
            "credit: “half”; expected one of whole, share");
        row("a scene", R"({ "pixelplumb": 1 })", "this is a scene; expected an assignment");
        row("no scenes", R"({ "pixelplumbAssignment": 1, "name": "", "scenes": [] })",
            "scenes: an array of 0; expected one scene at least");
        row("a scene's name with a folder",
            R"({ "pixelplumbAssignment": 1, "name": "", "scenes": [ { "name": "../a", "scene": "b" } ] })",
            "scenes[0].name: “../a”; expected 1 to 64 letters");
        row("a scene that is not there",
            R"({ "pixelplumbAssignment": 1, "name": "", "scenes": [ { "name": "a", "scene": "b.json" } ] })",
            "scenes[0].scene: ");
        const QByteArray varied = R"({ "pixelplumbAssignment": 1, "name": "", "scenes": [
            { "name": "a", "scene": { "variants": [ "divisor-minus-one", "divisor-plus-one" ], )"
            + oneScene.mid(1) + "} ] }";
        row("variants that cancel each other", varied,
            "scenes[0].scene: the variants divisor-minus-one and divisor-plus-one cancel each "
            "other: the divisor is Δ again; expected one of them, or none");
        row("a program in another folder", assignmentWith(R"("program": { "file": "../x" }, )"),
            "program.file: “../x”; expected a file's name, without folders");
        row("a program without a name", assignmentWith(R"("program": { "file": "" }, )"),
            "program.file: “”; expected a file's name, without folders");
    }
    void whatIsWrongWithAnAssignmentIsToldWithItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, told);
        const auto assignment = readAssignment(text);
        QVERIFY(!assignment);
        QVERIFY2(assignment.error().message().contains(told),
                 qPrintable(assignment.error().message()));
    }

    void theExampleCanBeRead()
    {
        const auto assignment = readAssignmentFile(resource(u"/assignments/column-scan.json"_s));
        QVERIFY2(assignment.isOk(), assignment ? "" : qPrintable(assignment.error().message()));
        QCOMPARE(assignment->scenes.size(), 4U);
    }

    void aGradeIsReadBackAsItWasWritten()
    {
        GradedSubmission graded
            = submission("a\nb", GradeVerdict::Wrong, {candidate("unsorted-colours")});
        graded.digest = u"12ab"_s;
        graded.differing = 5'000'000'000;
        graded.candidates[0].parts
            = FirstDivergence{u"one"_s, 3, u"Column 2"_s, u"y_T is 1, should be 2"_s};
        GradedScene scene;
        scene.scene = u"one"_s;
        scene.counts = {1, 2, 3, 4, 5};
        scene.firstDifference = FramePixel{7, 0};
        scene.run = GradedRun{u"crashed"_s, u"by a signal"_s, {}};
        scene.note = u"graded one.png; one.ppm is there, too"_s;
        scene.checks = {{Check::Coverage, true, 2.5, 2.5}};
        graded.scenes = {scene};

        const auto again = readGradedSubmission(writeGradedSubmission(graded, "about"), "about");
        QVERIFY2(again.isOk(), again ? "" : qPrintable(again.error().message()));
        QVERIFY(*again == graded);
    }

    void aGradeInWhichAByteWasChangedIsRefused()
    {
        GradedSubmission graded
            = submission("ann", GradeVerdict::Wrong, {candidate("unsorted-colours")});
        GradedScene scene;
        scene.counts = {1, 2, 3, 4, 5};
        scene.checks = {{Check::Coverage, true, 2.5, 2.5}};
        graded.scenes = {scene};
        const QByteArray written = writeGradedSubmission(graded, "about");
        QVERIFY(readGradedSubmission(written, "about").isOk());
        QVERIFY(!readGradedSubmission(written, "about something else"));
        for (qsizetype i = 0; i < written.size(); ++i) {
            QByteArray edited = written;
            edited[i] = edited[i] == '9' ? '8' : '9';
            QVERIFY2(!readGradedSubmission(edited, "about"), edited.mid(i - 10, 20).constData());
            edited.remove(i, 1);
            QVERIFY2(!readGradedSubmission(edited, "about"), edited.mid(i - 10, 20).constData());
        }
        const auto edited = readGradedSubmission(
            QByteArray(written).replace("\"points\": 2.5", "\"points\": 1.5"), "about");
        QVERIFY2(edited.error().message().contains("has been edited since grading wrote it"),
                 qPrintable(edited.error().message()));
    }

    void whatCannotBeShownIsWrittenAsItsCode()
    {
        const QString hidden = u"a\u202Eb\U000E0001c"_s;
        GradeReport report;
        report.assignment = *readAssignment(assignmentWith({}));
        report.assignment.name = hidden;
        report.submissions = {submission("ann", GradeVerdict::Wrong)};
        report.submissions[0].searchError = hidden;
        report.submissions[0].review.comment = hidden;
        const QByteArray assignment = writeAssignment(report.assignment);
        for (const QByteArray &text : {assignment, gradescopeOf(report), junitOf(report),
                                       writeGradedSubmission(report.submissions[0], assignment)}) {
            QVERIFY2(!text.contains("\u202E") && !text.contains("\U000E0001"), text.constData());
        }
        QCOMPARE(readAssignment(assignment)->name, hidden);
    }

    void whatTheAssistantSaidIsKeptApart()
    {
        const QTemporaryDir folder;
        GradeReport report;
        report.submissions
            = {submission("ann", GradeVerdict::Right), submission("bob", GradeVerdict::Wrong)};
        report.submissions[1].review = {u"See me."_s, true};
        QVERIFY(!writeReviews(folder.path(), report));
        const QByteArray grade = writeGradedSubmission(
            report.submissions[1], writeAssignment(*readAssignment(assignmentWith({}))));
        QVERIFY(!grade.contains("See me."));

        QVERIFY(QDir(folder.path()).mkdir(u"grades"_s));
        QFile assignment(assignmentFileOf(folder.path()));
        QVERIFY(assignment.open(QIODevice::WriteOnly));
        assignment.write(assignmentWith({}));
        assignment.close();
        QFile file(submissionFileOf(folder.path(), report.submissions[1].id));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(grade);
        file.close();
        const auto read = readGrades(folder.path());
        QVERIFY2(read.isOk(), read ? "" : qPrintable(read.error().message()));
        QCOMPARE(read->submissions.size(), 1U);
        QVERIFY(read->submissions[0].review == report.submissions[1].review);
    }

    void submissionsOfOneCauseAreTogether()
    {
        GradeReport report;
        report.submissions = {submission("a", GradeVerdict::Right),
                              submission("b", GradeVerdict::Wrong, {candidate("flat-first")}),
                              submission("c", GradeVerdict::Wrong, {candidate("flat-last", 3)}),
                              submission("d", GradeVerdict::Wrong, {candidate("flat-first")}),
                              submission("e", GradeVerdict::Right),
                              submission("f", GradeVerdict::Right)};
        QStringList told;
        for (const GradeCluster &cluster : clustersOf(report))
            told += u"%1 %2"_s.arg(cluster.title).arg(cluster.submissions.size());
        QCOMPARE(told, QStringList({u"flat-first 2"_s, u"no known defect 1"_s, u"right 3"_s}));
    }

    void namesAreEscapedAndToldApart_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QString>("shown");
        QTest::newRow("plain") << QByteArray("ann") << u"ann"_s;
        QTest::newRow("letters") << QByteArray("Žofie Ωmega") << u"Žofie Ωmega"_s;
        QTest::newRow("line feed") << QByteArray("a\nb") << u"a\\x0ab"_s;
        QTest::newRow("escape sequence") << QByteArray("\x1b[31m") << u"\\x1b[31m"_s;
        QTest::newRow("no UTF-8") << QByteArray("a\xff"
                                                "b")
                                  << u"a\\xffb"_s;
        QTest::newRow("cut UTF-8") << QByteArray("\xc5") << u"\\xc5"_s;
        QTest::newRow("backslash") << QByteArray("a\\x0ab") << u"a\\x5cx0ab"_s;
        QTest::newRow("right to left") << QByteArray("\xe2\x80\xae") << u"\\xe2\\x80\\xae"_s;
    }
    void namesAreEscapedAndToldApart()
    {
        QFETCH(QByteArray, name);
        QFETCH(QString, shown);
        QCOMPARE(escapedName(name), shown);
        QCOMPARE(nameShownAs(shown), name);
        static const QRegularExpression plain(u"\\A[A-Za-z0-9_-]+\\z"_s);
        QVERIFY(plain.match(idOf(name)).hasMatch());
        QVERIFY(idOf(name) != idOf(name + 'x'));
        QVERIFY(idOf(name) != idOf(shown.toUtf8()) || shown.toUtf8() == name);
    }
};

PIXELPLUMB_TEST(TestGradeFiles)

} // namespace tst_gradefiles

#include "tst_gradefiles.moc"
