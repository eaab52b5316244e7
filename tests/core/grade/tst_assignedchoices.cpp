// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "core/grade/class/grader.h"
#include "core/grade/class/gradereports.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_assignedchoices {

using namespace pixelplumb;

namespace {

QByteArray assignmentWith(const QByteArray &more, const QByteArray &scene = {})
{
    return R"({ "pixelplumbAssignment": 1, "name": "One", )" + more + R"("scenes": [ {
        "name": "one", "scene": { "pixelplumb": 1, "frame": { "width": 24, "height": 20 }, )"
        + scene + R"("primitives": [ { "triangle": [[2, 3], [19, 5], [7, 17]],
                              "colors": ["#ff0000", "#00ff00", "#0000ff"] } ] } } ] })";
}

bool deliver(const QTemporaryDir &folder, const QString &file, const QByteArray &content)
{
    const QString path = folder.filePath(u"subs/"_s + file);
    return QDir().mkpath(QFileInfo(path).path()) && !writeFile(path, content);
}

GradedSubmission gradedBy(const Assignment &assignment, const QTemporaryDir &folder)
{
    Grader grader(assignment);
    const SubmissionEntry entry(QFile::encodeName(folder.filePath(u"subs"_s)), "ann");
    return grader.grade(entry)->submission;
}

/// The right picture of the assignment's scene, as read by a convention.
QByteArray pictureIn(const Assignment &assignment, FrameConvention convention)
{
    const Picture picture = pictureOf(sceneIn(assignment.scenes[0].scene, convention));
    QByteArray text = "P3\n" + QByteArray::number(picture.width) + ' '
        + QByteArray::number(picture.height) + "\n255\n";
    for (const Colour &colour : picture.colours) {
        for (const std::uint8_t level : colour.channels)
            text += QByteArray::number(int(level)) + ' ';
    }
    return text;
}

/// Draws by edge functions in whole numbers; `rule` is a test of a function in Python.
QByteArray programWith(const QByteArray &rule)
{
    return R"(import sys, json
s = json.load(sys.stdin)
w, h = s["frame"]["width"], s["frame"]["height"]
picture = [[(0, 0, 0)] * w for _ in range(h)]
def edge(p, q, x, y):
    return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])
for p in s["primitives"]:
    v = [[2 * float(c) for c in q] for q in p["triangle"]]
    c = [[int(c[i:i + 2], 16) for i in (1, 3, 5)] for c in p["colors"]]
    area = edge(v[0], v[1], v[2][0], v[2][1])
    for y in range(h):
        for x in range(w):
            e = [edge(v[(i + 1) % 3], v[(i + 2) % 3], 2 * x, 2 * y) / area for i in range(3)]
            if all(e[i] )"
        + rule + R"( for i in range(3)):
                picture[y][x] = [int(sum(e[i] * c[i][k] for i in range(3)) + 0.5) for k in range(3)]
print("P3", w, h, 255)
for row in picture[::-1]:
    print(*[level for pixel in row for level in pixel])
)";
}

} // namespace

/// What an assignment can ask for beside pictures, and points that a person gives.
class TestAssignedChoices : public QObject {
    Q_OBJECT

private slots:
    void theConventionIsTheSubmissions_data()
    {
        QTest::addColumn<FrameConvention>("convention");
        for (const FrameConvention convention : allFrameConventions)
            QTest::newRow(qPrintable(nameOf(convention))) << convention;
    }
    void theConventionIsTheSubmissions()
    {
        QFETCH(FrameConvention, convention);
        const bool isAsked = convention == FrameConvention::AsAsked;
        const auto any = readAssignment(assignmentWith(R"("convention": "any", )"));
        const QTemporaryDir folder;
        QVERIFY(deliver(folder, u"ann/one.ppm"_s, pictureIn(*any, convention)));
        const GradedSubmission graded = gradedBy(*any, folder);
        QCOMPARE(graded.verdict, GradeVerdict::Right);
        QCOMPARE(graded.points(), any->points());
        QCOMPARE(graded.convention.value_or(FrameConvention::AsAsked), convention);
        const QStringList told = sentencesFor(graded, HintLevel::Class);
        QCOMPARE(told.contains(sentenceOf(convention) + u"; judged by that convention"_s),
                 !isAsked);

        const auto asked = readAssignment(assignmentWith({}));
        QCOMPARE(gradedBy(*asked, folder).verdict,
                 isAsked ? GradeVerdict::Right : GradeVerdict::Wrong);
    }

    void theConventionIsFoundBesideWrongLevels()
    {
        const auto any = readAssignment(assignmentWith(R"("convention": "any", )"));
        Assignment truncated = *any;
        truncated.scenes[0].scene.settings.rounding = ByteRounding::Truncate;
        const QTemporaryDir folder;
        QVERIFY(
            deliver(folder, u"ann/one.ppm"_s, pictureIn(truncated, FrameConvention::OtherOrigin)));
        const GradedSubmission graded = gradedBy(*any, folder);
        QCOMPARE(graded.verdict, GradeVerdict::Wrong);
        QCOMPARE(graded.convention, std::optional(FrameConvention::OtherOrigin));
        QCOMPARE(graded.scenes.front().counts.count(Difference::Missing), 0);
        QVERIFY(graded.scenes.front().counts.count(Difference::Colour) > 80);
    }

    void aMistakeIsNoConvention()
    {
        const auto assignment = readAssignment(assignmentWith(R"("convention": "any", )"));
        QByteArray picture = pictureIn(*assignment, FrameConvention::AsAsked);
        picture.replace("255\n0 0 0 ", "255\n9 9 9 ");
        const QTemporaryDir folder;
        QVERIFY(deliver(folder, u"ann/one.ppm"_s, picture));
        const GradedSubmission graded = gradedBy(*assignment, folder);
        QCOMPARE(graded.verdict, GradeVerdict::Wrong);
        QVERIFY(!graded.convention);
    }

    void invariantsAreACheck_data()
    {
        QTest::addColumn<QByteArray>("rule");
        QTest::addColumn<QByteArray>("leeway");
        QTest::addColumn<bool>("isPassed");
        QTest::newRow("right") << QByteArray(">= 0") << QByteArray("strict") << true;
        QTest::newRow("another rule") << QByteArray("> 0") << QByteArray("rule") << true;
        QTest::newRow("the first weight alone")
            << QByteArray("> (0 if i else 0.2)") << QByteArray("rule") << false;
    }
    void invariantsAreACheck()
    {
        QFETCH(QByteArray, rule);
        QFETCH(QByteArray, leeway);
        QFETCH(bool, isPassed);
        QByteArray words = R"("program": {}, "points": { "invariants": 3 }, "leeway": "LEEWAY", )";
        const auto assignment = readAssignment(assignmentWith(words.replace("LEEWAY", leeway)));
        QVERIFY2(assignment.isOk(),
                 assignment.isOk() ? "" : qPrintable(assignment.error().message()));
        const QTemporaryDir folder;
        QVERIFY(deliver(folder, u"ann/main.py"_s, programWith(rule)));
        const GradedSubmission graded = gradedBy(*assignment, folder);
        const GradedCheck &check = graded.scenes[0].checks.back();
        QCOMPARE(check.check, Check::Invariants);
        QVERIFY2(check.isPassed == isPassed, qPrintable(graded.scenes[0].note.value_or(QString())));
        QCOMPARE(check.points, isPassed ? 3.0 : 0.0);
        QCOMPARE(graded.lostInvariants().isEmpty(), isPassed);
    }

    /// The assignment's triangle is drawn right, all others are not.
    void theVerdictNamesTheInvariantForWhichPointsAreLost_data()
    {
        QTest::addColumn<QByteArray>("rule");
        QTest::addColumn<QString>("lost");
        QTest::newRow("broken") << QByteArray(R"(>= (0 if [2, 3] in p["triangle"] or i else 0.2))")
                                << "breaks ";
        QTest::newRow("not drawn")
            << QByteArray(R"(>= (0 if [2, 3] in p["triangle"] else sys.exit(1)))")
            << "did not draw what invariants ask";
    }
    void theVerdictNamesTheInvariantForWhichPointsAreLost()
    {
        QFETCH(QByteArray, rule);
        QFETCH(QString, lost);
        const auto assignment = readAssignment(
            assignmentWith(R"("program": {}, "points": { "invariants": 3 }, "leeway": "rule", )"));
        const QTemporaryDir folder;
        QVERIFY(deliver(folder, u"ann/main.py"_s, programWith(rule)));
        const GradedSubmission ann = gradedBy(*assignment, folder);
        const GradeReport report{*assignment, {ann}};

        QCOMPARE(ann.verdict, GradeVerdict::Right);
        QVERIFY(ann.points() < assignment->points());
        const QString told = u"pictures right, "_s + lost;
        QVERIFY2(verdictText(ann).startsWith(told), qPrintable(verdictText(ann)));
        QVERIFY(clustersOf(report).front().title.startsWith(told));
        for (const QByteArray &table :
             {csvOf(report), junitOf(report), gradescopeOf(report), pageOf(report, {})})
            QVERIFY2(table.contains(lost.toUtf8()), table.constData());
        QVERIFY(
            !sentencesFor(ann, HintLevel::Full).join(u' ').contains(u"a raster has no colours"_s));
    }

    void invariantsNeedAProgram()
    {
        const auto assignment
            = readAssignment(assignmentWith(R"("points": { "invariants": 3 }, )"));
        QVERIFY(!assignment);
        QVERIFY(assignment.error().message().contains(u"no “program”"_s));
    }

    void pointsByHandStayWithTheirReason()
    {
        const auto assignment = readAssignment(assignmentWith({}));
        const QTemporaryDir folder;
        QVERIFY(deliver(folder, u"ann/one.txt"_s, "nothing"));
        const GradingOrder order{folder.filePath(u"subs"_s), folder.filePath(u"results"_s), u"1"_s};
        GradeReport report = **gradeFolder(order, *assignment);
        QCOMPARE(report.submissions[0].points(), 0.0);
        report.submissions[0].review.points = 2.5;
        report.submissions[0].review.reason = u"the file was renamed"_s;
        QVERIFY(!writeReviews(order.results, report));

        Assignment other = *assignment;
        other.margin.leeway = Leeway::Edges; // grades everybody anew
        const GradeReport again = **gradeFolder(order, other);
        const GradedSubmission &ann = again.submissions[0];
        QCOMPARE(ann.points(), 2.5);
        QCOMPARE(ann.pointsOfChecks(), 0.0);
        QCOMPARE(sentencesFor(ann, HintLevel::Class).back(),
                 u"2.5 points instead of 0: the file was renamed"_s);
        QVERIFY(csvOf(again).contains(",2.5,"));
        QVERIFY(csvOf(again).contains("the file was renamed"));
    }
};

PIXELPLUMB_TEST(TestAssignedChoices)

} // namespace tst_assignedchoices

#include "tst_assignedchoices.moc"
