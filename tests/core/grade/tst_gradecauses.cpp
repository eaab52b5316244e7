// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "core/grade/class/gradereports.h"
#include "tests/support/programs/submissions.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_gradecauses {

using namespace pixelplumb;

namespace {

GradedCandidate candidate(const QStringList &ids, std::int64_t distance = 0)
{
    return {ids, {u"Look."_s}, {u"Done."_s}, distance};
}

GradedSubmission wrong(const char *name, std::vector<GradedCandidate> candidates,
                       const char *pictures = nullptr)
{
    GradedSubmission graded;
    graded.name = graded.id = QString::fromLatin1(name);
    graded.verdict = GradeVerdict::Wrong;
    graded.differing = 100;
    graded.candidates = std::move(candidates);
    graded.pictures = QString::fromLatin1(pictures ? pictures : name);
    return graded;
}

QStringList clusterLines(const GradeReport &report)
{
    QStringList told;
    for (const GradeCluster &cluster : clustersOf(report))
        told += u"%1: %2"_s.arg(cluster.submissions.size()).arg(cluster.title);
    return told;
}

Scene computedIn(Scene scene, Arithmetic arithmetic)
{
    scene.settings.arithmetic = arithmetic;
    return scene;
}

/// What programs draw that compute in this arithmetic, one defect per scene.
bool deliverIn(Arithmetic arithmetic, const QString &folder, const Assignment &assignment,
               const QStringList &defects)
{
    bool isWritten = QDir().mkpath(folder);
    const std::vector<Defect> all = defectsOf(assignment);
    for (std::size_t i = 0; i < assignment.scenes.size(); ++i) {
        const QString id = defects[std::min(qsizetype(i), defects.size() - 1)];
        const auto defect = std::ranges::find(all, id, &Defect::id);
        if (defect == all.end())
            return false;
        const Scene scene = computedIn(assignment.scenes[i].scene, arithmetic);
        isWritten = isWritten
            && imageOf(pictureWith(scene, std::span(&*defect, 1)))
                   .save(u"%1/%2.png"_s.arg(folder, assignment.scenes[i].name));
    }
    return isWritten;
}

} // namespace

/// The causes of a class's mistakes, and what is reported about them.
class TestGradeCauses : public QObject {
    Q_OBJECT

private slots:
    void oneBugIsOneCauseWhateverItIsComputedIn()
    {
        const QTemporaryDir folder;
        const Assignment assignment = exampleAssignment();
        const QStringList bug{u"no-edge-pre-step"_s};
        for (const auto &[name, arithmetic] :
             {std::pair("exact", Arithmetic::Exact), std::pair("double", Arithmetic::Float64),
              std::pair("float", Arithmetic::Float32)})
            QVERIFY(deliverIn(arithmetic, folder.filePath(u"subs/"_s + QLatin1String(name)),
                              assignment, bug));
        const QStringList two{u"flat-first"_s, u"x-and-y-exchanged"_s};
        QVERIFY(deliverIn(Arithmetic::Float64, folder.filePath(u"subs/mixed"_s), assignment, two));
        const auto report = gradeFolder(
            {folder.filePath(u"subs"_s), folder.filePath(u"results"_s), u"1"_s, 1}, assignment);
        QVERIFY(report.isOk() && report->has_value());
        const std::vector<GradeCluster> clusters = clustersOf(**report);
        QCOMPARE(clusters.size(), 2U);
        QCOMPARE(clusters[0].submissions.size(), 3U);
        QVERIFY2(clusters[0].title.startsWith(bug.front()), qPrintable(clusters[0].title));
        QVERIFY2(!clusters[0].title.contains(u"arithmetic"_s), qPrintable(clusters[0].title));
        for (const GradedSubmission &each : (*report)->submissions) {
            const QString told = sentencesFor(each, HintLevel::Full).join(u'\n');
            QVERIFY2(!told.contains(u"computed in"_s), qPrintable(told));
        }

        const auto mixed
            = std::ranges::find((*report)->submissions, "mixed", &GradedSubmission::name);
        QVERIFY(!mixed->isExplained());
        QVERIFY(mixed->scenes[0].explanations->contains(two[0]));
        QVERIFY(mixed->scenes[1].explanations->contains(two[1]));
        const QString told = sentencesFor(*mixed, HintLevel::Full).join(u'\n');
        QVERIFY2(told.contains(mixed->scenes[1].scene
                               + u" taken alone is explained by x-and-y-exchanged"_s),
                 qPrintable(told));
        const auto read = readGrades(folder.filePath(u"results"_s));
        QVERIFY2(read.isOk(), read ? "" : qPrintable(read.error().message()));
        QVERIFY(read->submissions == (*report)->submissions);
    }

    void theSetsOfACauseExplainAllOfIt()
    {
        const GradedCandidate first = candidate({u"a"_s, u"b"_s});
        const GradedCandidate other = candidate({u"c"_s});
        GradeReport report;
        report.submissions = {wrong("ann", {first, other}), wrong("bob", {first})};
        QCOMPARE(clusterLines(report), QStringList{u"2: a and b"_s});
    }

    void identicalUnexplainedPicturesShareACause()
    {
        const std::vector<GradedCandidate> nearA{candidate({u"a"_s}, 10)};
        const std::vector<GradedCandidate> farA{candidate({u"a"_s}, 90)};
        GradeReport report;
        report.submissions
            = {wrong("ann", nearA),        wrong("bob", nearA),        wrong("cem", nearA),
               wrong("dea", {}, "copied"), wrong("eva", {}, "copied"), wrong("fay", farA)};
        QCOMPARE(clusterLines(report),
                 QStringList({u"3: no known defect, close to a"_s,
                              u"2: no known defect, the same pictures as dea"_s,
                              u"1: no known defect"_s}));
    }

    void whatExplainsLittleIsNotTold()
    {
        const auto told = [](std::int64_t distance) {
            return sentencesFor(wrong("ann", {candidate({u"a"_s}, distance)}), HintLevel::Full)
                .join(u'\n');
        };
        QVERIFY(told(1).contains(u"close to a, 1 pixel left"_s));
        QVERIFY(told(10).contains(u"Done."_s));
        QVERIFY(!told(11).contains(u"close to"_s));
        QVERIFY(!told(11).contains(u"Done."_s));
    }

    void whereNothingExplainsItWrongPixelsHaveTheirPlaces()
    {
        const auto told = [](std::vector<GradedCandidate> candidates) {
            GradedSubmission graded = wrong("ann", std::move(candidates));
            graded.scenes = {GradedScene()};
            graded.scenes[0].scene = u"probe"_s;
            graded.scenes[0].places = QStringList{u"1 pixel is missing: there"_s};
            return sentencesFor(graded, HintLevel::Full).join(u'\n');
        };
        QVERIFY(told({}).contains(u"probe: 1 pixel is missing: there"_s));
        QVERIFY(!told({candidate({u"a"_s})}).contains(u"there"_s));
    }

    /// In 16.16 alone a scene is explained; a pixel that no program would draw spoils another.
    void whatExplainsOneSceneIsTriedOnAll()
    {
        const QTemporaryDir folder;
        Assignment assignment = exampleAssignment();
        assignment.margin = {Leeway::Strict};
        const QString drawn = folder.filePath(u"subs/ann"_s);
        QVERIFY(deliverIn(Arithmetic::Fixed16, drawn, assignment, {u"unsorted-colours"_s}));
        const QString file = u"%1/%2.png"_s.arg(drawn, assignment.scenes.back().name);
        QImage spoiled(file);
        spoiled.setPixel(0, 0, qRgb(1, 2, 3));
        QVERIFY(spoiled.save(file));

        const auto report = gradeFolder(
            {folder.filePath(u"subs"_s), folder.filePath(u"results"_s), u"1"_s, 1}, assignment);

        QVERIFY(report.isOk() && report->has_value());
        const GradedSubmission &graded = (*report)->submissions.front();
        QVERIFY(!graded.candidates.empty());
        QCOMPARE(graded.candidates.front().distance, std::int64_t(1));
        QCOMPARE(graded.candidates.front().arithmetic, u"fixed16.16"_s);
        QVERIFY(graded.candidates.front().defects.contains(u"unsorted-colours"_s));
    }

    void aRasterIsRightAsFarAsItTells()
    {
        GradedSubmission raster = wrong("ann", {});
        raster.verdict = GradeVerdict::Right;
        GradedScene scene;
        scene.checks = {{Check::Coverage, true, 2, 2}, {Check::Colours, false, 0, 2}};
        raster.scenes = {scene};
        const QString told = u"right in coverage (a raster has no colours)"_s;

        QCOMPARE(verdictText(raster), "right in coverage");
        QCOMPARE(sentencesFor(raster, HintLevel::Hint), QStringList{told});
        GradeReport report;
        report.submissions = {raster};
        QCOMPARE(clusterLines(report), QStringList{u"1: "_s + told});
        QVERIFY(csvOf(report).contains("right in coverage"));
    }

    void undecidableSubmissionsHaveTheirOwnCauses()
    {
        const std::vector<GradedCandidate> sets{candidate({u"a"_s})};
        GradedSubmission open = wrong("ann", {});
        GradedSubmission openSet = wrong("bob", sets);
        GradedSubmission raster = wrong("cem", {});
        raster.scenes = {GradedScene()};
        raster.scenes[0].checks = {{Check::Colours, false, 0, 2}};
        open.verdict = openSet.verdict = raster.verdict = GradeVerdict::Undecidable;
        GradeReport report;
        report.submissions = {open, openSet, raster, wrong("dea", sets)};
        QCOMPARE(clusterLines(report),
                 QStringList(
                     {u"1: a"_s, u"1: full points: a right program may draw this"_s,
                      u"1: full points: a right program may draw this, as may one with a"_s,
                      u"1: undecidable in coverage (a raster has no colours): a right program may "
                      "draw this"_s}));
    }

    void whatIsNoMistakeAloneNamesNoCause()
    {
        GradedCandidate one = candidate({u"a"_s, u"choice"_s});
        one.rightAlone = QStringList{u"choice"_s};
        GradedCandidate other = candidate({u"a"_s, u"another"_s});
        other.rightAlone = QStringList{u"another"_s};
        GradeReport report;
        report.submissions = {wrong("ann", {one, other}), wrong("bob", {one})};
        QCOMPARE(clusterLines(report), QStringList{u"2: a"_s});
        const QString told = sentencesFor(report.submissions[1], HintLevel::Full).join(u'\n');
        QVERIFY2(told.contains(u"explained by a and choice"_s), qPrintable(told));
    }

    void aStudentIsToldOfMistakesAlone()
    {
        DiagnosisCandidate pair;
        pair.defects = {{u"a"_s, u"Look."_s, u"Done."_s}, {u"b"_s, u"Why so?"_s, u"So."_s}};
        pair.defects[1].isRightAlone = true;
        QCOMPARE(pair.sentences(&Defect::forStudent), QStringList{u"Look."_s});
        QCOMPARE(pair.sentences(&Defect::forAssistant), QStringList({u"Done."_s, u"So."_s}));
        QCOMPARE(pair.rightAlone(), QStringList{u"b"_s});
    }

    void whatHasNoPictureIsTogetherByTheReason()
    {
        const auto lacking = [](const std::optional<PictureLack> &lack, const char *end = nullptr) {
            GradedScene scene;
            scene.fault = u"it crashed: Aborted (signal 6)"_s;
            scene.lack = lack;
            if (end)
                scene.run = GradedRun{QString::fromLatin1(end), {}, {}};
            return scene;
        };
        const auto titleOf = [](GradeVerdict verdict, const std::vector<GradedScene> &scenes) {
            GradeReport report;
            report.submissions = {wrong("ann", {})};
            report.submissions[0].verdict = verdict;
            report.submissions[0].scenes = scenes;
            report.submissions[0].differing = 0;
            return clustersOf(report)[0].title;
        };
        const GradedScene crashed = lacking(PictureLack::NotDrawn, "crashed");
        const GradedScene hung = lacking(PictureLack::NotDrawn, "timed out");
        const GradedScene large = lacking(PictureLack::OtherSize, "finished");
        const auto nothing = GradeVerdict::Nothing;
        QCOMPARE(titleOf(nothing, {crashed, crashed}), "no picture: crashed");
        QCOMPARE(titleOf(nothing, {hung, crashed}), "no picture: crashed, timed out");
        QCOMPARE(titleOf(nothing, {large}), "no picture: of another size");
        QCOMPARE(titleOf(nothing, {lacking(PictureLack::Empty)}), "no picture: empty");
        QCOMPARE(titleOf(nothing, {lacking(PictureLack::NotDrawn)}), "no picture: not drawn");
        QCOMPARE(titleOf(nothing, {lacking(std::nullopt)}), "no picture");
        QCOMPARE(titleOf(GradeVerdict::Wrong, {GradedScene(), crashed}),
                 "not every scene has a picture: crashed");
    }

    void whatMayBeEitherWayIsTold()
    {
        GradedCandidate open = candidate({u"a"_s});
        open.undecidable = 1;
        const QString told = sentencesFor(wrong("ann", {open}), HintLevel::Full).join(u'\n');
        QVERIFY2(told.contains(u"explained by a, but for 1 pixel that rounding or a sample on an "
                               "edge may decide"_s),
                 qPrintable(told));
    }
};

PIXELPLUMB_TEST(TestGradeCauses)

} // namespace tst_gradecauses

#include "tst_gradecauses.moc"
